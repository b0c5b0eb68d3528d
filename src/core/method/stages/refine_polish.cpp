#include "core/method/stages/refine_polish.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/mesh/edit.h"
#include "core/mesh/tested.h"
#include "core/method/stages/refine_marks.h"

namespace triscope {
namespace {

constexpr double kPoor = 0.88;     // strain from which a triangle is polished
constexpr double kNearPoor = 0.7;  // … and from which it may come to be, as the worst of the mesh becomes less

// Places to try: part of the way to the mean of the neighbours, then off to the sides by a part of the shortest spoke.
constexpr std::array<double, 4> kInward = {1.0, 0.5, 0.25, 0.125};
constexpr std::array<Point, 8> kSideways = {
    {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}}};
constexpr std::array<double, 3> kSteps = {0.1, 0.03, 0.25};
constexpr std::uint64_t kPlacesToTry = kInward.size() + kSteps.size() * kSideways.size();

// The triangles that may be poor: those that were not far from it at the start, and what has changed since.
std::vector<Slot> candidates(const Mesh& mesh, const std::vector<Slot>& nearPoor) {
  std::vector<Slot> changed;
  forEachUntested(mesh, kSettled, [&](Slot slot) { changed.push_back(slot); });
  std::vector<Slot> slots;
  std::ranges::set_union(nearPoor, changed, std::back_inserter(slots));  // both ascend
  return slots;
}

// The vertices of the poor and the obtuse triangles that have changed since they were last tried.
void choose(MeshState& state) {
  Polishing& polishing = state.cursor.of<Polishing>();
  Mesh& mesh = state.mesh;
  const std::vector<Slot> slots = candidates(mesh, polishing.nearPoor);
  std::vector<Badness> badness;
  Worst worst;
  for (const Slot slot : slots) include(worst, badness.emplace_back(badnessOf(mesh, slot)));
  polishing.worst = worst;
  std::vector<Vertex>& vertices = polishing.vertices;
  vertices.clear();
  for (std::size_t k = 0; k < slots.size(); ++k) {
    std::uint8_t& tested = mesh.tested[slots[k]];
    if ((tested & kTried) != 0 || (badness[k].obtuse == 0 && strainOf(badness[k], worst) < kPoor)) continue;
    tested |= kTried;
    for (const Vertex v : triangleAt(mesh, slots[k]).v)
      if (movable(mesh, v)) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

Point placeToTry(const Wheel& wheel, Point from, std::uint64_t number) {
  if (number < kInward.size()) {
    Point sum;
    for (const Spoke& spoke : wheel.spokes) sum = sum + (spoke.at - from);
    return from + (kInward[number] / static_cast<double>(wheel.spokes.size())) * sum;
  }
  number -= kInward.size();
  double nearest = 1e300;
  for (const Spoke& spoke : wheel.spokes) nearest = std::min(nearest, squaredDistance(from, spoke.at));
  const double step = kSteps[number / kSideways.size()] * std::sqrt(nearest);
  return from + step * kSideways[number % kSideways.size()];
}

}  // namespace

void beginPolish(MeshState& state) {
  Mesh& mesh = state.mesh;
  std::vector<Slot>& nearPoor = state.cursor.of<Polishing>().nearPoor;
  Worst worst;
  const auto isNearPoor = [&](const Badness& badness) { return strainOf(badness, worst) > kNearPoor; };
  forEachUntested(mesh, kSettled, [&](Slot slot) {
    std::uint8_t& tested = mesh.tested[slot];
    if ((tested & kAcute) != 0 && (tested & kEven) != 0) tested |= kSettled;
    if (!state.settings.polish) return;
    const Badness badness = badnessOf(mesh, slot);
    include(worst, badness);
    if (isNearPoor(badness)) nearPoor.push_back(slot);  // against the worst so far, which can only grow
  });
  std::erase_if(nearPoor, [&](Slot slot) { return !isNearPoor(badnessOf(mesh, slot)); });
}

Outcome runPolish(MeshState& state, Journal& journal, TrialRoom& room) {
  Cursor& cursor = state.cursor;
  if (cursor.index == 0) choose(state);
  const std::vector<Vertex>& vertices = cursor.of<Polishing>().vertices;
  for (; cursor.index < kPlacesToTry * vertices.size(); ++cursor.index) {
    const Vertex vertex = vertices[cursor.index / kPlacesToTry];
    const std::uint64_t number = cursor.index % kPlacesToTry;
    if (!gather(state.mesh, vertex, room.wheel)) continue;
    const Move move{Rule::polish, vertex, placeToTry(room.wheel, pointOf(state.mesh, vertex), number)};
    const std::uint64_t changes = cursor.changes;
    decideMove(state, journal, move, {}, room);
    cursor.index += cursor.changes == changes ? 1 : kPlacesToTry - number;  // on to the next vertex after a move
    return Outcome::decided;
  }
  return Outcome::done;
}

}  // namespace triscope
