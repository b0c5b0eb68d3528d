// The table of actions, put together from its parts. docs/keys.md is printed from it.
#include <algorithm>

#include "ui/app/actions_compare.h"
#include "ui/app/actions_debug.h"
#include "ui/app/actions_edit.h"
#include "ui/app/actions_file.h"
#include "ui/app/actions_run.h"
#include "ui/app/actions_view.h"
#include "ui/model/action.h"

namespace triscope {
namespace {

template <std::size_t... Counts>
constexpr auto joined(const std::array<ActionInfo, Counts>&... parts) {
  std::array<ActionInfo, (Counts + ...)> all{};
  auto end = all.begin();
  ((end = std::copy(parts.begin(), parts.end(), end)), ...);
  return all;
}
constexpr auto kActions = joined(kFileActions, kRunActions, kEditActions, kDebugActions, kCompareActions, kViewActions);

constexpr bool inOrder() {
  for (std::size_t k = 0; k < kActions.size(); ++k)
    if (static_cast<std::size_t>(kActions[k].id) != k) return false;
  return kActions.size() == static_cast<std::size_t>(kActionCount);
}
static_assert(inOrder());

}  // namespace

std::span<const ActionInfo> actions() { return kActions; }

}  // namespace triscope
