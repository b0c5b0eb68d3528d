#include "core/words/preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/shown_text.h"

namespace triscope {
namespace {

constexpr std::array kPaper = std::to_array<PresetValue>({{"step4_area_ratio", "0"},
                                                          {"laplacian", "on"},
                                                          {"reduce_obtuse", "on"},
                                                          {"shared_edge", "on"},
                                                          {"polish", "off"},
                                                          {"size", "ranks"},
                                                          {"placement", "circumcentre"},
                                                          {"optimise", "off"}});
constexpr std::array kStandard = std::to_array<PresetValue>({{"step4_area_ratio", "1.8"},
                                                             {"laplacian", "on"},
                                                             {"reduce_obtuse", "on"},
                                                             {"shared_edge", "on"},
                                                             {"polish", "on"},
                                                             {"size", "ranks"},
                                                             {"placement", "circumcentre"},
                                                             {"optimise", "on"}});
constexpr std::array kBest = std::to_array<PresetValue>({{"step4_area_ratio", "1.8"},
                                                         {"laplacian", "off"},
                                                         {"reduce_obtuse", "off"},
                                                         {"shared_edge", "off"},
                                                         {"polish", "off"},
                                                         {"size", "continuous"},
                                                         {"placement", "spokes"},
                                                         {"optimise", "on"}});

constexpr std::array kPresets = std::to_array<Preset>({
    {"paper", "Paper", "The method of the paper and nothing of our own.", kPaper},
    {"standard", "Standard",
     "The method of the paper, with what is our own where it leaves a gap, and optimised after it.", kStandard},
    {"best", "Best", "Rows of points along the boundary, optimised: no obtuse triangle, in the shortest time.", kBest},
});

bool isInForce(const Settings& settings, const Preset& preset) {
  Settings with = settings;
  applyPreset(with, preset);
  return with == settings;
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

void applyPreset(Settings& settings, const Preset& preset) {
  for (const PresetValue& value : preset.values) static_cast<void>(setSetting(settings, value.key, value.value));
}

Status applyPreset(Settings& settings, std::string_view key) {
  const auto* const found = std::ranges::find(kPresets, key, &Preset::key);
  if (found == kPresets.end())
    return Error{.kind = ErrorKind::usage,
                 .message = fmt::format("there is no preset '{}'", shown(key)),
                 .hint = fmt::format("the presets are {}", presetKeys())};
  applyPreset(settings, *found);
  return success();
}

const Preset* presetOf(const Settings& settings) {
  const auto* const found =
      std::ranges::find_if(kPresets, [&](const Preset& preset) { return isInForce(settings, preset); });
  return found == kPresets.end() ? nullptr : found;
}

std::string presetKeys() {
  std::string text;
  for (const Preset& preset : kPresets) text.append(text.empty() ? "" : ", ").append(preset.key);
  return text;
}

}  // namespace triscope
