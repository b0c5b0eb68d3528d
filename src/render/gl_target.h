// A picture to draw into and to show as a texture.
#pragma once

#include "render/color.h"
#include "render/gl_object.h"

namespace triscope {

class GlTarget {
 public:
  /// Makes the picture width × height pixels; its content is undefined when that changes. True when it did.
  bool resize(int width, int height);
  /// Directs drawing here and covers it with `color`.
  void clear(Color color);
  void bind();
  /// Copies all of `from`, which must have the same size.
  void copyFrom(GlTarget& from);
  [[nodiscard]] GLuint texture() { return texture_.get(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace triscope
