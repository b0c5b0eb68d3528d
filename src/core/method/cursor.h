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
/// What the polishing of step 6 remembers from pass to pass: triangles that were nearly poor when it began, and of this
/// pass the vertices and the worst figures of the mesh.
struct Polishing {
  std::vector<Slot> nearPoor;
  std::vector<Vertex> vertices;
  std::optional<Worst> worst;

  [[nodiscard]] auto parts() const { return std::tie(nearPoor, vertices, worst); }
};

/// All that every stage has is plain; what each has ahead of it is its own.
struct Cursor {
  bool begun = false;
  bool inside = false;  // in the middle of item `index`
  std::uint32_t phase = 0;
  std::uint64_t index = 0;
  std::uint64_t changes = 0;  // decisions of this stage that changed something
  std::variant<NothingAhead, CellsAhead, RankFront, BoundaryOrder, FrontTips, SlotsAhead, Polishing> ahead;

  /// What is ahead, as the stage keeps it; empty the first time that it asks.
  template <class Ahead>
  [[nodiscard]] Ahead& of() {
    if (Ahead* const known = std::get_if<Ahead>(&ahead)) return *known;
    return ahead.emplace<Ahead>();
  }
};

}  // namespace triscope
