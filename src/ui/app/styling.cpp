#include "ui/app/styling.h"

#include "ui/kit/style.h"
#include "ui/model/preferences.h"

namespace triscope {
namespace {

std::string pathOf(const WindowOptions& options) {
  if (options.preferences.empty()) return preferencesPath();
  return options.preferences == "none" ? std::string() : options.preferences;
}

}  // namespace

Styling::Styling(Desk& desk, const WindowOptions& options) : desk_(desk), path_(pathOf(options)) {
  if (!path_.empty()) desk_.ui.look = readPreferences(path_);
  saved_ = desk_.ui.look;
  desk_.ui.options.theme = desk_.ui.look.theme;
}

Styling::~Styling() {
  if (!path_.empty() && desk_.ui.look != saved_) writePreferences(path_, desk_.ui.look);
}

bool Styling::prepareFrame() {
  const double scale = desk_.ui.scale();
  const bool rescaled = scale != scale_;
  if (!rescaled && desk_.ui.look.theme == theme_) return false;
  if (rescaled) fonts_ = loadFonts(static_cast<float>(scale));
  theme_ = desk_.ui.look.theme;
  applyStyle(themeOf(theme_), static_cast<float>(scale));
  scale_ = scale;
  return rescaled;
}

}  // namespace triscope
