#include "core/optimise/cure.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/geometry/trig.h"
#include "core/mesh/collapse_edge.h"
#include "core/mesh/edit.h"
#include "core/mesh/slide.h"
#include "core/mesh/split_edge.h"
#include "core/optimise/glide.h"
#include "core/optimise/relax.h"

namespace triscope {
namespace {

constexpr int kVisitsAfterEdit = 400;     // steps of relaxation after an edit
constexpr double kShortToSplit = 0.85;    // edges below this are not split, in edge lengths wanted
constexpr double kShortBorder = 0.8;      // the same of the boundary
constexpr double kLongToMerge = 1.15;     // edges above this are not merged
constexpr double kThinnestMerged = 1e-3;  // twice the area of a triangle that merging leaves, in squares of that length
constexpr double kConvex = 0.05;          // of a quadrilateral's area: its corners at an edge that is flipped
constexpr double kBeyondWeight = 100.0;

bool isInner(const Mesh& mesh, Vertex vertex) { return !mesh.vertexEdge[vertex].exists(); }

bool isConvex(const Mesh& mesh, Half half) {
  const Half across = oppositeOf(mesh, half);
  const Point a = pointOf(mesh, startOf(mesh, half)), b = pointOf(mesh, endOf(mesh, half));
  const Point c = pointOf(mesh, apexOf(mesh, half)), d = pointOf(mesh, apexOf(mesh, across));
  const double least = kConvex * (twiceArea(mesh, triangleOf(half)) + twiceArea(mesh, triangleOf(across)));
  return cross(a - c, d - c) > least && cross(b - d, c - d) > least;
}

// Whether the triangles around `vertex`, but for those that have `other` too, keep an area with it at p.
bool keepsArea(Workpiece& work, Vertex vertex, Vertex other, Point p, double floor) {
  Ring& ring = work.room.ring;
  if (!gatherRing(work.mesh, work.sizes, vertex, ring)) return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) {
    if (ring.vertices[k] == other || ring.vertices[k + 1] == other) continue;
    if (!(fanArea(ring, static_cast<int>(k), p) > floor)) return false;
  }
  return true;
}

bool flip(Workpiece& work, Half half) {
  Mesh& mesh = work.mesh;
  const Half across = oppositeOf(mesh, half);
  if (!across.exists() || constrained(mesh, half) || !isConvex(mesh, half)) return false;
  for (const Vertex v : {startOf(mesh, half), endOf(mesh, half), apexOf(mesh, half), apexOf(mesh, across)})
    work.room.touched.push_back(v);
  flipEdge(mesh, half, work.room.log);
  return true;
}

bool merge(Workpiece& work, Vertex gone, Vertex stays) {
  Mesh& mesh = work.mesh;
  const bool bothInner = isInner(mesh, gone) && isInner(mesh, stays);
  const Point to = bothInner ? midpoint(pointOf(mesh, gone), pointOf(mesh, stays)) : pointOf(mesh, stays);
  const double floor = kThinnestMerged * squared(work.sizes[stays]);
  if (!keepsArea(work, gone, stays, to, floor)) return false;
  if (bothInner && !keepsArea(work, stays, gone, to, floor)) return false;
  if (!collapseEdge(mesh, gone, stays, work.room.log)) return false;
  if (bothInner) {
    movePoint(mesh, stays, to, work.room.log);
    if (gatherLinks(mesh, stays, work.room.ring)) noteRing(mesh, work.room.ring);
  }
  work.room.touched.push_back(stays);
  return true;
}

// Whether both triangles between the edge's ends, its apex and a point in its place would be counter-clockwise.
bool sees(const Mesh& mesh, Half half, Point p) {
  const Point a = pointOf(mesh, startOf(mesh, half)), b = pointOf(mesh, endOf(mesh, half));
  const Point apex = pointOf(mesh, apexOf(mesh, half));
  return cross(p - a, apex - a) > 0.0 && cross(apex - b, p - b) > 0.0;
}

bool split(Workpiece& work, Half half) {
  Mesh& mesh = work.mesh;
  const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
  const std::uint8_t density = std::min(mesh.density[a], mesh.density[b]);
  Vertex middle;
  if (!constrained(mesh, half)) {
    middle = splitInnerEdge(mesh, half, midpoint(pointOf(mesh, a), pointOf(mesh, b)), density, work.room.log);
  } else {
    const EdgeId edge = findBoundaryEdge(mesh, a, b);
    const BoundaryEdge& old = mesh.edges[edge];
    const double t = 0.5 * (old.t0 + old.t1);
    const Point at = pointAt(work.curves[old.curve], t);
    for (const Half side : {half, oppositeOf(mesh, half)})
      if (side.exists() && !sees(mesh, side, at)) return false;
    middle = splitBorderEdge(mesh, half, edge, t, at, density, work.room.log);
  }
  work.sizes.push_back(0.5 * (work.sizes[a] + work.sizes[b]));
  work.room.touched.push_back(middle);
  return true;
}

// Of the domain, between two of its edges that follow one another around a vertex; 2π where there are none.
double sharpestAngleAt(const Mesh& mesh, Vertex vertex) {
  Ring ring;
  double sharpest = 2.0 * trig::kPi;
  if (!gatherLinks(mesh, vertex, ring)) return sharpest;
  const Point hub = pointOf(mesh, vertex);
  const auto count = static_cast<std::size_t>(ring.count);
  const auto startsSector = [&](std::size_t k) {
    const Half rim = ring.rim[k];
    return constrained(mesh, halfOf(triangleOf(rim), prev3(cornerOf(rim))));
  };
  std::size_t first = 0;
  while (first < count && !startsSector(first)) ++first;
  if (first == count) return sharpest;
  double angle = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = (first + n) % count;
    if (n > 0 && startsSector(k)) {
      sharpest = std::min(sharpest, angle);
      angle = 0.0;
    }
    angle += trig::angleBetween(pointOf(mesh, ring.vertices[k]) - hub, pointOf(mesh, ring.vertices[k + 1]) - hub);
  }
  return std::min(sharpest, angle);
}

