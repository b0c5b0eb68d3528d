// The table of actions, put together from its parts. docs/keys.md is printed from it.
#include <algorithm>

#include "core/base/stands_by_ids.h"
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

static_assert(kActions.size() == kActionCount && standsByIds(kActions));

}  // namespace

std::span<const ActionInfo> actions() { return kActions; }

}  // namespace triscope
