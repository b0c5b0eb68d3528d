// Which loop or chain a curve is part of.
#pragma once

#include <cstdint>

#include "core/domain/domain.h"

namespace triscope {

/// The loop that has this curve, an index into Domain::curves: every curve is in one.
const Loop& loopOf(const Domain& domain, std::uint32_t curve);

}  // namespace triscope
