// What a domain comes to in 64 bits, for whoever keeps something that was made from it.
#pragma once

#include <cstdint>

#include "core/domain/domain.h"

namespace triscope {

/// Digest of all that a domain holds, but for the file it was read from and that file's text, which says the same.
std::uint64_t hashOf(const Domain& domain);

}  // namespace triscope
