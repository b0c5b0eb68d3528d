// What step 6 remembers of triangles and vertices from pass to pass, so that it need not look at them again.
#pragma once

#include <bit>
#include <cstring>
#include <vector>

#include "core/mesh/edit.h"

namespace triscope {

// Bits of Mesh::tested in step 6. They are cleared where a triangle or a neighbour changes, unless it is known that
// they hold all the same.
inline constexpr std::uint8_t kEven = 16;        // no neighbour is larger by kLargeAreaRatio
inline constexpr std::uint8_t kAcute = 32;       // not obtuse
inline constexpr std::uint8_t kSettled = 64;     // unchanged through a whole pass: the next would refuse the same again
inline constexpr std::uint8_t kUnchanged = 128;  // since this pass began

inline bool settled(const Mesh& mesh, std::int32_t slot) { return (mesh.tested[at(slot)] & kSettled) != 0; }

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
    if (slot < count && (mesh.tested[slot] & (kSettled | well)) == 0) return slot;
  }
  return count;
}

/// A set of vertices, 32 a word.
using VertexMarks = std::vector<std::int32_t>;

inline void mark(VertexMarks& marks, std::int32_t vertex) {
  std::int32_t& word = marks[at(vertex >> 5)];
  word = static_cast<std::int32_t>(static_cast<std::uint32_t>(word) | 1u << (vertex & 31));
}

/// The first vertex marked at or after `from`; the number of places for marks when there is none.
inline std::uint64_t nextMarked(const VertexMarks& marks, std::uint64_t from) {
  for (std::uint64_t word = from >> 5; word < marks.size(); ++word) {
    auto left = static_cast<std::uint32_t>(marks[word]);
    if (word == from >> 5) left &= ~0u << (from & 31);
    if (left != 0) return 32 * word + static_cast<std::uint64_t>(std::countr_zero(left));
  }
  return 32 * marks.size();
}

}  // namespace triscope
