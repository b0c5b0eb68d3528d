// OpenGL names that free themselves. A context must be current whenever one is made or dies.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace triscope {

/// Owns one OpenGL name; `Traits` says how to make and free it. 0: none.
template <class Traits>
class GlObject {
 public:
  GlObject() = default;
  ~GlObject() { reset(); }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  /// The name, made at the first use.
  GLuint get() {
    if (name_ == 0) name_ = Traits::make();
    return name_;
  }
  void reset() {
    if (name_ != 0) Traits::free(std::exchange(name_, 0));
  }

 private:
  GLuint name_ = 0;
};

struct GlBufferTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteBuffers(1, &name); }
};
struct GlVertexArrayTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct GlTextureTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteTextures(1, &name); }
};
struct GlFramebufferTraits {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void free(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct GlProgramTraits {
  static GLuint make() { return glCreateProgram(); }
  static void free(GLuint name) { glDeleteProgram(name); }
};

using GlBuffer = GlObject<GlBufferTraits>;
using GlVertexArray = GlObject<GlVertexArrayTraits>;
using GlTexture = GlObject<GlTextureTraits>;
using GlFramebuffer = GlObject<GlFramebufferTraits>;
using GlProgramName = GlObject<GlProgramTraits>;

}  // namespace triscope
