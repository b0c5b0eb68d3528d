// A shader program made of two embedded sources, and its uniforms by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/color.h"
#include "render/gl_object.h"

namespace triscope {

class GlProgram {
 public:
  /// Compiles shaders/<vertex> and shaders/<fragment>. Returns what the driver says, empty when all is well.
  std::string build(std::string_view vertex, std::string_view fragment);
  void use();
  void set(const char* name, float x);
  void set(const char* name, int x);
  void set(const char* name, bool x) { set(name, x ? 1 : 0); }
  void set(const char* name, float x, float y);
  void set(const char* name, float x, float y, float z, float w);
  void set(const char* name, Color color);

 private:
  struct Uniform {
    std::string name;
    GLint location = -1;
  };
  GLint locate(const char* name);

  GlProgramName program_;
  std::vector<Uniform> uniforms_;
};

}  // namespace triscope
