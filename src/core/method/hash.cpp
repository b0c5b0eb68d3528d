// A digest of a state, to compare runs by.
#include <optional>
#include <variant>
#include <vector>

#include "core/base/digest.h"
#include "core/method/state.h"

namespace triscope {
namespace {

void add(Digest& digest, const Mesh& mesh) {
  digest.points(mesh.points);
  digest.integers(mesh.kinds);
  digest.integers(mesh.density);
  digest.integers(mesh.vertexTriangle);
  digest.integers(mesh.vertexEdge);
  digest.word(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      digest.word(static_cast<std::uint64_t>(t.v[i].n) << 32 ^ t.adj[i].word());
    }
  }
  digest.integers(mesh.ids);
  digest.integers(mesh.flags);
  digest.integers(mesh.tested);
  digest.integers(mesh.freeSlots);
  for (const BoundaryEdge& e : mesh.edges) {
    digest.word(static_cast<std::uint64_t>(e.v0.n) << 32 ^ static_cast<std::uint64_t>(e.v1.n));
    digest.word(e.curve);
    digest.number(e.t0);
    digest.number(e.t1);
  }
  digest.word(mesh.nextId.n);
  digest.word(static_cast<std::uint64_t>(mesh.lastTriangle.n));
}

void add(Digest& digest, const std::vector<Constraint>& constraints) {
  for (const Constraint& c : constraints) {
    digest.point(c.at);
    digest.number(c.length);
    digest.word(static_cast<std::uint64_t>(c.source) << 32 ^ c.curve);
  }
}

// The boundary's tree follows from the domain.
void add(Digest& digest, const ConstraintSearch& search) {
  if (search.part == ConstraintSearch::Part::over) return;
  digest.word(static_cast<std::uint64_t>(search.part) << 32 ^ search.index);
  digest.word(static_cast<std::uint64_t>(search.curve) << 32 ^ search.sample);
  digest.number(search.along);
  digest.word(search.backwards ? 1 : 0);
  add(digest, search.found);
}

// What a stage has ahead of it, part by part.
struct AddPart {
  Digest& digest;

  void operator()(const std::vector<Point>& places) const { digest.points(places); }
  template <class T>
  void operator()(const std::vector<T>& list) const {
    digest.integers(list);
  }
  void operator()(const std::vector<RankFront::Entry>& entries) const {
    digest.word(entries.size());
    for (const RankFront::Entry& entry : entries)
      digest.word(static_cast<std::uint64_t>(entry.cell) << 32 ^ static_cast<std::uint32_t>(entry.next));
  }
  void operator()(const std::vector<RowsAhead::Waiting>& waiting) const {
    digest.word(waiting.size());
    for (const RowsAhead::Waiting& one : waiting)
      digest.word(static_cast<std::uint64_t>(one.slot.n) << 32 ^ one.triangle.word());
  }
  void operator()(const std::vector<CureEdit>& edits) const {
    digest.word(edits.size());
    for (const CureEdit& edit : edits) {
      digest.word(static_cast<std::uint64_t>(edit.a.n) << 32 ^ edit.b.word());
      digest.word(static_cast<std::uint64_t>(edit.kind) << 32 ^ static_cast<std::uint32_t>(edit.gain));
    }
  }
  void operator()(std::uint64_t number) const { digest.word(number); }
  void operator()(const CureProgress& cure) const {
    digest.word(static_cast<std::uint64_t>(cure.first) << 32 ^ cure.second);
    digest.word(static_cast<std::uint64_t>(cure.tried) << 32 ^ cure.firsts);
    digest.word(static_cast<std::uint64_t>(cure.bestFirst) << 32 ^ cure.bestSecond);
    digest.word(static_cast<std::uint64_t>(cure.any) << 32 ^ cure.patient.word());
    digest.numbers({cure.before, cure.best});
  }
  void operator()(const std::optional<Worst>& worst) const {
    digest.word(worst ? 1 : 0);
    if (worst) digest.numbers({worst->aspect, worst->areaRatio, worst->edgeRatio, worst->radius});
  }
};

void add(Digest& digest, const Cursor& cursor) {
  digest.word(static_cast<std::uint64_t>(cursor.begun) << 32 ^ static_cast<std::uint64_t>(cursor.inside) << 33 ^
              cursor.phase);
  digest.word(cursor.index);
  digest.word(cursor.changes);
  digest.word(cursor.ahead.index());
  std::visit([add = AddPart{digest}](
                 const auto& ahead) { std::apply([&](const auto&... part) { (add(part), ...); }, ahead.parts()); },
             cursor.ahead);
  // Three lists, all empty where a stage begins or has ended, were once what any stage had: saved sessions hold hashes.
  digest.word(0);
  digest.word(0);
}

}  // namespace

std::uint64_t hashOf(const MeshState& state) {
  Digest digest;
  digest.number(state.minEdge);
  add(digest, state.search);
  add(digest, state.constraints);
  for (const Cell& c : state.tree.cells) {
    digest.word(static_cast<std::uint64_t>(c.child) << 32 ^ c.x);
    digest.word(static_cast<std::uint64_t>(c.y) << 32 ^ static_cast<std::uint64_t>(c.rank) << 24 ^
                static_cast<std::uint64_t>(c.density) << 16 ^ static_cast<std::uint64_t>(c.type) << 8 ^ c.visited);
  }
  digest.number(state.estimatedTriangles);
  for (const BoundaryPoint& p : state.boundary) {
    digest.point(p.at);
    digest.number(p.t);
    digest.word(static_cast<std::uint64_t>(p.curve) << 32 ^ p.vertex.word());
  }
  add(digest, state.mesh);
  if (!state.sizes.empty()) digest.numbers(state.sizes);
  digest.integers(state.front1);
  digest.integers(state.front2);
  digest.integers(state.frontLoops);
  digest.word(static_cast<std::uint64_t>(infoOf(state.stage).code) << 32 ^ state.round);
  digest.word(state.roundChanges);
  digest.word(static_cast<std::uint64_t>(state.roundsDone) << 32 ^ state.passesDone);
  add(digest, state.cursor);
  digest.word(state.tick);
  digest.word(state.failed ? 1 : 0);
  return digest.value;
}

}  // namespace triscope
