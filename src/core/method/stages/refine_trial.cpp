#include "core/method/stages/refine_trial.h"

#include <algorithm>
#include <array>

#include "core/mesh/badness.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"
#include "core/method/stages/refine_marks.h"

namespace triscope {
namespace {

constexpr double kLargeAspect = 3.0;       // a shared edge may be moved as long as no aspect ratio grows beyond it
constexpr double kLargeEdgeRatio = 1.935;  // the paper ends at 1.94: no move goes beyond, or beyond what was

// Why the region after a move is worse than before; none when it is not. Each part of the step answers for the measure
// it is there to improve, and may not spoil the others beyond what is large; polishing answers for all of them.
Refusal judge(const MeshState& state, Rule rule, const Badness& was, const Badness& is, double minEdge) {
  if (is.broken > was.broken || is.excess > was.excess) return Refusal::bound_broken;
  if (is.shortest < minEdge * minEdge && is.shortest < was.shortest) return Refusal::edge_below_minimum;
  if (is.obtuse > was.obtuse) return Refusal::star_worse;
  if (rule == Rule::polish) {
    const auto* const polishing = std::get_if<Polishing>(&state.cursor.ahead);
    const Worst worst = polishing != nullptr && polishing->worst ? *polishing->worst : Worst();
    const double strain = strainOf(is, worst);
    const bool better = strain < strainOf(was, worst) || (is.obtuse < was.obtuse && strain <= 1.0);
    return better ? Refusal::none : Refusal::star_worse;
  }
  if (is.areaRatio > std::max(was.areaRatio, kLargeAreaRatio)) return Refusal::star_worse;
  if (is.edgeRatio > std::max(was.edgeRatio, kLargeEdgeRatio * kLargeEdgeRatio)) return Refusal::star_worse;
  if (is.obtuse < was.obtuse) return Refusal::none;
  const bool worse = rule == Rule::shared_edge
                         ? is.areaRatio >= was.areaRatio || is.worst > std::max(was.worst, kLargeAspect)
                         : is.worst > was.worst;
  return worse ? Refusal::star_worse : Refusal::none;
}

// Δx, or less where kept input edges made the density finer than that.
double shortestAllowed(const MeshState& state, std::uint8_t finestRank) {
  return std::min(state.minEdge, edgeLengthOf(state.tree, finestRank));
}

Verdict judged(const MeshState& state, Rule rule, const Badness& was, const Badness& is, double minEdge) {
  const Refusal refusal = judge(state, rule, was, is, minEdge);
  const bool byEdge = refusal == Refusal::edge_below_minimum;
  return {refusal, byEdge ? std::sqrt(is.shortest) : is.worst, byEdge ? minEdge : was.worst};
}

// --- One look at the star.

constexpr std::size_t kMost = 24;        // spokes of a wheel that is looked at so
constexpr double kClearly = 1.0 - 1e-9;  // of a limit: far from a tie, in whichever order the figure is worked out
constexpr double kAboveZero = 1e-9;      // of the largest term: clearly positive
constexpr double kWithin = kClearly * (1.0 - 2.0 * kBoundMargin);  // of a bound, which badnessOf then finds kept
constexpr double kBoundAreaRatio = 3.0;

// An entry for each spoke, and the first again at the end, so that "the next" needs no wrapping round.
using Ring = std::array<double, kMost + 1>;

// What a move leaves as it is.
struct Rim {
  std::size_t count = 0;
  Ring squared;  // length of the rim from this spoke to the next
  Ring root;
  Ring beyond;  // twice the area of the triangle beyond it, -1 at a border
};

// The star with its hub in one place.
struct Pose {
  Ring squared;  // length of the spoke
  Ring root;
  Ring area;  // twice, by the operations of twiceArea in their order
};

struct Look {
  double worst = 2.0;       // largest aspect ratio
  double shortest = 1e300;  // edge, squared
  int obtuse = 0;
  bool sure = true;      // every triangle is clearly counter-clockwise, and has R < e
  bool slender = false;  // an edge ratio may be beyond kLargeEdgeRatio
};

void rimOf(const Mesh& mesh, const Wheel& wheel, Rim& rim) {
  const std::size_t n = rim.count = wheel.spokes.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Spoke& spoke = wheel.spokes[k];
    rim.squared[k] = squaredDistance(spoke.at, wheel.spokes[k + 1 == n ? 0 : k + 1].at);
    rim.beyond[k] = spoke.across.exists() ? std::max(0.0, twiceArea(mesh, triangleOf(spoke.across))) : -1.0;
  }
  for (std::size_t k = 0; k < n; ++k) rim.root[k] = std::sqrt(rim.squared[k]);
}

void poseOf(const Wheel& wheel, Point hub, Pose& pose) {
  const std::size_t n = wheel.spokes.size();
  for (std::size_t k = 0; k < n; ++k) pose.squared[k] = squaredDistance(hub, wheel.spokes[k].at);
  pose.squared[n] = pose.squared[0];
  for (std::size_t k = 0; k <= n; ++k) pose.root[k] = std::sqrt(pose.squared[k]);
  for (std::size_t k = 0; k < n; ++k) {
    const int corner = wheel.spokes[k].corner;
    const Point s = wheel.spokes[k].at, e = wheel.spokes[k + 1 == n ? 0 : k + 1].at;
    pose.area[k] = corner == 0 ? cross(s - hub, e - hub) : corner == 1 ? cross(hub - e, s - e) : cross(e - s, hub - s);
  }
  pose.area[n] = pose.area[0];
}

// Smallest, middle, largest: by minima and maxima, since which is which is anybody's guess.
void inOrder(double& l, double& m, double& r) {
  const double lower = std::min(l, m), upper = std::max(l, m);
  l = std::min(lower, r);
  m = std::max(lower, std::min(upper, r));
  r = std::max(upper, r);
}

Look lookAt(const Rim& rim, const Pose& pose) {
  Look look;
  for (std::size_t k = 0; k < rim.count; ++k) {
    double l = pose.squared[k], m = rim.squared[k], r = pose.squared[k + 1];
    double a = pose.root[k], b = rim.root[k], c = pose.root[k + 1];
    inOrder(l, m, r);
    inOrder(a, b, c);
    const double area = pose.area[k];
    look.sure &= (area > kAboveZero * r) & (m * r < kWithin * 4.0 * area * area);
    look.slender |= !(r < kClearly * kLargeEdgeRatio * kLargeEdgeRatio * l);
    look.shortest = std::min(look.shortest, l);
    look.obtuse += r > l + m ? 1 : 0;
    look.worst = std::max(look.worst, a * b * c * (a + b + c) / (2.0 * area * area));
  }
  return look;
}

// The triangle beyond a rim, or at a border the one within.
double beyond(const Rim& rim, const Pose& pose, std::size_t k) {
  return rim.beyond[k] < 0.0 ? pose.area[k] : rim.beyond[k];
}

bool within(double l, double r, double limit) { return std::max(l, r) < limit * std::min(l, r); }

bool areasWithin(const Rim& rim, const Pose& pose, double limit) {
  bool all = true;
  for (std::size_t k = 0; k < rim.count; ++k) {
    all &= within(pose.area[k], pose.area[k + 1], limit);
    all &= within(pose.area[k], beyond(rim, pose, k), limit);
  }
  return all;
}

double ratioOf(double l, double r) { return std::max(l, r) / std::min(l, r); }

double areaRatioOf(const Rim& rim, const Pose& pose) {
  double ratio = 1.0;
  for (std::size_t k = 0; k < rim.count; ++k) {
    ratio = std::max(ratio, ratioOf(pose.area[k], pose.area[k + 1]));
    ratio = std::max(ratio, ratioOf(pose.area[k], beyond(rim, pose, k)));
  }
  return ratio;
}

double edgeRatioOf(const Rim& rim, const Pose& pose) {  // squared
  double ratio = 1.0;
  for (std::size_t k = 0; k < rim.count; ++k) {
    const auto [shortest, longest] = std::minmax({pose.squared[k], rim.squared[k], pose.squared[k + 1]});
    ratio = std::max(ratio, longest / shortest);
  }
  return ratio;
}

double radiusOf(const Rim& rim, const Pose& pose) {  // over the shortest edge, squared
  double radius = Badness{}.radius;
  for (std::size_t k = 0; k < rim.count; ++k) {
    double l = pose.squared[k], m = rim.squared[k], r = pose.squared[k + 1];
    inOrder(l, m, r);
    radius = std::max(radius, m * r / (4.0 * pose.area[k] * pose.area[k]));
  }
  return radius;
}

// The angles opposite an edge sum up to clearly less than 180°, for every spoke and every rim.
bool staysDelaunay(const Mesh& mesh, const Wheel& wheel, const Rim& rim, const Pose& pose) {
  const std::size_t n = rim.count;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t last = k == 0 ? n - 1 : k - 1;
    const double spoke = pose.squared[k];
    const double right = pose.squared[last] + rim.squared[last] - spoke;  // 2 |..| |..| cos of the angle opposite
    const double left = pose.squared[k + 1] + rim.squared[k] - spoke;
    const double scale = spoke + rim.squared[k] + rim.squared[last];
    if (!(right * pose.area[k] + left * pose.area[last] > kAboveZero * scale * scale)) return false;
    const Half across = wheel.spokes[k].across;
    if (!across.exists()) continue;
    const Point q = pointOf(mesh, apexOf(mesh, across));
    const Point s = wheel.spokes[k].at, e = wheel.spokes[k + 1 == n ? 0 : k + 1].at;
    const double far = 2.0 * dot(s - q, e - q), near = spoke + pose.squared[k + 1] - rim.squared[k];
    const double size = spoke + pose.squared[k + 1] + rim.squared[k] + squaredDistance(s, q);
    if (!(far * pose.area[k] + near * rim.beyond[k] > kAboveZero * size * size)) return false;
  }
  return true;
}

