// Requests for density in words.
#pragma once

#include <string>
#include <vector>

#include "core/domain/domain.h"

namespace triscope {

/// "density entry 'wake'", or its number where it has no name.
std::string requestName(const Domain& domain, std::size_t index);

/// A sentence for each request that asks for less than Δx, and so does not get it.
std::vector<std::string> requestsCut(const Domain& domain, double minEdge);

}  // namespace triscope
