// Where a stage is, between one decision and the next.
#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "core/base/point.h"
#include "core/mesh/ids.h"
#include "core/mesh/strain.h"
#include "core/optimise/cure.h"

namespace triscope {

// Each of the kinds below shows its parts to those who hash, or count the bytes of, any of them.

/// Of a stage that needs none of these.
struct NothingAhead {
  static std::tuple<> parts() { return {}; }
};
/// Cells of the quadtree that are still to be looked at, the next one last.
struct CellsAhead {
  std::vector<std::int32_t> cells;

  [[nodiscard]] auto parts() const { return std::tie(cells); }
};
/// The front of the density stage, in buckets by density rank: `first` of each rank is the entry to begin with, -1 for
/// none, and each entry names the one after it. A cell may wait in two buckets; in the one whose rank is no longer its
/// own it is passed over.
struct RankFront {
  struct Entry {
    std::int32_t cell = -1;
    std::int32_t next = -1;
  };
  std::vector<std::int32_t> first;
  std::vector<Entry> entries;

  [[nodiscard]] auto parts() const { return std::tie(first, entries); }
};
/// Points of the boundary in the order in which they are placed.
struct BoundaryOrder {
  std::vector<std::int32_t> points;

  [[nodiscard]] auto parts() const { return std::tie(points); }
};
/// The points of a front: where each is to go, the vertex it stands at, and the vertex that came of it, none when it
/// was refused.
struct FrontTips {
  std::vector<Point> places;
  std::vector<Vertex> owners;
  std::vector<Vertex> placed;

  [[nodiscard]] auto parts() const { return std::tie(places, owners, placed); }
};
/// Triangles that are still to be looked at, the next one last; for the carving, all of them in order.
struct SlotsAhead {
  std::vector<Slot> slots;

  [[nodiscard]] auto parts() const { return std::tie(slots); }
};
/// The advancing front of rows: triangles that are done, by slot the one that is; those beside the front, from
/// Cursor::index on in the order in which they came to be there; and what else is to be looked at.
struct RowsAhead {
  struct Waiting {
    Slot slot;
    TriangleId triangle;
  };
  Per<Slot, TriangleId> done;
  std::vector<Waiting> waiting;
  std::vector<Point> tiles;  // of the cell that is tiled, the next one last
  std::vector<Slot> slots;   // in the end: triangles that may be too large, the next one last

  [[nodiscard]] auto parts() const { return std::tie(done, waiting, tiles, slots); }
};
/// What the polishing of step 6 remembers from pass to pass: triangles that were nearly poor when it began, and of this
/// pass the vertices and the worst figures of the mesh.
struct Polishing {
  std::vector<Slot> nearPoor;
  std::vector<Vertex> vertices;
  std::optional<Worst> worst;

  [[nodiscard]] auto parts() const { return std::tie(nearPoor, vertices, worst); }
};

/// What the optimiser remembers from decision to decision.
struct Optimising {
  Per<Vertex, std::uint8_t> still;  // smoothing: passes that the vertex has hardly moved in, up to now
  Per<Vertex, std::int8_t> excess;  // annealing: triangles beyond those that suit the vertex best
  std::uint64_t changesBefore = 0;  // Cursor::changes when the pass began
  std::vector<Vertex> ahead;        // relaxation: vertices of this sweep, from Cursor::index on, and of the next
  std::vector<Vertex> next;
  Per<Vertex, std::uint8_t> waits;   // in `next`, or in `ahead` still
  Per<Vertex, std::uint8_t> visits;  // that the vertex has had
  std::vector<Slot> bad;             // cure: triangles to look at, from Cursor::index on
  Per<Slot, TriangleId> hopeless;    // by slot: the triangle that every edit was tried around in vain
  std::uint64_t tried = 0;           // edits, or pairs, around all triangles
  std::vector<CureEdit> edits;       // around the one at hand, and how far they have been tried
  CureProgress cure;

  [[nodiscard]] auto parts() const {
    return std::tie(still, excess, changesBefore, ahead, next, waits, visits, bad, hopeless, tried, edits, cure);
  }
};

/// All that every stage has is plain; what each has ahead of it is its own.
struct Cursor {
  bool begun = false;
  bool inside = false;  // in the middle of item `index`
  std::uint32_t phase = 0;
  std::uint64_t index = 0;
  std::uint64_t changes = 0;  // decisions of this stage that changed something
  // New kinds come last: saved sessions hold hashes, and the place of a kind is in them.
  std::variant<NothingAhead, CellsAhead, RankFront, BoundaryOrder, FrontTips, SlotsAhead, Polishing, RowsAhead,
               Optimising>
      ahead;

  /// What is ahead, as the stage keeps it; empty the first time that it asks.
  template <class Ahead>
  [[nodiscard]] Ahead& of() {
    if (Ahead* const known = std::get_if<Ahead>(&ahead)) return *known;
    return ahead.emplace<Ahead>();
  }
};

}  // namespace triscope
