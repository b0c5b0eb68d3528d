// Finding the few triangles that a rule has not looked at since they changed, without looking at all the others.
#pragma once

#include <cstring>

#include "core/mesh/mesh.h"

namespace triscope {

// Bits of Mesh::tested: step 1 to step 5 are bits 0 to 4.
inline constexpr std::uint8_t kTestedRepair = 32;  // breaks no bound, or nothing helps

/// Calls visit(slot) for each live slot whose `tested` lacks the bit, in ascending order. Free slots have every bit
/// set. Eight slots that are all done cost one comparison, so a round that changed little costs little.
template <class Visit>
void forEachUntested(const Mesh& mesh, std::uint8_t bit, const Visit& visit) {
  const std::size_t count = mesh.tested.size();
  const std::uint64_t mask = 0x0101010101010101ull * bit;
  std::size_t slot = 0;
  while (slot < count) {
    if (slot + 8 <= count) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, mesh.tested.data() + slot, 8);
      if ((eight & mask) == mask) {
        slot += 8;
        continue;
      }
    }
    const std::size_t end = slot + 8 < count ? slot + 8 : count;
    for (; slot < end; ++slot) {
      if ((mesh.tested[Slot(slot)] & bit) == 0) visit(Slot(slot));
    }
  }
}

}  // namespace triscope
