// Draws a scene with OpenGL 3.3. The large layers are drawn once into a picture of their own and only again when
// they, the camera or the size change, and where few triangles have changed only there; the small ones are laid over a
// copy of it.
#pragma once

#include <array>
#include <string>

#include "render/camera.h"
#include "render/gl_layer.h"
#include "render/gl_program.h"
#include "render/gl_target.h"
#include "render/scene.h"

namespace triscope {

class GlRenderer {
 public:
  /// A context must be current. Returns what went wrong, empty when it is ready.
  std::string start();
  /// Brings the picture up to date; `density` is pixels per pixel at 100 %. Labels are left to the caller.
  /// False when nothing had to be drawn.
  bool draw(const Scene& scene, const Camera& camera, double density);
  /// RGBA, camera.width × camera.height, the first row at the bottom.
  [[nodiscard]] GLuint texture() { return picture_.texture(); }
  /// Forgets everything that was uploaded and drawn.
  void forget();

 private:
  struct View {
    Camera camera;
    double density = 1.0;
    Point origin;
    Box visible;  // what is to be drawn of the world
  };
  struct Drawn {
    std::array<std::uint64_t, kLayerCount> versions{};
    Camera camera;
    double density = 0.0;
    Color background;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };

  void drawSome(const Scene& scene, const View& view, bool large);
  void drawLarge(const Scene& scene, View view, const Drawn& wanted);
  void drawLayer(GlLayer& layer, const View& view);
  void drawTriangles(GlTriangles& batch, const View& view);
  void drawSquares(GlSquares& batch, const View& view);
  void drawLines(GlLines& batch, const View& view);
  void drawCircle(const Circle& circle, const View& view);
  void drawMarks(GlMarks& batch, const View& view);
  [[nodiscard]] Point originFor(const Scene& scene, const Camera& camera) const;

  GlProgram triangles_;
  GlProgram squares_;
  GlProgram lines_;
  GlProgram circles_;
  GlProgram marks_;
  GlVertexArray empty_;  // for a draw call without attributes
  GlTarget large_;       // the large layers
  GlTarget picture_;     // and the small ones over them
  std::array<GlLayer, kLayerCount> layers_;
  Point origin_;
  Drawn drawnLarge_;
  Drawn drawnAll_;
};

}  // namespace triscope
