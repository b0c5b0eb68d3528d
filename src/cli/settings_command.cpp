// triscope settings: the table of settings, one a line, and that of the presets.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/words/preset.h"

namespace triscope {
namespace {

std::string range(const SettingInfo& info) {
  if (isNamed(info)) return info.member.kind == SettingKind::on_off ? "on, off" : "by name";
  if (info.highest > 1e100) return fmt::format(">= {:g}", info.lowest);
  return fmt::format("{:.9g} .. {:.9g}", info.lowest, info.highest);
}

std::string paperRange(const SettingInfo& info) {
  return info.paperLow < info.paperHigh ? fmt::format("{:g} .. {:g}", info.paperLow, info.paperHigh) : "";
}

}  // namespace

ExitCode runCommand(const SettingsCommand&) {
  constexpr auto row = "{:<16} {:<3} {:<13} {:<14} {:<13} {:<10} {}\n";
  answer(fmt::runtime(row), "setting", "", "default", "range", "paper's range", "unit", "what it does");
  for (const SettingInfo& info : settingTable())
    answer(fmt::runtime(row), info.key, info.symbol, valueText(info, settingValue(Settings{}, info)), range(info),
           paperRange(info), info.unit,
           info.member.kind == SettingKind::named ? fmt::format("{} Give {}.", info.help, rangeText(info))
                                                  : std::string(info.help));
  answer("\n");
  constexpr auto presetRow = "{:<16} {}\n";
  answer(fmt::runtime(presetRow), "preset", "what it is for, and what it sets");
  for (const Preset& preset : presets()) {
    std::string sets;
    for (const PresetValue& value : preset.values) sets += fmt::format(" {}={}", value.key, value.value);
    answer(fmt::runtime(presetRow), preset.key, preset.help);
    answer(fmt::runtime(presetRow), "", sets.substr(1));
  }
  return ExitCode::ok;
}

}  // namespace triscope
