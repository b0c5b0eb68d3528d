#include "core/mesh/cavity.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr std::size_t kFirstCapacity = 64;

// Each triangle found brings one vertex and turns one edge into two, so that this is room enough for all lists.
void makeRoom(Cavity& cavity, std::size_t triangles) {
  constexpr std::size_t kMargin = 8;  // vertices and edges of the first two triangles, and where the rim ends
  std::vector<Slot> slots(triangles + kMargin);
  const std::span<const Slot> found = cavity.triangles();
  std::copy(found.begin(), found.end(), slots.begin() + static_cast<std::ptrdiff_t>(triangles - found.size()));
  cavity.slots.swap(slots);
  cavity.capacity = triangles;
  cavity.edges.resize(triangles + kMargin);
  cavity.sights.resize(triangles + kMargin);
  cavity.open.resize(triangles + kMargin);
}

Cavity::Sight sightOf(const Mesh& mesh, Vertex vertex, Point p) {
  const Point q = pointOf(mesh, vertex);
  const double x = q.x - p.x, y = q.y - p.y;
  return {x, y, x * x + y * y, vertex};
}

double twiceAreaSeen(const Cavity::Sight& from, const Cavity::Sight& to) { return from.x * to.y - to.x * from.y; }

// What lies beyond edge i of a triangle, as in Cavity::RimEdge.
std::int32_t beyond(const Triangle& t, Slot slot, std::uint8_t flags, int i) {
  const Half across = t.adj[i];
  return !across.exists() || (flags >> i & 1) != 0 ? -2 - halfOf(slot, i).n : across.n;
}

// Same as half / 3 of a half-edge, which is never negative: the compiler does not know.
std::int32_t thirdOf(std::int32_t half) { return static_cast<std::int32_t>(static_cast<std::uint32_t>(half) / 3u); }

void begin(Cavity& cavity, Point p) {
  if (cavity.capacity == 0) makeRoom(cavity, kFirstCapacity);
  cavity.at = p;
  cavity.nearest = 1e300;
  cavity.walled = false;
  cavity.triangleCount = 0;
  cavity.rimCount = 0;
  cavity.sightCount = 0;
}

std::int32_t look(const Mesh& mesh, Cavity& cavity, Vertex vertex) {
  const Cavity::Sight sight = sightOf(mesh, vertex, cavity.at);
  cavity.nearest = std::min(cavity.nearest, sight.squaredDistance);
  cavity.sights[cavity.sightCount] = sight;
  return static_cast<std::int32_t>(cavity.sightCount++);
}

Cavity::Open openEdge(const Mesh& mesh, const Cavity& cavity, Slot slot, int i, std::int32_t from, std::int32_t to) {
  return {from, to, beyond(triangleAt(mesh, slot), slot, mesh.flags[slot], i),
          twiceAreaSeen(cavity.sights[static_cast<std::size_t>(from)], cavity.sights[static_cast<std::size_t>(to)])};
}

void take(Cavity& cavity, Slot slot) {
  if (cavity.triangleCount == cavity.capacity) makeRoom(cavity, 2 * cavity.capacity);
  cavity.slots[cavity.capacity - ++cavity.triangleCount] = slot;
}

