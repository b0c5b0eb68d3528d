#include "core/mesh/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/index_text.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/embedding.h"

namespace triscope {
namespace {

class Checker {
 public:
  Checker(const Mesh& mesh, std::size_t limit) : mesh_(mesh), limit_(limit) {}

  std::vector<Violation> run() {
    if (!checkArrays()) return std::move(found_);  // nothing else can be looked at
    checkLinks();
    const bool linked = found_.empty();
    checkIds();
    checkOrientation();
    checkBorders();
    checkLists();
    checkBoundaryEdges();
    checkVertices(linked);
    checkDuplicates();
    checkOverlap();
    checkDelaunay();  // last: of a mesh that is not Delaunay there may be much to say
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool full() const { return found_.size() >= limit_; }
  void add(Broken what, Slot triangle, Vertex vertex, std::optional<Point> place, std::string message) {
    if (!full()) found_.push_back({what, triangle, vertex, place, std::move(message)});
  }
  void addTriangle(Broken what, Slot slot, const std::string& message) {
    const auto& v = triangleAt(mesh_, slot).v;
    Point centre;
    for (const Vertex corner : v) {
      if (isVertex(corner)) centre = centre + (1.0 / 3.0) * pointOf(mesh_, corner);
    }
    add(what, slot, {}, centre, fmt::format("triangle {}: {}", idOf(mesh_, slot), message));
  }
  void addEdge(Broken what, Half half, const std::string& message) {
    const Vertex a = startOf(mesh_, half), b = endOf(mesh_, half);
    add(what, triangleOf(half), a, midpoint(pointOf(mesh_, a), pointOf(mesh_, b)),
        fmt::format("edge {}-{} of triangle {}: {}", a, b, idOf(mesh_, triangleOf(half)), message));
  }
  void addVertex(Broken what, Vertex vertex, const std::string& message) {
    add(what, mesh_.vertexTriangle[vertex], vertex, pointOf(mesh_, vertex),
        fmt::format("vertex {}: {}", vertex, message));
  }

  [[nodiscard]] bool isVertex(Vertex v) const { return mesh_.points.has(v); }
  [[nodiscard]] bool isLive(Slot slot) const { return mesh_.triangles.has(slot) && mesh_.alive(slot); }
  /// Calls f(slot) for every live triangle until enough violations are found.
  template <class F>
  void forEachTriangle(F f) {
    for (const Slot slot : mesh_.triangles.keys()) {
      if (full()) return;
      if (mesh_.alive(slot)) f(slot);
    }
  }
  template <class F>
  void forEachHalfEdge(F f) {
    forEachTriangle([&](Slot slot) {
      for (int i = 0; i < 3; ++i) f(halfOf(slot, i));
    });
  }

  /// Parallel arrays are equally long and every corner is a vertex.
  bool checkArrays() {
    const std::size_t vertices = mesh_.points.size(), slots = mesh_.triangles.size();
    if (mesh_.kinds.size() != vertices || mesh_.density.size() != vertices || mesh_.vertexTriangle.size() != vertices ||
        mesh_.vertexEdge.size() != vertices || mesh_.ids.size() != slots || mesh_.flags.size() != slots) {
      add(Broken::link, {}, {}, {}, "the arrays of vertices or triangles have different lengths");
      return false;
    }
    std::size_t dead = 0;
    for (const std::uint8_t flags : mesh_.flags) dead += (flags & kDead) != 0 ? 1u : 0u;
    if (dead != mesh_.freeSlots.size()) {
      add(Broken::link, {}, {}, {},
          fmt::format("{} slots are dead but {} are listed as free", dead, mesh_.freeSlots.size()));
    }
    bool sound = true;
    forEachTriangle([&](Slot slot) {
      const auto& v = triangleAt(mesh_, slot).v;
      for (const Vertex corner : v) {
        if (isVertex(corner)) continue;
        sound = false;
        addTriangle(Broken::link, slot, fmt::format("corner {} is no vertex", corner));
      }
      if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        sound = false;
        addTriangle(Broken::link, slot, fmt::format("corners {}, {}, {} are not three vertices", v[0], v[1], v[2]));
      }
    });
    return sound;
  }

  /// The other half of `half` when the two agree that they are one edge, none otherwise.
  [[nodiscard]] Half partnerOf(Half half) const {
    const Half other = oppositeOf(mesh_, half);
    if (!other.exists() || !isLive(triangleOf(other)) || oppositeOf(mesh_, other) != half) return {};
    return startOf(mesh_, other) == endOf(mesh_, half) && endOf(mesh_, other) == startOf(mesh_, half) ? other : Half();
  }

