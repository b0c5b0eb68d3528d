// The window: one call that opens it and comes back when it is closed.
#pragma once

#include <string>

#include "core/base/result.h"

namespace triscope {

struct WindowOptions {
  std::string file;  // domain to open; empty: the sample that is built in
  // For tests and pictures:
  std::string stateFile;   // JSON kept up to date with what the window shows; empty: none
  std::string screenshot;  // PNG of the window, written once the first mesh is complete; then the program ends
  std::string
      preferences;  // file of theme, scale and layout; empty: under $XDG_CONFIG_HOME; "none": neither read nor written
};

/// Runs the window until it is closed. Errors: no display, a picture that cannot be written. Not to be called twice at
/// the same time.
Status runWindow(const WindowOptions& options);

}  // namespace triscope