// From the open edges, of which there is at least one. Depth first, edges counter-clockwise, so that the rim comes out
// in order around the point. Each vertex is looked at once, and an in-circle test needs but one new one: the areas with
// the other two edges of a triangle are those of its own test.
// With kMarks, what is in the cavity is marked, and not entered again. From one triangle that is not needed: of any
// other whose circle holds the point, one edge alone hides it from the point, and its apex is seen through that edge.
// What is entered through the other two is seen through less and less, and so never comes round again. But it can where
// the point splits an edge: it looks from both sides of it, and may lie off it where the curve is bent.
template <bool kMarks>
void grow(Mesh& mesh, Cavity& cavity, std::size_t depth) {
  const Triangle* const all = mesh.triangles.data();
  const Point* const points = mesh.points.data();
  std::uint8_t* const flags = mesh.flags.data();
  const Point p = cavity.at;
  Slot* slots = cavity.slots.data();
  Cavity::RimEdge* edges = cavity.edges.data();
  Cavity::Sight* sights = cavity.sights.data();
  Cavity::Open* open = cavity.open.data();
  std::size_t count = cavity.triangleCount, rim = cavity.rimCount, capacity = cavity.capacity;
  auto sightCount = static_cast<std::int32_t>(cavity.sightCount);
  double nearest = cavity.nearest;
  bool walled = cavity.walled;

  // The edge looked across and its ends, one value each: a structure copied just after its members were written waits
  // for the writes.
  std::int32_t from = 0, to = 0, across = 0;
  double area = 0.0, ax = 0.0, ay = 0.0, aSquared = 0.0, bx = 0.0, by = 0.0, bSquared = 0.0;
  const auto next = [&] {
    const Cavity::Open& edge = open[--depth];
    from = edge.from;
    to = edge.to;
    across = edge.across;
    area = edge.area;
    ax = sights[from].x;
    ay = sights[from].y;
    aSquared = sights[from].squaredDistance;
    bx = sights[to].x;
    by = sights[to].y;
    bSquared = sights[to].squaredDistance;
  };
  next();
  for (;;) {
    if (across >= 0) {
      const std::int32_t slot = thirdOf(across);
      const int corner = across - 3 * slot;
      const Triangle& t = all[slot];
      const Vertex apex = t.v[corner];
      const double x = points[apex.n].x - p.x, y = points[apex.n].y - p.y;
      const double squared = x * x + y * y;
      const double bc = bx * y - x * by;
      const double ca = x * ay - ax * y;
      int inside = incircleSeen(area, bc, ca, aSquared, bSquared, squared);
      if (inside == 0) inside = detail::incircleExact(points[t.v[0].n], points[t.v[1].n], points[t.v[2].n], p);
      if (inside > 0 && (!kMarks || (flags[slot] & kInCavity) == 0)) {
        if (count == capacity) {
          TRISCOPE_CHECK(count <= mesh.triangles.size(), "a cavity has no more triangles than the mesh");
          cavity.triangleCount = count;
          makeRoom(cavity, 2 * capacity);
          capacity = cavity.capacity;
          slots = cavity.slots.data();
          edges = cavity.edges.data();
          sights = cavity.sights.data();
          open = cavity.open.data();
        }
        const int before = prev3(corner), after = next3(corner);
        std::int32_t acrossBefore = t.adj[before].n;
        std::int32_t acrossAfter = t.adj[after].n;
        const std::uint8_t bits = flags[slot];
        if ((bits & kConstrainedAll) != 0 || (acrossBefore | acrossAfter) < 0) {
          acrossBefore = beyond(t, Slot(slot), bits, before);
          acrossAfter = beyond(t, Slot(slot), bits, after);
        }
        if constexpr (kMarks) flags[slot] = bits | kInCavity;
        slots[capacity - ++count] = Slot(slot);
        nearest = std::min(nearest, squared);
        sights[sightCount] = {x, y, squared, apex};
        open[depth++] = {sightCount, to, acrossBefore, -bc};
        to = sightCount++;
        across = acrossAfter;
        area = -ca;
        bx = x;
        by = y;
        bSquared = squared;
        continue;
      }
    } else {
      walled = true;
    }
    edges[rim++] = {sights[from].vertex, across};
    if (depth == 0) break;
    next();
  }
  edges[rim] = {sights[to].vertex, 0};
  cavity.triangleCount = count;
  cavity.rimCount = rim;
  cavity.sightCount = static_cast<std::size_t>(sightCount);
  cavity.nearest = nearest;
  cavity.walled = walled;
}

void unmark(Mesh& mesh, const Cavity& cavity) {
  for (const Slot slot : cavity.triangles()) mesh.flags[slot] &= static_cast<std::uint8_t>(~kInCavity);
}

}  // namespace

Half halfEdgeOf(const Mesh& mesh, const Cavity::RimEdge& edge) {
  return edge.isWall() ? edge.wall() : oppositeOf(mesh, Half(edge.across));
}

void findCavity(Mesh& mesh, Point p, Slot start, Cavity& cavity) {
  begin(cavity, p);
  for (const Vertex vertex : triangleAt(mesh, start).v) look(mesh, cavity, vertex);
  for (int i = 0; i < 3; ++i)
    cavity.open[static_cast<std::size_t>(2 - i)] = openEdge(mesh, cavity, start, i, next3(i), prev3(i));
  take(cavity, start);
  grow<false>(mesh, cavity, 3);
}

bool findSplitCavity(Mesh& mesh, Point p, Half edge, Cavity& cavity) {
  begin(cavity, p);
  const Half other = oppositeOf(mesh, edge);
  for (const Half side : {edge, other})
    if (side.exists()) mesh.flags[triangleOf(side)] |= kInCavity;
  std::int32_t from = look(mesh, cavity, startOf(mesh, edge));
  std::int32_t to = look(mesh, cavity, endOf(mesh, edge));
  for (const Half side : {edge, other}) {
    if (!side.exists()) continue;
    const Slot slot = triangleOf(side);
    const int i = cornerOf(side);
    const std::int32_t apex = look(mesh, cavity, apexOf(mesh, side));
    take(cavity, slot);
    cavity.open[0] = openEdge(mesh, cavity, slot, prev3(i), apex, from);
    cavity.open[1] = openEdge(mesh, cavity, slot, next3(i), to, apex);
    grow<true>(mesh, cavity, 2);
    std::swap(from, to);
  }
  unmark(mesh, cavity);
  for (std::size_t k = 0; k < cavity.rimCount; ++k) {
    const Cavity::RimEdge* const e = &cavity.edges[k];
    if (orient2d(pointOf(mesh, e[0].vertex), pointOf(mesh, e[1].vertex), p) > 0) continue;
    cavity.triangleCount = 0;
    cavity.rimCount = 0;
    return false;
  }
  return true;
}

