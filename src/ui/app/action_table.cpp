// The table of actions, put together from its parts. docs/keys.md is printed from it.
#include <algorithm>

#include "ui/app/action_table_debug.h"
#include "ui/app/action_table_run.h"
#include "ui/app/action_table_view.h"
#include "ui/model/action.h"

namespace triscope {
namespace {

constexpr std::array<ActionInfo, kActionCount> joined() {
  static_assert(kRunActions.size() + kDebugActions.size() + kViewActions.size() == kActionCount);
  std::array<ActionInfo, kActionCount> all{};
  auto end = std::copy(kRunActions.begin(), kRunActions.end(), all.begin());
  end = std::copy(kDebugActions.begin(), kDebugActions.end(), end);
  std::copy(kViewActions.begin(), kViewActions.end(), end);
  return all;
}
constexpr std::array<ActionInfo, kActionCount> kActions = joined();

constexpr bool inOrder() {
  for (int i = 0; i < kActionCount; ++i)
    if (static_cast<int>(kActions[static_cast<std::size_t>(i)].id) != i) return false;
  return true;
}
static_assert(inOrder());

}  // namespace

std::span<const ActionInfo> actions() { return kActions; }

}  // namespace triscope