// The edges of a triangle, of its neighbours, and all at its corners.
void edgesAround(Workpiece& work, Slot slot, std::vector<EdgeEnds>& edges) {
  const Mesh& mesh = work.mesh;
  const auto add = [&](Vertex a, Vertex b) {
    const EdgeEnds edge = endsOf(a, b);
    if (std::ranges::find(edges, edge) == edges.end()) edges.push_back(edge);
  };
  const auto addTriangle = [&](Slot other) {
    const Triangle& t = triangleAt(mesh, other);
    for (int i = 0; i < 3; ++i) add(t.v[next3(i)], t.v[prev3(i)]);
  };
  addTriangle(slot);
  for (const Half across : triangleAt(mesh, slot).adj)
    if (across.exists()) addTriangle(triangleOf(across));
  Ring& ring = work.room.ring;
  for (const Vertex v : triangleAt(mesh, slot).v) {
    if (!gatherLinks(mesh, v, ring)) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) add(v, ring.vertices[k]);
  }
}

// Excess of the corners around an edge: of its ends, and over it.
struct Corners4 {
  int a, b, c, d;  // d of a border: 0
};

// `border`: the edge has one side; `boundary`: it may be a piece of an inner chain too.
void collectMerges(const Mesh& mesh, const EdgeEnds& edge, bool border, bool boundary, const Corners4& e, int now,
                   std::vector<CureEdit>& edits) {
  for (const bool swapped : {false, true}) {
    const Vertex gone = swapped ? edge.b : edge.a, stays = swapped ? edge.a : edge.b;
    const bool goneInner = isInner(mesh, gone), staysInner = isInner(mesh, stays);
    if (goneInner && staysInner && swapped) continue;
    if (!goneInner && (!onCurve(mesh, gone) || !boundary || staysInner)) continue;
    // Triangles around what is merged: those of both, less those beside the edge, which both had.
    const int merged = e.a + e.b + (border ? 1 : 2);
    edits.push_back(
        {CureKind::collapse, gone, stays, squared(merged) + squared(e.c - 1) + (border ? 0 : squared(e.d - 1)) - now});
  }
}

}  // namespace

CureAims cureAimsFor(const Aims& aims) { return {limitsFor(aims), slackFor(aims), aims.lowestAngle * trig::kDegree}; }

bool touchesSharpCorner(Workpiece& work, Slot slot, const CureAims& aims) {
  const Mesh& mesh = work.mesh;
  return std::ranges::any_of(triangleAt(mesh, slot).v, [&](Vertex v) {
    return mesh.kinds[v] == VertexKind::kept && sharpestAngleAt(mesh, v) < aims.lowestAngle;
  });
}

void patchAround(Workpiece& work, Slot slot, int rings, CurePatch& patch) {
  const Corners<Vertex> seeds = triangleAt(work.mesh, slot).v;
  patch.relaxed = verticesAround(work, std::span(seeds.at), rings + 1, patch.all);
}