namespace {

// Puts the slots that the fan needs beyond those of the cavity behind them: the one freed last, or new ones.
void takeSlots(Mesh& mesh, Cavity& cavity) {
  Slot* const more = cavity.slots.data() + cavity.capacity;
  TRISCOPE_CHECK(cavity.triangleCount > 0 && cavity.rimCount > cavity.triangleCount &&
                     cavity.capacity + cavity.rimCount - cavity.triangleCount < cavity.slots.size(),
                 "a cavity has one or two edges around it more than it has triangles");
  const std::size_t count = cavity.rimCount - cavity.triangleCount;
  for (std::size_t k = 0; k < count; ++k) more[k] = takeSlot(mesh);
}

// Reads what lies beyond each wall while its triangle is there to tell: RimEdge::across becomes -1 where there is
// nothing, and -3 - (the half-edge on the other side, or -1) beyond a constrained edge.
void readWalls(const Mesh& mesh, Cavity& cavity) {
  for (std::size_t k = 0; k < cavity.rimCount; ++k) {
    Cavity::RimEdge& edge = cavity.edges[k];
    if (edge.isWall()) edge.across = constrained(mesh, edge.wall()) ? -3 - oppositeOf(mesh, edge.wall()).n : -1;
  }
}

// Hangs a fan around a new vertex. Its ends are joined where the rim is closed. Returns the new vertex.
Vertex fill(Mesh& mesh, Cavity& cavity, VertexKind kind, std::uint8_t density) {
  const Vertex vertex = addVertex(mesh, cavity.at, kind, density);
  if (cavity.walled) readWalls(mesh, cavity);
  takeSlots(mesh, cavity);
  Triangle* const all = mesh.triangles.data();
  TriangleId* const ids = mesh.ids.data();
  std::uint8_t* const flags = mesh.flags.data();
  std::uint8_t* const tested = mesh.tested.data();
  Slot* const triangleAround = mesh.vertexTriangle.data();
  const Cavity::RimEdge* const edges = cavity.edges.data();
  Slot* const slots = cavity.slots.data() + (cavity.capacity - cavity.triangleCount);
  const std::size_t n = cavity.rimCount;
  const bool closed = cavity.closed();
  TriangleId id = mesh.nextId;
  slots[n] = slots[0];
  Half before = closed ? halfOf(slots[n - 1], 1) : Half();
  for (std::size_t k = 0; k < n; ++k) {
    const Slot slot = slots[k];
    const bool wall = edges[k].across < -1;
    const Half across(wall ? -3 - edges[k].across : edges[k].across);
    if (across.exists()) {
      const std::int32_t other = thirdOf(across.n);
      all[other].adj[across.n - 3 * other] = halfOf(slot, 0);
      tested[other] = 0;
    }
    all[slot.n] = {{vertex, edges[k].vertex, edges[k + 1].vertex}, {across, halfOf(slots[k + 1], 2), before}};
    ids[slot.n] = id++;
    flags[slot.n] = wall ? kConstrained0 : 0;
    tested[slot.n] = 0;
    triangleAround[edges[k].vertex.n] = slot;
    before = halfOf(slot, 1);
  }
  if (!closed) all[slots[n - 1].n].adj[1] = {};
  triangleAround[edges[n].vertex.n] = slots[n - 1];
  triangleAround[vertex.n] = slots[n - 1];
  mesh.nextId = id;
  mesh.lastTriangle = slots[n - 1];
  noteTouched(mesh, cavity.fan());
  return vertex;
}

}  // namespace

Vertex fillCavity(Mesh& mesh, Cavity& cavity, VertexKind kind, std::uint8_t density) {
  return fill(mesh, cavity, kind, density);
}

Vertex fillSplitCavity(Mesh& mesh, Cavity& cavity, EdgeId edge, double t, std::uint8_t density) {
  const Vertex vertex = fill(mesh, cavity, VertexKind::split, density);
  const EdgeId rest = splitBoundaryEdge(mesh, edge, vertex, t);
  for (const EdgeId e : {edge, rest}) {
    const Vertex a = mesh.edges[e].v0;
    const Vertex b = mesh.edges[e].v1;
    const Half left = findHalfEdge(mesh, a, b), right = findHalfEdge(mesh, b, a);
    TRISCOPE_CHECK(left.exists() || right.exists(),
                   "both parts of a boundary edge that was split are edges of the mesh");
    for (const Half half : {left, right}) {
      if (half.exists()) constrain(mesh, half);
    }
  }
  return vertex;
}

}  // namespace triscope
