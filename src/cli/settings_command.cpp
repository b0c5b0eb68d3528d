// triscope settings: the table of settings, one a line.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/messages.h"

namespace triscope {
namespace {

std::string range(const SettingInfo& info) {
  std::string names;
  for (const NamedValue& named : info.names) names.append(names.empty() ? "" : ", ").append(named.name);
  if (!names.empty()) return names;
  if (info.highest > 1e100) return fmt::format(">= {:g}", info.lowest);
  return fmt::format("{:.9g} .. {:.9g}", info.lowest, info.highest);
}

std::string paperRange(const SettingInfo& info) {
  return info.paperLow < info.paperHigh ? fmt::format("{:g} .. {:g}", info.paperLow, info.paperHigh) : "";
}

}  // namespace

ExitCode runCommand(const SettingsCommand&) {
  constexpr auto row = "{:<16} {:<3} {:<8} {:<14} {:<13} {:<10} {}\n";
  answer(fmt::runtime(row), "setting", "", "default", "range", "paper's range", "unit", "what it does");
  for (const SettingInfo& info : settingTable())
    answer(fmt::runtime(row), info.key, info.symbol, valueText(info, settingValue(Settings{}, info)), range(info),
           paperRange(info), info.unit, info.help);
  return ExitCode::ok;
}

}  // namespace triscope
