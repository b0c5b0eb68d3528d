// Stages "front1" and "front2" (paper, section 3, Figure 4 c): two fronts of points off the boundary, placed so that
// the boundary's edges get nearly equilateral triangles.
//
// At each boundary vertex the interior angle α is divided by round(α/60°) - 1 spokes at equal angles (none below 80°),
// as long as the boundary edges they turn between. Spokes that meet over an edge are merged. The second front does the
// same off the first.
#include <algorithm>

#include "core/geometry/trig.h"
#include "core/mesh/edit.h"
#include "core/method/stages/place.h"
#include "core/method/stages/placing_order.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

constexpr double kFewestDegrees = 80.0;
constexpr double kMergeWithin = 0.75;       // of the edge that two spokes meet over
constexpr double kNearest = 0.7;            // of the edge length h, to any other vertex
constexpr std::size_t kInLoopOrder = 4096;  // points at most that are placed in the order of the loops

struct Sector {
  Vertex vertex;
  Point toNext, toPrevious;  // the domain lies counter-clockwise from the first to the second
  std::size_t next;          // sector that follows along the front
  std::size_t firstSpoke = 0;
  std::size_t spokes = 0;
};

struct FrontSpoke {
  Point tip;
  Vertex vertex;
  std::size_t group;  // spokes of a group are merged; the lowest index stands for it
};

std::size_t rootOf(const std::vector<FrontSpoke>& spokes, std::size_t k) {
  while (spokes[k].group != k) k = spokes[k].group;
  return k;
}

// Interior angle in (0, 2π], 2π where the front turns back on itself.
double angleOf(const Sector& sector) {
  const double angle = trig::angleBetween(sector.toNext, sector.toPrevious);
  return angle > 0.0 ? angle : angle + 2.0 * trig::kPi;
}

void addSpokes(const Mesh& mesh, const Quadtree& tree, Sector& sector, std::vector<FrontSpoke>& spokes) {
  const double angle = angleOf(sector);
  sector.firstSpoke = spokes.size();
  if (angle < kFewestDegrees * trig::kDegree) return;
  sector.spokes = static_cast<std::size_t>(std::max(1.0, angle / (60.0 * trig::kDegree) + 0.5)) - 1;
  const Point at = pointOf(mesh, sector.vertex);
  const double h = edgeLengthAt(tree, at);
  const double from = std::min(length(sector.toNext), 2.0 * h);
  const double to = std::min(length(sector.toPrevious), 2.0 * h);
  const Point along = (1.0 / length(sector.toNext)) * sector.toNext;
  for (std::size_t k = 1; k <= sector.spokes; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(sector.spokes + 1);
    const trig::SinCos turn = trig::sinCos(part * angle);
    const Point direction{along.x * turn.cos - along.y * turn.sin, along.x * turn.sin + along.y * turn.cos};
    spokes.push_back({at + (from + part * (to - from)) * direction, sector.vertex, spokes.size()});
  }
}

// The first spoke of a sector and the last of the next one stand over the edge between them.
void mergeOverEdges(const std::vector<Sector>& sectors, std::vector<FrontSpoke>& spokes) {
  for (const Sector& sector : sectors) {
    const Sector& next = sectors[sector.next];
    if (sector.spokes == 0 || next.spokes == 0) continue;
    const std::size_t l = rootOf(spokes, sector.firstSpoke);
    const std::size_t r = rootOf(spokes, next.firstSpoke + next.spokes - 1);
    const double gap = distance(spokes[sector.firstSpoke].tip, spokes[next.firstSpoke + next.spokes - 1].tip);
    if (l != r && gap < kMergeWithin * length(sector.toNext)) spokes[std::max(l, r)].group = std::min(l, r);
  }
}

