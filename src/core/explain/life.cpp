#include "core/explain/life.h"

namespace triscope {
namespace {

/// The last tick in [0, end] whose keyframe still meets a test that holds for keyframes up to some point only.
template <class Test>
const Keyframe& lastKeyframe(const History& history, std::uint64_t end, Test test) {
  std::uint64_t low = 0;
  std::uint64_t high = end;
  while (low < high) {
    const std::uint64_t middle = low + (high - low + 1) / 2;
    if (test(history.before(middle)))
      low = middle;
    else
      high = middle - 1;
  }
  return history.before(low);
}

bool has(const Mesh& mesh, Slot slot, TriangleId triangle) { return mesh.alive(slot) && idOf(mesh, slot) == triangle; }

}  // namespace

std::optional<TriangleFacts> factsOf(const Mesh& mesh, TriangleId triangle) {
  const Slot slot = slotOf(mesh, triangle);
  if (!slot.exists()) return std::nullopt;
  TriangleFacts facts;
  for (std::size_t i = 0; i < 3; ++i) facts.corners[i] = triangleAt(mesh, slot).v[i].word();
  return facts;
}

TriangleFacts factsOf(const History& history, std::uint64_t end, Events events, TriangleId triangle) {
  TriangleFacts facts;
  const std::optional<std::size_t> birth = birthOf(events, {Ref::Kind::triangle, triangle.n});
  if (!birth && triangle.n > 1) return facts;
  // Keyframes before its birth pass too: the search ends at the last that has it, or the last before its birth.
  const Keyframe& keyframe = lastKeyframe(history, end, [&](const Keyframe& k) {
    return (birth && k.events <= *birth) || k.state.mesh.nextId <= triangle || slotOf(k.state.mesh, triangle).exists();
  });
  MeshState state = history.stateBefore(keyframe.state.tick);
  std::vector<Event> replayed;
  Journal journal{&replayed};
  Slot slot = slotOf(state.mesh, triangle);
  for (;;) {
    if (!slot.exists() && state.mesh.nextId > triangle) {
      slot = slotOf(state.mesh, triangle);
      // A decision of two edits can make a triangle and end it: then the mesh never shows it between two decisions.
      if (!slot.exists()) break;
    }
    if (slot.exists()) {
      if (!has(state.mesh, slot, triangle)) {
        facts.death = static_cast<std::size_t>(keyframe.events) + replayed.size() - 1;
        break;
      }
      if (facts.corners[0] == kNoId) facts = *factsOf(state.mesh, triangle);
    }
    if (state.tick >= end || !advance(state, Grain::decision, journal)) break;
  }
  return facts;
}

}  // namespace triscope
