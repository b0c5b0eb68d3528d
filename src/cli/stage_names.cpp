#include "cli/stage_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/method/pipeline.h"

namespace triscope {
namespace {

/// Some names stand for several stages: "fronts" is over when the second front is, "rounds" when a whole round of
/// steps 2 to 5 has inserted nothing and the repairs are made.
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
    StageName{"front1", Stage::front1},
    StageName{"front2", Stage::front2},
    StageName{"fronts", Stage::front2},
    StageName{"step1", Stage::step1},
    StageName{"rounds", Stage::step5},
    StageName{"refine", Stage::refine},
};

bool comesAgain(std::string_view name) {
  return std::ranges::any_of(stages(), [name](const StageInfo& info) { return info.key == name && inRounds(info.id); });
}

}  // namespace

Result<Stage> stageNamed(std::string_view name) {
  for (const StageName& entry : kNames)
    if (entry.name == name) return entry.last;
  if (comesAgain(name))
    return Error{.kind = ErrorKind::usage,
                 .message = fmt::format("the stage '{}' comes again in every round, so a run cannot end with it", name),
                 .hint = fmt::format("name rounds, which end with the last repair, or another of {}; 'triscope debug "
                                     "DOMAIN --goto stage={}' goes to where it first begins",
                                     stageNames(), name)};
  return Error{.kind = ErrorKind::usage,
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