// Sectors of the boundary: around each vertex, from one boundary edge to the next.
std::vector<Sector> boundarySectors(const Mesh& mesh) {
  struct Key {
    Half half;  // v -> next vertex along the boundary, domain to the left
    std::size_t sector;
  };
  std::vector<Sector> sectors;
  std::vector<Key> starts;
  std::vector<Half> ends;  // per sector: half-edge previous -> v
  Star star;
  for (const Vertex vertex : mesh.points.keys()) {
    if (!mesh.vertexEdge[vertex].exists()) continue;
    starOf(mesh, vertex, star);
    // A full star of an inner chain begins anywhere: turn it to begin at a boundary edge.
    if (star.closed) {
      const auto first = std::find_if(star.rim.begin(), star.rim.end(), [&](Half half) {
        return constrained(mesh, halfOf(triangleOf(half), prev3(cornerOf(half))));
      });
      std::rotate(star.rim.begin(), first, star.rim.end());
    }
    const Point at0 = pointOf(mesh, vertex);
    for (const Half rim : star.rim) {
      const Half out = halfOf(triangleOf(rim), prev3(cornerOf(rim)));
      const Half in = halfOf(triangleOf(rim), next3(cornerOf(rim)));
      if (constrained(mesh, out)) {
        starts.push_back({out, sectors.size()});
        sectors.push_back({vertex, pointOf(mesh, startOf(mesh, rim)) - at0, {}, 0});
        ends.emplace_back();
      }
      sectors.back().toPrevious = pointOf(mesh, endOf(mesh, rim)) - at0;
      ends.back() = in;
    }
  }
  std::vector<Key> byEnd(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k) byEnd[k] = {ends[k], k};
  std::sort(byEnd.begin(), byEnd.end(), [](const Key& l, const Key& r) { return l.half < r.half; });
  for (const Key& start : starts) {
    const auto found =
        std::lower_bound(byEnd.begin(), byEnd.end(), start.half, [](const Key& l, Half half) { return l.half < half; });
    sectors[start.sector].next = found->sector;
  }
  return sectors;
}

// Sectors of the first front, loop by loop.
std::vector<Sector> frontSectors(const MeshState& state) {
  std::vector<Sector> sectors;
  const std::vector<Vertex>& loops = state.frontLoops;
  for (std::size_t first = 0; first < loops.size();) {
    std::size_t end = first;
    while (loops[end].exists()) ++end;
    const std::size_t n = end - first;
    const std::size_t base = sectors.size();
    for (std::size_t k = 0; n >= 3 && k < n; ++k) {
      const Point at0 = pointOf(state.mesh, loops[first + k]);
      const Point next = pointOf(state.mesh, loops[first + (k + 1) % n]);
      const Point previous = pointOf(state.mesh, loops[first + (k + n - 1) % n]);
      sectors.push_back({loops[first + k], next - at0, previous - at0, base + (k + 1) % n});
    }
    first = end + 1;
  }
  return sectors;
}

// The loops that are kept name the tips by their number until these are vertices.
void propose(MeshState& state, std::vector<Sector> sectors, bool keepLoops) {
  FrontTips& front = state.cursor.of<FrontTips>();
  std::vector<FrontSpoke> spokes;
  for (Sector& sector : sectors) addSpokes(state.mesh, state.tree, sector, spokes);
  mergeOverEdges(sectors, spokes);
  struct Tip {
    Point sum;  // of the spokes merged in it
    double weight = 0.0;
    Vertex vertex;
    Vertex proposal;
  };
  std::vector<Tip> tips;
  std::vector<std::size_t> tipOf(spokes.size());
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    const std::size_t root = rootOf(spokes, k);  // the lowest of its group
    tipOf[k] = root == k ? tips.size() : tipOf[root];
    if (root == k) tips.push_back({.sum = {}, .weight = 0.0, .vertex = spokes[k].vertex, .proposal = {}});
    Tip& tip = tips[tipOf[k]];
    tip.sum = tip.sum + spokes[k].tip;
    tip.weight += 1.0;
  }
  for (const std::int32_t proposed : placingOrder(tips.size(), kInLoopOrder)) {
    const auto k = static_cast<std::size_t>(proposed);
    tips[k].proposal = Vertex(front.places.size());
    front.places.push_back((1.0 / tips[k].weight) * tips[k].sum);
    front.owners.push_back(tips[k].vertex);
  }
  front.placed.assign(front.places.size(), {});
  if (!keepLoops) return;
  state.frontLoops.clear();
  std::vector<std::uint8_t> seen(sectors.size(), 0);
  for (std::size_t s = 0; s < sectors.size(); ++s) {
    if (seen[s] != 0) continue;
    for (std::size_t k = s; seen[k] == 0; k = sectors[k].next) {
      seen[k] = 1;
      for (std::size_t spoke = sectors[k].spokes; spoke-- > 0;) {
        state.frontLoops.push_back(tips[tipOf[sectors[k].firstSpoke + spoke]].proposal);
      }
    }
    state.frontLoops.emplace_back();
  }
}

