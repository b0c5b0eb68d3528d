// What step 6 remembers of triangles from pass to pass, so that it need not look at them again.
#pragma once

#include <bit>
#include <cstring>

#include "core/mesh/edit.h"

namespace triscope {

// Bits of Mesh::tested in step 6. They are cleared where a triangle or a neighbour changes, unless it is known that
// they hold all the same.
inline constexpr std::uint8_t kTried = 8;        // polished in vain, or about to be
inline constexpr std::uint8_t kEven = 16;        // no neighbour is larger by kLargeAreaRatio
inline constexpr std::uint8_t kAcute = 32;       // not obtuse
inline constexpr std::uint8_t kSettled = 64;     // unchanged through a whole pass: the next would refuse the same again
inline constexpr std::uint8_t kUnchanged = 128;  // since this pass began

inline bool settled(const Mesh& mesh, Slot slot) { return (mesh.tested[slot] & kSettled) != 0; }

/// The first slot at or after `from` that is not settled and not known to be `well` (kEven or kAcute); the number of
/// slots when there is none. Free slots have every bit. Eight slots with nothing to look at cost one comparison.
inline std::size_t nextOpen(const Mesh& mesh, std::size_t from, std::uint8_t well) {
  const std::size_t count = mesh.tested.size();
  const int up = std::countr_zero(kSettled) - std::countr_zero(well);
  const std::uint64_t settledEight = 0x0101010101010101ull * kSettled;
  for (std::size_t slot = from; slot < count; ++slot) {
    while (slot % 8 == 0 && slot + 8 <= count) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, mesh.tested.data() + slot, 8);
      if (((eight | eight << up) & settledEight) != settledEight) break;
      slot += 8;
    }
    if (slot < count && (mesh.tested[Slot(slot)] & (kSettled | well)) == 0) return slot;
  }
  return count;
}

}  // namespace triscope
