// Settings that go together, under one name.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/words/settings.h"

namespace triscope {

struct PresetValue {
  std::string_view key;
  std::string_view value;  // as --set takes it
};

struct Preset {
  std::string_view key;
  std::string_view label;  // on a button
  std::string_view help;   // one sentence
  std::span<const PresetValue> values;
};

/// Each names every setting that any of them names, so that one takes the place of another.
std::span<const Preset> presets();
/// Changes what the preset names, and nothing else.
void applyPreset(Settings& settings, const Preset& preset);
/// The same by its key. Errors say which there are.
Status applyPreset(Settings& settings, std::string_view key);
/// The one whose values are all in force; null when none is.
const Preset* presetOf(const Settings& settings);
/// "paper, standard, best"
std::string presetKeys();

}  // namespace triscope
