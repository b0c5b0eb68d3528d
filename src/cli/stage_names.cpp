#include "cli/stage_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "core/method/method.h"

namespace triscope {
namespace {

/// Some names stand for several stages: "fronts" is over when the second front is, "rounds" when a whole round of
/// steps 2 to 5 has inserted nothing and the repairs are made.
struct StageName {
  std::string_view name;
  Stage last;
};

std::vector<StageName> names() {
  std::vector<StageName> list;
  const std::span<const Stage> all = paperMethod().stages;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const StageInfo& info = infoOf(all[k]);
    if (!inRounds(info.id)) list.push_back({info.key, info.id});
    const bool last = k + 1 == all.size() || infoOf(all[k + 1]).group != info.group;
    const std::string_view group = groupKey(info.group);
    if (last && !group.empty()) list.push_back({group, info.id});
  }
  return list;
}

bool comesAgain(std::string_view name) {
  return std::ranges::any_of(stages(), [name](const StageInfo& info) { return info.key == name && inRounds(info.id); });
}

}  // namespace

Result<Stage> stageNamed(std::string_view name) {
  for (const StageName& entry : names())
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
  for (const StageName& entry : names()) {
    if (!list.empty()) list += ", ";
    list += entry.name;
  }
  return list;
}

}  // namespace triscope
