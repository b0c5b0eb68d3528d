#include "core/optimise/glide.h"

#include <algorithm>
#include <array>

#include "core/geometry/trig.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr int kDepth = 3;          // flips in a sequence
constexpr int kMostFlips = 200;    // tried from one vertex
constexpr int kFewestAround = -2;  // excess of a vertex that may not lose a triangle: four are left around it
constexpr int kSmoothings = 6;
constexpr double kThinnest = 0.15;  // twice the area over the squared edge length wanted
constexpr int kSmoothedRings = 2;

class GlideSearch {
 public:
  GlideSearch(Workpiece& work, Excess& excess) : work_(work), excess_(excess) {}

  /// Flips that lower the sum, made on the links; their corners are in `corners`.
  bool from(Vertex vertex) {
    const std::array<Vertex, 1> front{vertex};
    return deepen(kDepth, front, {});
  }
  void undo(const EditMark& mark, std::size_t bumps) {
    undoEdits(work_.mesh, work_.room.log, mark);
    for (std::size_t k = bumps_.size(); k-- > bumps;) excess_[bumps_[k].vertex] -= bumps_[k].by;
    bumps_.resize(bumps);
  }
  void bump(const Mesh& mesh, Half half) {
    add(startOf(mesh, half), -1);
    add(endOf(mesh, half), -1);
    add(apexOf(mesh, half), 1);
    add(apexOf(mesh, oppositeOf(mesh, half)), 1);
  }

  [[nodiscard]] int lowered() const { return lowered_; }
  [[nodiscard]] int tried() const { return tried_; }
  std::vector<Vertex> corners;  // of the flips that lead to the smaller sum

 private:
  struct Bump {
    Vertex vertex;
    std::int8_t by;
  };

  void add(Vertex vertex, int by) {
    const auto step = static_cast<std::int8_t>(by);
    excess_[vertex] = static_cast<std::int8_t>(excess_[vertex] + step);
    bumps_.push_back({vertex, step});
  }

  // What a flip of the edge adds to the sum; too much where it may not be flipped.
  [[nodiscard]] int change(Half half) const {
    constexpr int kNever = 1000;
    const Mesh& mesh = work_.mesh;
    const Half across = oppositeOf(mesh, half);
    if (!across.exists() || constrained(mesh, half)) return kNever;
    return 4 - 2 * (excess_[startOf(mesh, half)] + excess_[endOf(mesh, half)] - excess_[apexOf(mesh, half)] -
                    excess_[apexOf(mesh, across)]);
  }

  [[nodiscard]] bool mayLose(Vertex vertex) const {
    return work_.mesh.vertexEdge[vertex].exists() || excess_[vertex] > kFewestAround;
  }

  // Edges of the triangles around the front that may be flipped without raising the sum, those that lower it first.
  void collect(std::span<const Vertex> front, EdgeEnds last, std::vector<EdgeEnds>& found) {
    const Mesh& mesh = work_.mesh;
    Ring& ring = work_.room.ring;
    std::vector<EdgeEnds> level;
    for (const Vertex v : front) {
      if (!gatherLinks(mesh, v, ring)) continue;
      for (const Half rim : ring.rims()) {
        for (const Half half : {rim, halfOf(triangleOf(rim), prev3(cornerOf(rim)))}) {
          const int by = change(half);
          if (by > 0) continue;
          const EdgeEnds edge = endsOf(startOf(mesh, half), endOf(mesh, half));
          std::vector<EdgeEnds>& list = by < 0 ? found : level;
          if (edge != last && std::ranges::find(list, edge) == list.end()) list.push_back(edge);
        }
      }
    }
    found.insert(found.end(), level.begin(), level.end());
  }

  bool deepen(int depth, std::span<const Vertex> front, EdgeEnds last) {
    Mesh& mesh = work_.mesh;
    std::vector<EdgeEnds> edges;
    collect(front, last, edges);
    for (const EdgeEnds& edge : edges) {
      if (++tried_ > kMostFlips) return false;
      const Half half = edgeBetween(mesh, edge.a, edge.b);
      const int by = half.exists() ? change(half) : 1;
      if (by > 0 || !mayLose(edge.a) || !mayLose(edge.b)) continue;
      const Vertex c = apexOf(mesh, half), d = apexOf(mesh, oppositeOf(mesh, half));
      if (c == d || edgeBetween(mesh, c, d).exists()) continue;
      const EditMark mark = markOf(mesh, work_.room.log);
      const std::size_t bumps = bumps_.size();
      bump(mesh, half);
      flipEdge(mesh, half, work_.room.log);
      const std::array<Vertex, 4> next{edge.a, edge.b, c, d};
      if (by < 0)
        lowered_ = by;
      else if (depth == 1 || !deepen(depth - 1, next, endsOf(c, d))) {
        undo(mark, bumps);
        continue;
      }
      corners.insert(corners.end(), next.begin(), next.end());
      return true;
    }
    return false;
  }

