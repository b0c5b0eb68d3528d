// A domain's own file with another density: what an edit in the window is saved and exported as.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/domain/domain.h"

namespace triscope {

/// A domain file, valid JSON, with this list under "density". Everything else in it stays as it was written.
std::string withDensity(std::string_view file, const std::vector<DensityRequest>& density);

/// The same domain asking for another density, text included. Each request must be one that readDensity() would take:
/// within the bounds, by a rank from 1 to 64 or a length from minEdgeLength.
std::shared_ptr<const Domain> withDensity(const Domain& domain, std::vector<DensityRequest> density);

}  // namespace triscope
