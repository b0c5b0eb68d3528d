// The names that --until and --stage take for the stages of the method.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/words/stage.h"

namespace triscope {

/// The last stage that a name stands for. The error lists the names, and says why a stage of the rounds has none.
Result<Stage> stageNamed(std::string_view name);
/// All names, in the order that the stages run, separated by commas.
std::string stageNames();

}  // namespace triscope
