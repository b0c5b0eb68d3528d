// Reading what a domain file asks of the density.
#pragma once

#include "core/base/json_value.h"
#include "core/base/result.h"
#include "core/domain/domain.h"

namespace triscope {

/// Reads the list under "density" into domain.density. Loops, bounds and minEdgeLength must be there already.
Status readDensity(const JsonValue& value, Domain& domain);

}  // namespace triscope