// Puts the hub into its new place, and keeps of Mesh::tested what is known to hold there.
void place(Mesh& mesh, const Wheel& wheel, Point to, const Rim& rim, const Pose& pose) {
  mesh.points[wheel.hub] = to;
  const std::size_t n = rim.count;
  constexpr double kEvenRatio = kClearly * kLargeAreaRatio;
  bool evenLast = within(pose.area[n - 1], pose.area[0], kEvenRatio);
  for (std::size_t k = 0; k < n; ++k) {
    const double l = pose.squared[k], m = rim.squared[k], r = pose.squared[k + 1];
    const bool acute = 2.0 * std::max(std::max(l, m), r) < kClearly * (l + m + r);
    const bool evenNext = within(pose.area[k], pose.area[k + 1], kEvenRatio);
    const bool evenBeyond = within(pose.area[k], beyond(rim, pose, k), kEvenRatio);
    const Spoke& spoke = wheel.spokes[k];
    mesh.tested[spoke.slot] =
        static_cast<std::uint8_t>((acute ? kAcute : 0) | (evenLast && evenNext && evenBeyond ? kEven : 0));
    if (spoke.across.exists()) {
      mesh.tested[triangleOf(spoke.across)] &= static_cast<std::uint8_t>(kAcute | (evenBeyond ? kEven : 0));
    }
    noteTouched(mesh, spoke.slot);
    evenLast = evenNext;
  }
}

}  // namespace

