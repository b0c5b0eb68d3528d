// The window's own pixels as a file.
#pragma once

#include <string>

#include "core/base/result.h"

struct GLFWwindow;

namespace triscope {

/// Writes the frame that has been drawn and not yet been shown as PNG. Errors: cannot_write.
Status saveScreenshot(GLFWwindow* window, const std::string& path);

}  // namespace triscope
