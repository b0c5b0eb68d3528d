// Is a domain one that can be meshed? Exact: no tolerance decides.
#pragma once

#include "core/base/result.h"
#include "core/domain/draft.h"

namespace triscope {

/// Orients the loops, fills in the bounds, and checks that they are simple, disjoint and nested as they must be.
/// Arcs and splines are judged by chords that turn by about one degree. Errors name loop, point and place.
Result<Domain> checkDomain(DomainDraft draft);

/// The same for a domain made in memory; points are then numbered by the curves that start at them.
Result<Domain> checkDomain(Domain domain);

}  // namespace triscope
