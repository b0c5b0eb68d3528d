#include "render/gl_renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <vector>

#include "render/stroke.h"

namespace triscope {
namespace {

constexpr double kHatchSpacing = 7.0;  // pixels at 100 %
constexpr double kMarkStroke = 1.2;
constexpr float kSmallestMark = markSize(1.0e3f, 0.0);

/// For shaders that hold positions relative to `origin`.
void setView(GlProgram& program, const Camera& camera, Point origin) {
  program.set("uView", glm::mat3x2(clipFrom(camera, origin)));
}

void setDash(GlProgram& program, const LineStyle& style, double density) {
  const DashPattern pattern = patternOf(style.dash);
  const auto unit = static_cast<float>(density * dashUnit(style.width));
  program.set("uDash", unit * glm::make_vec4(pattern.lengths.data()));
  program.set("uDashCount", pattern.count);
}

float halfWidth(const LineStyle& style, double density) {
  return static_cast<float>(0.5 * density * static_cast<double>(style.width));
}

bool meets(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

}  // namespace

std::string GlRenderer::start() {
  std::string complaint = triangles_.build("fill.vert", "fill.frag");
  complaint += squares_.build("square.vert", "square.frag");
  complaint += lines_.build("line.vert", "line.frag");
  complaint += circles_.build("circle.vert", "circle.frag");
  complaint += marks_.build("mark.vert", "mark.frag");
  return complaint;
}

void GlRenderer::forget() {
  layers_ = {};
  drawnLarge_ = {};
  drawnAll_ = {};
}

Point GlRenderer::originFor(const Scene& scene, const Camera& camera) const {
  // A float holds 24 bits: beyond this many pixels from the origin a position is off by a quarter of one.
  constexpr double kFarthest = 4.0e6;
  if (length(camera.centre - scene.origin) * camera.scale < kFarthest) return scene.origin;
  if (length(camera.centre - origin_) * camera.scale < kFarthest) return origin_;
  return camera.centre;
}

bool GlRenderer::draw(const Scene& scene, const Camera& camera, double density) {
  Drawn all{.camera = camera, .density = density, .background = scene.theme.background};
  Drawn large = all;
  for (int i = 0; i < kLayerCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    all.versions[at] = scene.layers[at].version;
    if (isLarge(static_cast<LayerId>(i))) large.versions[at] = scene.layers[at].version;
  }
  if (all == drawnAll_) return false;

  const int width = std::max(1, static_cast<int>(camera.width));
  const int height = std::max(1, static_cast<int>(camera.height));
  const bool resized = large_.resize(width, height);
  picture_.resize(width, height);
  origin_ = originFor(scene, camera);
  const View view{camera, density, origin_, visibleBox(camera)};

  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glEnable(GL_PROGRAM_POINT_SIZE);
  // The picture stays opaque: alpha is left alone.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);

  if (resized) drawnLarge_ = {};
  if (large != drawnLarge_) drawLarge(scene, view, large);
  picture_.copyFrom(large_);
  drawSome(scene, view, false);
  drawnAll_ = all;
  glBindVertexArray(0);
  glUseProgram(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return true;
}

void GlRenderer::drawSome(const Scene& scene, const View& view, bool large) {
  for (int i = 0; i < kLayerCount; ++i) {
    if (isLarge(static_cast<LayerId>(i)) != large) continue;
    GlLayer& layer = layers_[static_cast<std::size_t>(i)];
    upload(layer, scene.layers[static_cast<std::size_t>(i)], origin_);
    drawLayer(layer, view);
  }
}

void GlRenderer::drawLarge(const Scene& scene, View view, const Drawn& wanted) {
  const LayerChange& change = scene.layer(LayerId::mesh).change;
  std::uint64_t& drawn = drawnLarge_.versions[static_cast<std::size_t>(LayerId::mesh)];
  Drawn as = drawnLarge_;
  as.versions[static_cast<std::size_t>(LayerId::mesh)] = scene.layer(LayerId::mesh).version;
  const bool partly = change.since != 0 && drawn == change.since && as == wanted;
  drawnLarge_ = wanted;
  if (!partly) {
    large_.clear(scene.theme.background);
    return drawSome(scene, view, true);
  }
  // What else lies there is drawn again too, and falls on the same pixels as before.
  constexpr double kMargin = 3.0;  // pixels at 100 %, for the width of edges
  const double margin = kMargin * view.density;
  const Pixel a = toPixel(view.camera, change.where.lo), b = toPixel(view.camera, change.where.hi);  // y down
  const auto clipped = [](double value, double most) { return static_cast<GLint>(std::clamp(value, 0.0, most)); };
  const GLint left = clipped(std::floor(a.x - margin), view.camera.width);
  const GLint right = clipped(std::ceil(b.x + margin), view.camera.width);
  const GLint top = clipped(std::floor(b.y - margin), view.camera.height);
  const GLint bottom = clipped(std::ceil(a.y + margin), view.camera.height);
  if (change.where.empty() || left >= right || top >= bottom)  // out of view
    return upload(layers_[static_cast<std::size_t>(LayerId::mesh)], scene.layer(LayerId::mesh), origin_);
  view.visible = {};
  view.visible.include(toWorld(view.camera, {static_cast<double>(left), static_cast<double>(top)}));
  view.visible.include(toWorld(view.camera, {static_cast<double>(right), static_cast<double>(bottom)}));
  glEnable(GL_SCISSOR_TEST);
  glScissor(left, static_cast<GLint>(view.camera.height) - bottom, right - left, bottom - top);
  large_.clear(scene.theme.background);
  drawSome(scene, view, true);
  glDisable(GL_SCISSOR_TEST);
}

void GlRenderer::drawLayer(GlLayer& layer, const View& view) {
  for (GlSquares& batch : layer.squares) drawSquares(batch, view);
  for (GlTriangles& batch : layer.triangles) drawTriangles(batch, view);
  for (GlLines& batch : layer.lines) drawLines(batch, view);
  for (const Circle& circle : layer.circles) drawCircle(circle, view);
  for (GlMarks& batch : layer.marks) drawMarks(batch, view);
}

void GlRenderer::drawTriangles(GlTriangles& batch, const View& view) {
  if (batch.mesh.count == 0) return;
  triangles_.use();
  setView(triangles_, view.camera, view.origin);
  triangles_.set("uWire", batch.wire.color);
  triangles_.set("uHalfWidth", halfWidth(batch.wire, view.density));
  triangles_.set("uFades", batch.wire.fades);
  triangles_.set("uHatchSpacing", batch.hatched ? static_cast<float>(kHatchSpacing * view.density) : 0.0f);
  glBindVertexArray(batch.mesh.array.get());
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const GlTile& tile : batch.tiles) {
    if (!meets(tile.box, view.visible)) continue;
    if (!firsts.empty() && firsts.back() + counts.back() == tile.first) {
      counts.back() += tile.count;
    } else {
      firsts.push_back(tile.first);
      counts.push_back(tile.count);
    }
  }
  glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
}

void GlRenderer::drawSquares(GlSquares& batch, const View& view) {
  if (batch.mesh.count == 0) return;
  squares_.use();
  setView(squares_, view.camera, view.origin);
  squares_.set("uWire", batch.outline.color);
  squares_.set("uHalfWidth", halfWidth(batch.outline, view.density));
  squares_.set("uFades", batch.outline.fades);
  glBindVertexArray(batch.mesh.array.get());
  glDrawElements(GL_TRIANGLES, batch.mesh.count, GL_UNSIGNED_INT, nullptr);
}

void GlRenderer::drawLines(GlLines& batch, const View& view) {
  if (batch.mesh.count == 0) return;
  lines_.use();
  setView(lines_, view.camera, view.origin);
  lines_.set("uViewport", glm::vec2(view.camera.size()));
  lines_.set("uPixelsPerUnit", static_cast<float>(view.camera.scale));
  lines_.set("uHalfWidth", halfWidth(batch.style, view.density));
  lines_.set("uColor", batch.style.color);
  lines_.set("uFades", batch.style.fades);
  setDash(lines_, batch.style, view.density);
  glBindVertexArray(batch.mesh.array.get());
  glDrawElements(GL_TRIANGLES, batch.mesh.count, GL_UNSIGNED_INT, nullptr);
}

void GlRenderer::drawCircle(const Circle& circle, const View& view) {
  const double radius =
      std::max(circle.radius * view.camera.scale, view.density * static_cast<double>(circle.minimumRadius));
  const Point way = view.camera.scale * (circle.centre - view.camera.centre);
  const glm::dvec2 centre(way.x, way.y);
  // Enough sides that the strip stays within half a pixel of the rim; more cannot be told apart.
  const int sides = std::clamp(static_cast<int>(std::numbers::pi * std::sqrt(std::max(radius, 4.0))), 24, 4096);
  circles_.use();
  circles_.set("uCentre", glm::vec2(centre));
  circles_.set("uRadius", static_cast<float>(radius));
  circles_.set("uViewport", glm::vec2(view.camera.size()));
  circles_.set("uHalfWidth", halfWidth(circle.style, view.density));
  circles_.set("uSides", sides);
  circles_.set("uColor", circle.style.color);
  setDash(circles_, circle.style, view.density);
  glBindVertexArray(empty_.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (sides + 1));
}

void GlRenderer::drawMarks(GlMarks& batch, const View& view) {
  if (batch.mesh.count == 0) return;
  marks_.use();
  setView(marks_, view.camera, view.origin);
  marks_.set("uSize", static_cast<float>(view.density) * batch.size);
  marks_.set("uSmallest", static_cast<float>(view.density) * kSmallestMark);
  marks_.set("uPixelsPerUnit", static_cast<float>(view.camera.scale));
  marks_.set("uShape", static_cast<int>(batch.shape));
  marks_.set("uFill", batch.fill);
  marks_.set("uOutline", batch.outline);
  marks_.set("uStroke", static_cast<float>(kMarkStroke * view.density));
  glBindVertexArray(batch.mesh.array.get());
  glDrawArrays(GL_POINTS, 0, batch.mesh.count);
}

}  // namespace triscope
