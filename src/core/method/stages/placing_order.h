// The order in which many points along a long line are placed.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace triscope {

/// The order to place n points in that follow one another: as they are, or, where they are more than `mostInOrder`,
/// every 16th first, coarse to fine. One after the other along a long line, each point's cavity takes in some √n of the
/// edges ahead of it, or of the points on the far side.
inline std::vector<std::int32_t> placingOrder(std::size_t n, std::size_t mostInOrder) {
  constexpr std::size_t kAhead = 16;
  std::vector<std::int32_t> order;
  order.reserve(n);
  const bool many = n > mostInOrder;
  if (many) {
    order.push_back(0);
    for (std::size_t stride = std::bit_floor(n); stride >= kAhead; stride /= 2)
      for (std::size_t k = stride; k < n; k += 2 * stride) order.push_back(static_cast<std::int32_t>(k));
  }
  for (std::size_t k = 0; k < n; ++k)
    if (!many || k % kAhead != 0) order.push_back(static_cast<std::int32_t>(k));
  return order;
}

}  // namespace triscope
