// The window's own pixels as a file.
#pragma once

#include <string>

#include "core/result.h"

struct GLFWwindow;

namespace triscope {

/// Writes what the window shows as PNG. Errors: cannot_write.
Status saveScreenshot(GLFWwindow* window, const std::string& path);

}  // namespace triscope
