// A shader program made of two embedded sources, and its uniforms by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

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
  void set(const char* name, glm::vec2 v);
  void set(const char* name, glm::vec4 v);
  void set(const char* name, const glm::mat3x2& m);
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
