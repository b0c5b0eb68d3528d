#include "ui/app/screenshot.h"

#include <GLFW/glfw3.h>
#include <glad/gl.h>

#include <cstddef>

#include "core/base/output_set.h"
#include "render/image.h"

namespace triscope {

Status saveScreenshot(GLFWwindow* window, const std::string& path) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  Image image(width, height, {});
  std::vector<Color> rows(image.pixels.size());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  for (int y = 0; y < height; ++y)  // OpenGL's rows run upwards
    for (int x = 0; x < width; ++x) {
      Color c = rows[static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
      c.a = 255;
      image.at(x, y) = c;
    }
  const Result<std::string> bytes = encodePng(image);
  if (!bytes) return bytes.error();
  return writeWhole(path, *bytes);
}

}  // namespace triscope
