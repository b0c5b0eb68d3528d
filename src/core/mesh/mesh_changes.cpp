#include "core/mesh/mesh_changes.h"

#include <algorithm>
#include <cstring>

#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr std::size_t kRun = 256;  // elements that are compared at once: nearly all of them are the same

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b, std::size_t first, std::size_t count) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Point>);
  return std::memcmp(a.data() + first, b.data() + first, count * sizeof(T)) == 0;
}

bool sameSlots(const Mesh& a, const Mesh& b, std::size_t first, std::size_t count) {
  return sameBytes(a.triangles, b.triangles, first, count) && sameBytes(a.ids, b.ids, first, count) &&
         sameBytes(a.flags, b.flags, first, count);
}

}  // namespace

std::optional<std::vector<Slot>> changedSlots(const Mesh& before, const Mesh& after, std::size_t most) {
  std::vector<Slot> changed;
  const std::size_t slots = std::min(before.triangles.size(), after.triangles.size());
  if (after.triangles.size() - slots > most) return std::nullopt;
  for (std::size_t slot = slots; slot < after.triangles.size(); ++slot) changed.emplace_back(slot);
  for (std::size_t first = 0; first < slots; first += kRun) {
    const std::size_t count = std::min(kRun, slots - first);
    if (sameSlots(before, after, first, count)) continue;
    for (std::size_t slot = first; slot < first + count; ++slot)
      if (!sameSlots(before, after, slot, 1)) changed.emplace_back(slot);
    if (changed.size() > most) return std::nullopt;
  }
  // The triangles of a vertex that is new have not been there before.
  const std::size_t vertices = std::min(before.points.size(), after.points.size());
  Star star;
  for (std::size_t first = 0; first < vertices; first += kRun) {
    const std::size_t count = std::min(kRun, vertices - first);
    if (sameBytes(before.points, after.points, first, count)) continue;
    for (std::size_t v = first; v < first + count; ++v) {
      if (sameBytes(before.points, after.points, v, 1) || !after.vertexTriangle[Vertex(v)].exists()) continue;
      starOf(after, Vertex(v), star);
      for (const Half half : star.rim) changed.push_back(triangleOf(half));
    }
    if (changed.size() > most) return std::nullopt;
  }
  return changed;
}

}  // namespace triscope
