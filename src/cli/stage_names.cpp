#include "cli/stage_names.h"

#include <fmt/format.h>

#include <array>

namespace triscope {
namespace {

/// Some names stand for several stages: "fronts" is over when the second front is, "rounds" when a whole round of
/// steps 2 to 5 has inserted nothing.
struct StageName {
  std::string_view name;
  Stage last;
};
constexpr std::array kNames{
    StageName{"constraints", Stage::constraints},
    StageName{"quadtree", Stage::quadtree},
    StageName{"density", Stage::density},
    StageName{"boundary", Stage::boundary},
    StageName{"triangulation", Stage::triangulation},
    StageName{"recovery", Stage::recovery},
    StageName{"carve", Stage::carve},
    StageName{"fronts", Stage::front2},
    StageName{"step1", Stage::step1},
    StageName{"rounds", Stage::step5},
    StageName{"refine", Stage::refine},
};

}  // namespace

Result<Stage> stageNamed(std::string_view name) {
  for (const StageName& entry : kNames)
    if (entry.name == name) return entry.last;
  return Error{.code = ExitCode::usage,
               .message = fmt::format("there is no stage '{}'", name),
               .hint = fmt::format("the stages are {}", stageNames())};
}

std::string stageNames() {
  std::string list;
  for (const StageName& entry : kNames) {
    if (!list.empty()) list += ", ";
    list += entry.name;
  }
  return list;
}

}  // namespace triscope
