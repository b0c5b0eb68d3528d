// Which way round a loop runs, and turning it.
#pragma once

#include "core/domain/draft.h"

namespace triscope {

/// The same curve from b to a.
Curve reversed(const Curve& curve);

/// Makes the outer loop counter-clockwise and holes clockwise, and fills in the bounds. Sources follow.
/// The sense of a loop that crosses itself is unspecified: checkDomain refuses it.
void orient(DomainDraft& draft);

}  // namespace triscope
