#include "render/gl_program.h"

#include <glm/gtc/type_ptr.hpp>

#include "render/embedded.h"

namespace triscope {
namespace {

std::string fileNamed(std::string_view name) {
  const std::span<const unsigned char> bytes = findEmbedded(embeddedShaders(), name);
  return {bytes.begin(), bytes.end()};
}

/// The source with its `//#include NAME` lines replaced by that file.
std::string sourceOf(std::string_view name) {
  std::string text = fileNamed(name);
  constexpr std::string_view kDirective = "//#include ";
  for (std::size_t at = text.find(kDirective); at != std::string::npos; at = text.find(kDirective)) {
    const std::size_t end = text.find('\n', at);
    const std::string wanted = text.substr(at + kDirective.size(), end - at - kDirective.size());
    text.replace(at, end - at, fileNamed(wanted));
  }
  return text;
}

/// Compiles and attaches one stage; returns the driver's complaint.
std::string attach(GLuint program, GLenum stage, std::string_view name) {
  const std::string source = sourceOf(name);
  const GLuint shader = glCreateShader(stage);
  const char* const text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  std::string complaint;
  if (good == 0) {
    std::string log(4096, '\0');
    GLsizei used = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &used, log.data());
    log.resize(static_cast<std::size_t>(used));
    complaint = std::string(name) + ": " + log;
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // lives on while attached
  return complaint;
}

}  // namespace

std::string GlProgram::build(std::string_view vertex, std::string_view fragment) {
  const GLuint program = program_.get();
  std::string complaint = attach(program, GL_VERTEX_SHADER, vertex);
  complaint += attach(program, GL_FRAGMENT_SHADER, fragment);
  if (!complaint.empty()) return complaint;
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good != 0) return {};
  std::string log(4096, '\0');
  GLsizei used = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &used, log.data());
  log.resize(static_cast<std::size_t>(used));
  return std::string(vertex).append(" + ").append(fragment).append(": ").append(log);
}

void GlProgram::use() { glUseProgram(program_.get()); }

GLint GlProgram::locate(const char* name) {
  for (const Uniform& u : uniforms_)
    if (u.name == name) return u.location;
  const GLint location = glGetUniformLocation(program_.get(), name);
  uniforms_.push_back({name, location});
  return location;
}

void GlProgram::set(const char* name, float x) { glUniform1f(locate(name), x); }
void GlProgram::set(const char* name, int x) { glUniform1i(locate(name), x); }
void GlProgram::set(const char* name, glm::vec2 v) { glUniform2fv(locate(name), 1, glm::value_ptr(v)); }
void GlProgram::set(const char* name, glm::vec4 v) { glUniform4fv(locate(name), 1, glm::value_ptr(v)); }
void GlProgram::set(const char* name, const glm::mat3x2& m) {
  glUniformMatrix3x2fv(locate(name), 1, GL_FALSE, glm::value_ptr(m));
}
void GlProgram::set(const char* name, Color c) { set(name, glm::vec4(channelsOf(c) / 255.0)); }

}  // namespace triscope