// Turns the proposals listed in frontLoops into the vertices placed, leaving out refused and repeated ones.
void closeLoops(MeshState& state) {
  const FrontTips& front = state.cursor.of<FrontTips>();
  std::vector<Vertex> loops;
  std::size_t first = 0;
  for (const Vertex proposal : state.frontLoops) {
    if (!proposal.exists()) {
      while (loops.size() > first + 1 && loops.back() == loops[first]) loops.pop_back();
      if (loops.size() > first) loops.emplace_back();
      first = loops.size();
      continue;
    }
    const Vertex vertex = front.placed[static_cast<std::size_t>(proposal.n)];
    if (vertex.exists() && (loops.size() == first || loops.back() != vertex)) loops.push_back(vertex);
  }
  state.frontLoops = std::move(loops);
}

Outcome placeNext(MeshState& state, Journal& journal, Rule rule, VertexKind kind, std::vector<Vertex>& placed) {
  Cursor& cursor = state.cursor;
  FrontTips& front = cursor.of<FrontTips>();
  if (cursor.index == front.places.size()) return Outcome::done;
  const std::size_t k = cursor.index++;
  const Point p = front.places[k];
  const Vertex owner = front.owners[k];
  const double floor = state.minEdge * (1.0 - 1e-9);  // where all edges are Δx long, points are Δx apart up to rounding
  const Demand demand{std::max(kNearest * edgeLengthAt(state.tree, p), floor), 0.0};
  const Attempt attempt =
      place(state.mesh, state.tree, p, state.mesh.vertexTriangle[owner], kind, demand, state.room.placing);
  if (attempt.vertex.exists()) {
    front.placed[k] = attempt.vertex;
    placed.push_back(attempt.vertex);
  } else {
    ++state.counts[state.stage].refused;
  }
  if (journal.listening()) {
    Event event =
        eventIn(state, attempt.vertex.exists() ? EventKind::vertex_inserted : EventKind::vertex_refused, rule);
    event.other = owner.word();
    event.at = p;
    event.measured = distance(p, pointOf(state.mesh, owner));
    event.limit = demand.nearest;
    describeAttempt(event, attempt);
    journal.record(event);
  }
  return attempt.vertex.exists() ? Outcome::inserted : Outcome::decided;
}

}  // namespace

Outcome runFront1(MeshState& state, Journal& journal) {
  if (!state.cursor.begun) {
    state.cursor.begun = true;
    propose(state, boundarySectors(state.mesh), true);
  }
  const Outcome outcome = placeNext(state, journal, Rule::first_front, VertexKind::front1, state.front1);
  if (outcome == Outcome::done) closeLoops(state);
  return outcome;
}

Outcome runFront2(MeshState& state, Journal& journal) {
  if (!state.cursor.begun) {
    state.cursor.begun = true;
    propose(state, frontSectors(state), false);
  }
  return placeNext(state, journal, Rule::second_front, VertexKind::front2, state.front2);
}

}  // namespace triscope
