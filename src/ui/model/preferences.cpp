#include "ui/model/preferences.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/output_set.h"

namespace triscope {
namespace {

void set(Appearance& look, const std::string& name, const std::string& value) {
  const double number = std::strtod(value.c_str(), nullptr);
  if (name == "scale" && (number == 0.0 || (number >= 0.75 && number <= 3.0))) look.scale = number;
  if (name == "left width" && number > 0.0) look.leftWidth = std::clamp(number, 180.0, 900.0);
  if (name == "right width" && number > 0.0) look.rightWidth = std::clamp(number, 180.0, 900.0);
  if (name == "bottom height" && number > 0.0) look.bottomHeight = std::clamp(number, 120.0, 900.0);
  if (name == "legend") look.legend = value != "off";
  if (name == "theme")
    for (std::size_t k = 0; k < kThemeNames.size(); ++k)
      if (value == kThemeNames[k]) look.theme = static_cast<ThemeKind>(k);
}

}  // namespace

std::string preferencesPath() {
  namespace fs = std::filesystem;
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return (fs::path(config) / "triscope" / "window.conf").string();
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return (fs::path(home) / ".config" / "triscope" / "window.conf").string();
  return {};
}

Appearance readPreferences(const std::string& path) {
  Appearance look;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.ends_with('\r')) line.pop_back();  // edited elsewhere
    const std::size_t equals = line.find(" = ");
    if (equals != std::string::npos) set(look, line.substr(0, equals), line.substr(equals + 3));
  }
  return look;
}

void writePreferences(const std::string& path, const Appearance& look) {
  std::error_code failure;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failure);
  (void)writeWhole(
      path, fmt::format(
                "theme = {}\nscale = {:g}\nleft width = {:g}\nright width = {:g}\nbottom height = {:g}\nlegend = {}\n",
                kThemeNames[static_cast<std::size_t>(look.theme)], look.scale, look.leftWidth, look.rightWidth,
                look.bottomHeight, look.legend ? "on" : "off"));
}

}  // namespace triscope