PatchPenalty penaltyOf(Workpiece& work, std::span<const Vertex> patch, const CureAims& aims) {
  PatchPenalty penalty;
  forEachTriangleAround(work, patch, [&](Slot slot) {
    const double own = penaltyOf(work.mesh, work.sizes, slot, aims.wanted);
    if (own == 0.0) return;
    const double beyond = penaltyOf(work.mesh, work.sizes, slot, aims.slack);
    if (beyond > 0.0 && !touchesSharpCorner(work, slot, aims)) penalty.beyond += beyond;
    penalty.sum += own + kBeyondWeight * beyond;
  });
  return penalty;
}

Slot worstIn(Workpiece& work, std::span<const Vertex> patch, const CureAims& aims) {
  Slot worst;
  double most = 0.0;
  forEachTriangleAround(work, patch, [&](Slot slot) {
    const double beyond = penaltyOf(work.mesh, work.sizes, slot, aims.slack);
    if (beyond > most) most = beyond, worst = slot;
  });
  return worst;
}

void collectEdits(Workpiece& work, Slot slot, std::vector<CureEdit>& edits) {
  const Mesh& mesh = work.mesh;
  std::vector<EdgeEnds> edges;
  edgesAround(work, slot, edges);
  for (const EdgeEnds& edge : edges) {
    const Half half = edgeBetween(mesh, edge.a, edge.b);
    if (!half.exists()) continue;
    const Half across = oppositeOf(mesh, half);
    const bool border = !across.exists();
    const Corners4 e{excessOf(mesh, edge.a), excessOf(mesh, edge.b), excessOf(mesh, apexOf(mesh, half)),
                     border ? 0 : excessOf(mesh, apexOf(mesh, across))};
    const int now = squared(e.a) + squared(e.b) + squared(e.c) + squared(e.d);
    const double part =
        distance(pointOf(mesh, edge.a), pointOf(mesh, edge.b)) / (0.5 * (work.sizes[edge.a] + work.sizes[edge.b]));
    if (!border && !constrained(mesh, half)) {
      edits.push_back({CureKind::flip, edge.a, edge.b,
                       squared(e.a - 1) + squared(e.b - 1) + squared(e.c + 1) + squared(e.d + 1) - now});
      // The vertex in the middle has four.
      if (part > kShortToSplit)
        edits.push_back(
            {CureKind::split, edge.a, edge.b, squared(e.c + 1) + squared(e.d + 1) + 4 - squared(e.c) - squared(e.d)});
    } else if (part > kShortBorder) {
      edits.push_back({CureKind::split, edge.a, edge.b,
                       squared(e.c + 1) - squared(e.c) + (border ? 0 : squared(e.d + 1) + 4 - squared(e.d))});
    }
    if (part < kLongToMerge) collectMerges(mesh, edge, border, constrained(mesh, half), e, now, edits);
  }
  std::ranges::sort(edits, {}, [](const CureEdit& e) { return std::tuple(e.gain, e.kind, e.a, e.b); });
}

bool makeEdit(Workpiece& work, const CureEdit& edit) {
  if (edit.kind == CureKind::relax) return true;
  const Half half = edgeBetween(work.mesh, edit.a, edit.b);
  if (!half.exists()) return false;
  if (edit.kind == CureKind::flip) return flip(work, half);
  return edit.kind == CureKind::split ? split(work, half) : merge(work, edit.a, edit.b);
}

PatchPenalty settle(Workpiece& work, CureKind kind, const CureAims& aims, CurePatch& patch) {
  OptimiserRoom& room = work.room;
  std::vector<Vertex> relaxed(patch.all.begin(), patch.all.begin() + static_cast<std::ptrdiff_t>(patch.relaxed));
  for (const Vertex v : room.touched) {
    if (std::ranges::find(patch.all, v) != patch.all.end()) continue;
    patch.all.push_back(v);
    relaxed.push_back(v);
  }
  room.touched.clear();
  // A flipped edge would be flipped back at once, before it is relaxed into what it is to be.
  const bool flipped = kind == CureKind::flip;
  relaxPatch(work, relaxed, aims.wanted, flipped ? Flipping::never : Flipping::where_obtuse,
             flipped ? kVisitsAfterEdit / 2 : kVisitsAfterEdit);
  for (const Vertex v : relaxed) suspectStar(work, v);
  if (flipSuspects(work) > 0) relaxPatch(work, relaxed, aims.wanted, Flipping::where_obtuse, kVisitsAfterEdit / 2);
  return penaltyOf(work, patch.all, aims);
}

}  // namespace triscope