Verdict tryInFull(MeshState& state, const Move& move, TrialRoom& room) {
  Mesh& mesh = state.mesh;
  room.before.clear();
  std::uint8_t finestRank = mesh.density[move.vertex];
  for (const Spoke& spoke : room.wheel.spokes) {
    room.before.push_back(spoke.slot);
    finestRank = std::min(finestRank, mesh.density[spoke.rim]);
  }
  Badness was = badnessOf(mesh, room.before);
  if (!moveVertex(mesh, move.vertex, move.to, room.log)) return {Refusal::inverts_triangle, 0.0, 0.0};
  const Badness is = badnessOf(mesh, room.log.slots);
  const bool flipped = room.log.flips > 0;
  if (flipped) {  // the region has grown by the triangles flipped: look at all of it as it was
    undoMove(mesh, room.log);
    was = badnessOf(mesh, room.log.slots);
  }
  const Verdict verdict = judged(state, move.rule, was, is, shortestAllowed(state, finestRank));
  if (verdict.refusal == Refusal::none && flipped) moveVertex(mesh, move.vertex, move.to, room.log);
  if (verdict.refusal != Refusal::none && !flipped) undoMove(mesh, room.log);
  return verdict;
}

bool tryInPlace(MeshState& state, const Move& move, const Wheel& wheel, Verdict& verdict) {
  if (wheel.spokes.size() > kMost) return false;
  Mesh& mesh = state.mesh;
  Rim rim;
  Pose from, to;
  rimOf(mesh, wheel, rim);
  poseOf(wheel, pointOf(mesh, wheel.hub), from);
  poseOf(wheel, move.to, to);
  const Look before = lookAt(rim, from), after = lookAt(rim, to);
  if (!before.sure || !after.sure || !staysDelaunay(mesh, wheel, rim, to)) return false;
  constexpr double kLargest = kWithin * kBoundAreaRatio;
  if (!areasWithin(rim, from, kLargest) || !areasWithin(rim, to, kLargest)) return false;

  Badness was, is;
  was.obtuse = before.obtuse, is.obtuse = after.obtuse;
  was.worst = before.worst, is.worst = after.worst;
  was.shortest = before.shortest, is.shortest = after.shortest;
  // Ratios count only where they grow large, or where they are what the move is to improve.
  const bool polish = move.rule == Rule::polish;
  if (polish || after.slender) was.edgeRatio = edgeRatioOf(rim, from), is.edgeRatio = edgeRatioOf(rim, to);
  if (polish || move.rule == Rule::shared_edge || !areasWithin(rim, to, kClearly * kLargeAreaRatio)) {
    was.areaRatio = areaRatioOf(rim, from), is.areaRatio = areaRatioOf(rim, to);
  }
  if (polish) was.radius = radiusOf(rim, from), is.radius = radiusOf(rim, to);
  double minEdge = 0.0;
  if (is.shortest < was.shortest && is.shortest < state.minEdge * state.minEdge) {
    std::uint8_t finestRank = mesh.density[wheel.hub];
    for (const Spoke& spoke : wheel.spokes) finestRank = std::min(finestRank, mesh.density[spoke.rim]);
    minEdge = shortestAllowed(state, finestRank);
  }
  verdict = judged(state, move.rule, was, is, minEdge);
  if (verdict.refusal == Refusal::none) place(mesh, wheel, move.to, rim, to);
  return true;
}

Outcome decideMove(MeshState& state, Journal& journal, const Move& move, TriangleId subject, TrialRoom& room) {
  const Point from = pointOf(state.mesh, move.vertex);
  const TriangleId firstId = state.mesh.nextId;
  Verdict verdict;
  if (!tryInPlace(state, move, room.wheel, verdict)) verdict = tryInFull(state, move, room);
  StageCounts& counts = state.counts[state.stage];
  const bool moved = verdict.refusal == Refusal::none;
  ++(moved ? counts.moved : counts.refused);
  if (moved) ++state.cursor.changes;
  if (journal.listening()) {
    Event event = eventIn(state, moved ? EventKind::vertex_moved : EventKind::vertex_kept, move.rule);
    event.refusal = verdict.refusal;
    event.subject = subject.n;
    event.vertex = move.vertex.word();
    event.at = move.to;
    event.from = from;
    event.measured = verdict.measured;
    event.limit = verdict.limit;
    if (state.mesh.nextId > firstId) {
      event.created = firstId.n;
      event.createdCount = state.mesh.nextId.n - firstId.n;
    }
    journal.record(event);
  }
  return Outcome::decided;
}

}  // namespace triscope
