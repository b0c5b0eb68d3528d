#include "core/mesh/cavity.h"

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr std::size_t kFirstCapacity = 64;

// Each triangle found brings one vertex and turns one edge into two, so that this is room enough for all lists.
void makeRoom(Cavity& cavity, std::size_t triangles) {
  constexpr std::size_t kMargin = 8;  // vertices and edges of the first two triangles, and where the rim ends
  cavity.capacity = triangles;
  cavity.found.resize(triangles + kMargin);
  cavity.edges.resize(triangles + kMargin);
  cavity.made.resize(triangles + kMargin);
  cavity.sights.resize(triangles + kMargin);
  cavity.open.resize(triangles + kMargin);
}

Cavity::Sight sightOf(const Mesh& mesh, std::int32_t vertex, Point p) {
  const Point q = pointOf(mesh, vertex);
  const double x = q.x - p.x, y = q.y - p.y;
  return {x, y, x * x + y * y, vertex};
}

double twiceAreaSeen(const Cavity::Sight& from, const Cavity::Sight& to) { return from.x * to.y - to.x * from.y; }

// What lies beyond edge i of a triangle, as in Cavity::RimEdge.
std::int32_t beyond(const Triangle& t, std::int32_t slot, std::uint8_t flags, int i) {
  const std::int32_t across = t.adj[static_cast<std::size_t>(i)];
  return across < 0 || (flags >> i & 1) != 0 ? -2 - (3 * slot + i) : across;
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

std::int32_t look(const Mesh& mesh, Cavity& cavity, std::int32_t vertex) {
  const Cavity::Sight sight = sightOf(mesh, vertex, cavity.at);
  cavity.nearest = std::min(cavity.nearest, sight.squaredDistance);
  cavity.sights[cavity.sightCount] = sight;
  return static_cast<std::int32_t>(cavity.sightCount++);
}

Cavity::Open openEdge(const Mesh& mesh, const Cavity& cavity, std::int32_t slot, int i, std::int32_t from,
                      std::int32_t to) {
  return {from, to, beyond(triangleAt(mesh, slot), slot, mesh.flags[at(slot)], i),
          twiceAreaSeen(cavity.sights[at(from)], cavity.sights[at(to)])};
}

void take(Mesh& mesh, Cavity& cavity, std::int32_t slot) {
  mesh.flags[at(slot)] |= kInCavity;
  cavity.found[cavity.triangleCount++] = slot;
}

// From the open edges, of which there is at least one. Depth first, edges counter-clockwise, so that the rim comes out
// in order around the point. Each vertex is looked at once, and an in-circle test needs but one new one: the areas with
// the other two edges of a triangle are those of its own test.
// A triangle that was entered already is not entered again: where the point lies in the first triangle that cannot
// come up, since each of the others is entered through the one edge that hides it from the point; a point that splits
// an edge of a bent curve may lie elsewhere.
void grow(Mesh& mesh, Cavity& cavity, std::size_t depth) {
  const Triangle* const all = mesh.triangles.data();
  const Point* const points = mesh.points.data();
  std::uint8_t* const flags = mesh.flags.data();
  const Point p = cavity.at;
  std::int32_t* found = cavity.found.data();
  Cavity::RimEdge* edges = cavity.edges.data();
  Cavity::Sight* sights = cavity.sights.data();
  Cavity::Open* open = cavity.open.data();
  std::size_t count = cavity.triangleCount, rim = cavity.rimCount, capacity = cavity.capacity;
  auto sightCount = static_cast<std::int32_t>(cavity.sightCount);
  double nearest = cavity.nearest;
  bool walled = cavity.walled;

  Cavity::Open edge = open[--depth];
  Cavity::Sight a = sights[edge.from], b = sights[edge.to];
  for (;;) {
    if (edge.across >= 0) {
      const std::int32_t slot = thirdOf(edge.across);
      const int corner = edge.across - 3 * slot;
      const Triangle& t = all[slot];
      const std::int32_t apex = t.v[static_cast<std::size_t>(corner)];
      const double x = points[apex].x - p.x, y = points[apex].y - p.y;
      const double squared = x * x + y * y;
      const double bc = b.x * y - x * b.y;
      const double ca = x * a.y - a.x * y;
      int inside = incircleSeen(edge.area, bc, ca, a.squaredDistance, b.squaredDistance, squared);
      if (inside == 0) inside = detail::incircleExact(points[t.v[0]], points[t.v[1]], points[t.v[2]], p);
      if (inside > 0 && (flags[slot] & kInCavity) == 0) {
        if (count == capacity) {
          makeRoom(cavity, 2 * capacity);
          capacity = cavity.capacity;
          found = cavity.found.data();
          edges = cavity.edges.data();
          sights = cavity.sights.data();
          open = cavity.open.data();
        }
        const int before = prev3(corner), after = next3(corner);
        std::int32_t acrossBefore = t.adj[static_cast<std::size_t>(before)];
        std::int32_t acrossAfter = t.adj[static_cast<std::size_t>(after)];
        if ((flags[slot] & kConstrainedAll) != 0 || (acrossBefore | acrossAfter) < 0) {
          acrossBefore = beyond(t, slot, flags[slot], before);
          acrossAfter = beyond(t, slot, flags[slot], after);
        }
        flags[slot] |= kInCavity;
        found[count++] = slot;
        nearest = std::min(nearest, squared);
        sights[sightCount] = {x, y, squared, apex};
        open[depth++] = {sightCount, edge.to, acrossBefore, -bc};
        edge = {edge.from, sightCount, acrossAfter, -ca};
        b = sights[sightCount++];
        continue;
      }
    } else {
      walled = true;
    }
    edges[rim++] = {a.vertex, edge.across};
    if (depth == 0) break;
    edge = open[--depth];
    a = sights[edge.from];
    b = sights[edge.to];
  }
  edges[rim] = {b.vertex, 0};
  cavity.triangleCount = count;
  cavity.rimCount = rim;
  cavity.sightCount = static_cast<std::size_t>(sightCount);
  cavity.nearest = nearest;
  cavity.walled = walled;
}

void unmark(Mesh& mesh, const Cavity& cavity) {
  for (const std::int32_t slot : cavity.triangles()) mesh.flags[at(slot)] &= static_cast<std::uint8_t>(~kInCavity);
}

}  // namespace