  void checkLinks() {
    forEachHalfEdge([&](Half half) {
      const Half other = oppositeOf(mesh_, half);
      if (other == Half()) return;
      if (!other.exists() || !isLive(triangleOf(other))) {
        addEdge(Broken::link, half, fmt::format("its neighbour {} is no live triangle", other));
      } else if (oppositeOf(mesh_, other) != half) {
        addEdge(Broken::link, half, fmt::format("triangle {} does not point back", idOf(mesh_, triangleOf(other))));
      } else if (!partnerOf(half).exists()) {
        addEdge(Broken::link, half,
                fmt::format("triangle {} shares edge {}-{} instead", idOf(mesh_, triangleOf(other)),
                            startOf(mesh_, other), endOf(mesh_, other)));
      } else if (half < other && constrained(mesh_, half) != constrained(mesh_, other)) {
        addEdge(Broken::link, half, "constrained on one side only");
      }
    });
  }

  void checkIds() {
    std::vector<std::pair<TriangleId, Slot>> ids;
    ids.reserve(mesh_.triangles.size());
    forEachTriangle([&](Slot slot) {
      ids.emplace_back(idOf(mesh_, slot), slot);
      if (idOf(mesh_, slot) >= mesh_.nextId) {
        addTriangle(Broken::link, slot, fmt::format("its id is not below the next one, {}", mesh_.nextId));
      }
    });
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 1; i < ids.size(); ++i) {
      if (ids[i].first == ids[i - 1].first) {
        addTriangle(Broken::link, ids[i].second, fmt::format("slot {} has the same id", ids[i - 1].second));
      }
    }
  }

  void checkOrientation() {
    forEachTriangle([&](Slot slot) {
      const auto& v = triangleAt(mesh_, slot).v;
      const int sign = orient2d(pointOf(mesh_, v[0]), pointOf(mesh_, v[1]), pointOf(mesh_, v[2]));
      if (sign < 0) addTriangle(Broken::orientation, slot, "runs clockwise");
      if (sign == 0) addTriangle(Broken::orientation, slot, "its corners lie on one line");
    });
  }

  void checkDelaunay() {
    forEachHalfEdge([&](Half half) {
      const Half other = partnerOf(half);
      if (other < half || constrained(mesh_, half)) return;
      const auto& v = triangleAt(mesh_, triangleOf(half)).v;
      const Vertex apex = apexOf(mesh_, other);
      if (incircle(pointOf(mesh_, v[0]), pointOf(mesh_, v[1]), pointOf(mesh_, v[2]), pointOf(mesh_, apex)) > 0) {
        addEdge(Broken::delaunay, half, fmt::format("vertex {} across it lies inside the circumcircle", apex));
      }
    });
  }

  /// Where the mesh ends there is a boundary edge, and what is flagged as constrained is one.
  void checkBorders() {
    forEachHalfEdge([&](Half half) {
      const Vertex a = startOf(mesh_, half), b = endOf(mesh_, half);
      const bool border = oppositeOf(mesh_, half) == Half();
      const bool ofTheBox = mesh_.kinds[a] == VertexKind::helper && mesh_.kinds[b] == VertexKind::helper;
      if (border && !constrained(mesh_, half) && !ofTheBox) {
        addEdge(Broken::boundary, half, "the mesh ends here, but the edge is not flagged as a boundary edge");
      } else if (constrained(mesh_, half) && !listed(a, b).exists()) {
        addEdge(Broken::boundary, half, "flagged as a boundary edge, but the boundary has no such edge");
      }
    });
  }

  /// Index of the boundary edge between a and b in the list of a, none when it is not there or the list is broken.
  [[nodiscard]] EdgeId listed(Vertex a, Vertex b) const {
    EdgeId e = mesh_.vertexEdge[a];
    for (std::size_t steps = 0; mesh_.edges.has(e) && steps < mesh_.edges.size(); ++steps) {
      const BoundaryEdge& edge = mesh_.edges[e];
      if (edge.v0 != a && edge.v1 != a) return {};
      if ((edge.v0 == a && edge.v1 == b) || (edge.v0 == b && edge.v1 == a)) return e;
      e = edge.v0 == a ? edge.next0 : edge.next1;
    }
    return {};
  }

  /// The lists of all vertices together hold every boundary edge twice; one that runs in a circle holds more.
  void checkLists() {
    std::size_t budget = 2 * mesh_.edges.size();
    for (const Vertex v : mesh_.points.keys()) {
      if (full()) return;
      EdgeId e = mesh_.vertexEdge[v];
      while (e != EdgeId()) {
        const bool known = mesh_.edges.has(e);
        if (!known || budget == 0 || (mesh_.edges[e].v0 != v && mesh_.edges[e].v1 != v)) {
          addVertex(Broken::boundary, v, "its list of boundary edges holds one of another vertex or runs in a circle");
          if (budget == 0) return;
          break;
        }
        --budget;
        e = mesh_.edges[e].v0 == v ? mesh_.edges[e].next0 : mesh_.edges[e].next1;
      }
    }
  }

