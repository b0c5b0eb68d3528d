#include "core/domain/loop_of.h"

#include <algorithm>

namespace triscope {

const Loop& loopOf(const Domain& domain, std::uint32_t curve) {
  // Loops list their curves in order, one loop after the other.
  const auto after = std::upper_bound(domain.loops.begin(), domain.loops.end(), curve,
                                      [](std::uint32_t c, const Loop& loop) { return c < loop.firstCurve; });
  return *(after - 1);
}

}  // namespace triscope
