// Reading what a domain file asks of the density.
#pragma once

#include "core/domain/domain.h"
#include "core/domain/json_value.h"
#include "core/result.h"

namespace triscope {

/// Reads the list under "density" into domain.density. Loops, bounds and minEdgeLength must be there already.
Status readDensity(const JsonValue& value, Domain& domain);

}  // namespace triscope
