// How the window looked last time: theme, scale, widths. A small text file, one "name = value" a line.
#pragma once

#include <string>

#include "ui/model/order.h"

namespace triscope {

/// $XDG_CONFIG_HOME/triscope/window.conf, or under ~/.config; empty when there is no home.
std::string preferencesPath();
/// What the file says, and the defaults for everything it does not (or when it cannot be read).
Appearance readPreferences(const std::string& path);
/// Makes the folder when it is missing. A file that cannot be written is no reason to stop: nothing is said.
void writePreferences(const std::string& path, const Appearance& look);

}  // namespace triscope