std::int32_t halfEdgeOf(const Mesh& mesh, const Cavity::RimEdge& edge) {
  return edge.isWall() ? edge.wall() : oppositeOf(mesh, edge.across);
}

void findCavity(Mesh& mesh, Point p, std::int32_t start, Cavity& cavity) {
  begin(cavity, p);
  for (const std::int32_t vertex : triangleAt(mesh, start).v) look(mesh, cavity, vertex);
  for (int i = 0; i < 3; ++i) cavity.open[at(2 - i)] = openEdge(mesh, cavity, start, i, next3(i), prev3(i));
  take(mesh, cavity, start);
  grow(mesh, cavity, 3);
  unmark(mesh, cavity);
}

bool findSplitCavity(Mesh& mesh, Point p, std::int32_t edge, Cavity& cavity) {
  begin(cavity, p);
  const std::int32_t other = oppositeOf(mesh, edge);
  if (other >= 0) mesh.flags[at(triangleOf(other))] |= kInCavity;
  std::int32_t from = look(mesh, cavity, startOf(mesh, edge));
  std::int32_t to = look(mesh, cavity, endOf(mesh, edge));
  for (const std::int32_t side : {edge, other}) {
    if (side < 0) continue;
    const std::int32_t slot = triangleOf(side);
    const int i = cornerOf(side);
    const std::int32_t apex = look(mesh, cavity, apexOf(mesh, side));
    if (cavity.triangleCount == cavity.capacity) makeRoom(cavity, 2 * cavity.capacity);
    take(mesh, cavity, slot);
    cavity.open[0] = openEdge(mesh, cavity, slot, prev3(i), apex, from);
    cavity.open[1] = openEdge(mesh, cavity, slot, next3(i), to, apex);
    grow(mesh, cavity, 2);
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

// The slots of the fan: those of the cavity, last found first, as if its triangles had been freed one by one, then
// others.
void takeSlots(Mesh& mesh, Cavity& cavity) {
  for (std::size_t k = 0; k < cavity.rimCount; ++k) {
    if (k < cavity.triangleCount) {
      cavity.made[k] = cavity.found[cavity.triangleCount - 1 - k];
    } else if (!mesh.freeSlots.empty()) {
      cavity.made[k] = mesh.freeSlots.back();
      mesh.freeSlots.pop_back();
    } else {
      cavity.made[k] = static_cast<std::int32_t>(mesh.triangles.size());
      mesh.triangles.emplace_back();
      mesh.ids.push_back(0);
      mesh.flags.push_back(0);
      mesh.tested.push_back(0);
    }
  }
}

// Reads what lies beyond each wall while its triangle is there to tell: RimEdge::across becomes -1 where there is
// nothing, and -3 - (the half-edge on the other side, or -1) beyond a constrained edge.
void readWalls(const Mesh& mesh, Cavity& cavity) {
  for (std::size_t k = 0; k < cavity.rimCount; ++k) {
    Cavity::RimEdge& edge = cavity.edges[k];
    if (edge.isWall()) edge.across = constrained(mesh, edge.wall()) ? -3 - oppositeOf(mesh, edge.wall()) : -1;
  }
}

// Hangs a fan around a new vertex. Its ends are joined where the rim is closed. Returns the new vertex.
std::int32_t fill(Mesh& mesh, Cavity& cavity, VertexKind kind, std::uint8_t density) {
  const std::int32_t vertex = addVertex(mesh, cavity.at, kind, density);
  if (cavity.walled) readWalls(mesh, cavity);
  takeSlots(mesh, cavity);
  Triangle* const all = mesh.triangles.data();
  std::uint32_t* const ids = mesh.ids.data();
  std::uint8_t* const flags = mesh.flags.data();
  std::uint8_t* const tested = mesh.tested.data();
  std::int32_t* const triangleAround = mesh.vertexTriangle.data();
  const Cavity::RimEdge* const edges = cavity.edges.data();
  const std::int32_t* const slots = cavity.made.data();
  const std::size_t n = cavity.rimCount;
  const bool closed = cavity.closed();
  std::uint32_t id = mesh.nextId;
  std::int32_t before = closed ? 3 * slots[n - 1] + 1 : -1;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int32_t slot = slots[k];
    const std::int32_t after = k + 1 < n ? 3 * slots[k + 1] + 2 : closed ? 3 * slots[0] + 2 : -1;
    const bool wall = edges[k].across < -1;
    const std::int32_t across = wall ? -3 - edges[k].across : edges[k].across;
    if (across >= 0) {
      const std::int32_t other = thirdOf(across);
      all[other].adj[static_cast<std::size_t>(across - 3 * other)] = 3 * slot;
      tested[other] = 0;
    }
    all[slot] = {{vertex, edges[k].vertex, edges[k + 1].vertex}, {across, after, before}};
    ids[slot] = id++;
    flags[slot] = wall ? kConstrained0 : 0;
    tested[slot] = 0;
    triangleAround[edges[k].vertex] = slot;
    before = 3 * slot + 1;
  }
  triangleAround[edges[n].vertex] = slots[n - 1];
  triangleAround[vertex] = slots[n - 1];
  mesh.nextId = id;
  mesh.lastTriangle = slots[n - 1];
  ChangeLog::note(cavity.fan());
  return vertex;
}

}  // namespace

std::int32_t fillCavity(Mesh& mesh, Cavity& cavity, VertexKind kind, std::uint8_t density) {
  return fill(mesh, cavity, kind, density);
}

std::int32_t fillSplitCavity(Mesh& mesh, Cavity& cavity, std::int32_t edge, double t, std::uint8_t density) {
  const std::int32_t vertex = fill(mesh, cavity, VertexKind::split, density);
  const std::int32_t rest = splitBoundaryEdge(mesh, edge, vertex, t);
  for (const std::int32_t e : {edge, rest}) {
    const std::int32_t a = mesh.edges[at(e)].v0;
    const std::int32_t b = mesh.edges[at(e)].v1;
    for (const std::int32_t half : {findHalfEdge(mesh, a, b), findHalfEdge(mesh, b, a)}) {
      if (half >= 0) setConstrained(mesh, half, true);
    }
  }
  return vertex;
}

}  // namespace triscope
