// A check of tables whose rows are found by the number of what they are about.
#pragma once

#include <cstddef>

namespace triscope {

/// Whether each row stands where the number of its `id` says.
template <class Table>
constexpr bool standsByIds(const Table& table) {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (static_cast<std::size_t>(table[k].id) != k) return false;
  return true;
}

}  // namespace triscope