  void checkBoundaryEdges() {
    std::vector<std::pair<Vertex, Vertex>> present;  // constrained edges, lower vertex first
    forEachHalfEdge([&](Half half) {
      if (constrained(mesh_, half)) present.push_back(std::minmax(startOf(mesh_, half), endOf(mesh_, half)));
    });
    std::sort(present.begin(), present.end());
    std::vector<std::pair<Vertex, Vertex>> seen;
    for (const EdgeId e : mesh_.edges.keys()) {
      if (full()) return;
      const BoundaryEdge& edge = mesh_.edges[e];
      if (!exists(edge) && !edge.v1.exists()) continue;  // merged into another
      if (!isVertex(edge.v0) || !isVertex(edge.v1) || edge.v0 == edge.v1) {
        add(Broken::boundary, {}, {}, {},
            fmt::format("boundary edge {}: {}-{} are not two vertices", e, edge.v0, edge.v1));
        continue;
      }
      const auto report = [&](const std::string& message) {
        add(Broken::boundary, {}, edge.v0, midpoint(pointOf(mesh_, edge.v0), pointOf(mesh_, edge.v1)),
            fmt::format("boundary edge {} ({}-{}): {}", e, edge.v0, edge.v1, message));
      };
      const std::pair<Vertex, Vertex> key = std::minmax(edge.v0, edge.v1);
      if (!std::binary_search(present.begin(), present.end(), key)) report("no constrained edge of the mesh");
      for (const auto& [a, b] : {std::pair{edge.v0, edge.v1}, std::pair{edge.v1, edge.v0}}) {
        if (!listed(a, b).exists()) report(fmt::format("missing from the list of vertex {}", a));
      }
      seen.push_back(key);
    }
    std::sort(seen.begin(), seen.end());
    for (auto twin = std::adjacent_find(seen.begin(), seen.end()); twin != seen.end() && !full();
         twin = std::adjacent_find(twin + 1, seen.end())) {
      add(Broken::boundary, {}, twin->first, pointOf(mesh_, twin->first),
          fmt::format("boundary edge {}-{} is there twice", twin->first, twin->second));
    }
  }

  /// Triangles met when turning about a vertex from its triangle, first one way, then at a border the other.
  [[nodiscard]] std::size_t fanSize(Vertex vertex) const {
    const Slot first = mesh_.vertexTriangle[vertex];
    std::size_t count = 0;
    for (const bool forward : {true, false}) {
      Slot slot = first;
      do {
        const auto& v = triangleAt(mesh_, slot).v;
        const int corner = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
        count += forward || slot != first ? 1u : 0u;
        const Half across = triangleAt(mesh_, slot).adj[forward ? next3(corner) : prev3(corner)];
        if (across == Half()) break;
        slot = triangleOf(across);
        if (slot == first && forward) return count;
      } while (count <= 3 * mesh_.triangles.size());
    }
    return count;
  }

  void checkVertices(bool linked) {
    Per<Vertex, std::uint32_t> uses(mesh_.points.size(), 0);
    forEachTriangle([&](Slot slot) {
      for (const Vertex corner : triangleAt(mesh_, slot).v) ++uses[corner];
    });
    for (const Vertex v : mesh_.points.keys()) {
      if (full()) return;
      const VertexKind kind = mesh_.kinds[v];
      const Slot slot = mesh_.vertexTriangle[v];
      if (uses[v] == 0) {
        if (kind != VertexKind::removed && kind != VertexKind::helper)
          addVertex(Broken::vertex, v, "no triangle uses it");
        continue;
      }
      if (kind == VertexKind::removed) addVertex(Broken::vertex, v, "removed, but a triangle uses it");
      const bool around = isLive(slot) && std::ranges::count(triangleAt(mesh_, slot).v, v) == 1;
      if (!around) {
        addVertex(Broken::vertex, v, fmt::format("its triangle, slot {}, is not one around it", slot));
      } else if (linked && fanSize(v) != uses[v]) {
        addVertex(Broken::vertex, v, "its triangles do not form one fan: parts of the mesh meet only in this point");
      }
    }
    used_ = std::move(uses);
  }

  void checkDuplicates() {
    std::vector<Vertex> order;
    for (const Vertex v : used_.keys()) {
      if (used_[v] != 0) order.push_back(v);
    }
    const auto key = [&](Vertex v) {
      const Point p = pointOf(mesh_, v);
      return std::tuple(p.x, p.y, v);
    };
    std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < order.size() && !full(); ++i) {
      if (pointOf(mesh_, order[i]) == pointOf(mesh_, order[i - 1])) {
        addVertex(Broken::duplicate, order[i], fmt::format("at the same place as vertex {}", order[i - 1]));
      }
    }
  }

  /// Borders tell of overlaps only where each triangle lies rightly beside its neighbours.
  void checkOverlap() {
    if (!found_.empty()) return;
    if (auto overlap = findOverlap(mesh_)) found_.push_back(std::move(*overlap));
  }

  const Mesh& mesh_;
  std::size_t limit_;
  std::vector<Violation> found_;
  Per<Vertex, std::uint32_t> used_;  // triangles around it
};

}  // namespace

std::vector<Violation> validate(const Mesh& mesh, std::size_t limit) { return Checker(mesh, limit).run(); }

}  // namespace triscope