  Workpiece& work_;
  Excess& excess_;
  std::vector<Bump> bumps_;
  int tried_ = 0;
  int lowered_ = 0;
};

int sumOver(const Excess& excess, std::span<const Vertex> vertices) {
  int sum = 0;
  for (const Vertex v : vertices) sum += squared(excess[v]);
  return sum;
}

// Each to the mean of its neighbours, in turn. False when a triangle is thin or turned over in the end.
bool smoothPatch(Workpiece& work, std::span<const Vertex> vertices) {
  Mesh& mesh = work.mesh;
  Ring& ring = work.room.ring;
  for (const Vertex v : vertices) save(mesh, v, work.room.log);
  for (int turn = 0; turn < kSmoothings; ++turn) {
    for (const Vertex v : vertices) {
      if (mesh.vertexEdge[v].exists() || !gatherLinks(mesh, v, ring)) continue;
      Point sum;
      for (const Vertex other : ring.neighbours()) sum = sum + pointOf(mesh, other);
      mesh.points[v] = (1.0 / ring.count) * sum;
    }
  }
  for (const Vertex v : vertices) {
    if (!gatherLinks(mesh, v, ring)) return false;
    const double floor = kThinnest * work.sizes[v] * work.sizes[v];
    for (const Half rim : ring.rims()) {
      const Slot slot = triangleOf(rim);
      if (!(twiceArea(mesh, slot) > floor)) return false;
      noteTouched(mesh, slot);
    }
  }
  return true;
}

}  // namespace

int excessOf(const Mesh& mesh, Vertex vertex) {
  Ring ring;
  if (!gatherLinks(mesh, vertex, ring)) return 0;
  if (ring.closed) return ring.count - 6;
  const Point hub = pointOf(mesh, vertex);
  const Point first = pointOf(mesh, ring.vertices[0]) - hub;
  double angle = trig::angleBetween(first, pointOf(mesh, ring.vertices[static_cast<std::size_t>(ring.count)]) - hub);
  if (angle <= 0.0) angle += 2.0 * trig::kPi;
  constexpr double kHalf = 0.5 + 1e-6;  // of a right angle two triangles: one would have it
  return ring.count - std::max(1, static_cast<int>(angle / (60.0 * trig::kDegree) + kHalf));
}

Excess excessOf(const Mesh& mesh) {
  Excess excess(mesh.points.size(), 0);
  for (const Vertex v : mesh.points.keys())
    excess[v] = static_cast<std::int8_t>(std::clamp(excessOf(mesh, v), -100, 100));
  return excess;
}

Glide glideFrom(Workpiece& work, Excess& excess, Vertex vertex) {
  OptimiserRoom& room = work.room;
  beginEdits(room.log);
  const EditMark start = markOf(work.mesh, room.log);
  GlideSearch search(work, excess);
  Glide glide;
  const bool found = search.from(vertex);
  glide.searched = search.tried();
  if (!found) return glide;
  const std::size_t smoothed = verticesAround(work, search.corners, kSmoothedRings + 1, room.patch);
  const int sum = sumOver(excess, room.patch);
  glide.sumBefore = sum - search.lowered();
  glide.outcome = GlideOutcome::undone;
  if (smoothPatch(work, std::span(room.patch).first(smoothed))) {
    for (std::size_t k = 0; k < smoothed; ++k) suspectStar(work, room.patch[k]);
    flipSuspects(work, [&](Half half) { search.bump(work.mesh, half); });
    glide.sumAfter = sumOver(excess, room.patch);
    if (glide.sumAfter <= sum) glide.outcome = GlideOutcome::kept;
  }
  if (glide.outcome == GlideOutcome::undone) search.undo(start, 0);
  return glide;
}

}  // namespace triscope
