// Reading one loop or chain of a domain file into curves.
#pragma once

#include "core/base/json_value.h"
#include "core/base/result.h"
#include "core/domain/draft.h"

namespace triscope {

/// Adds the loop to the draft, not yet oriented or checked against others. `number` counts from 1 within its list
/// and makes the name where none is given.
Status readLoop(const JsonValue& value, LoopRole role, int number, DomainDraft& draft);

}  // namespace triscope
