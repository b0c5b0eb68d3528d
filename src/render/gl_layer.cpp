#include "render/gl_layer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace triscope {
namespace {

struct FilledVertex {
  float x = 0.0f;
  float y = 0.0f;
  Color fill;
};

struct LineVertex {
  float x0 = 0.0f;
  float y0 = 0.0f;
  float x1 = 0.0f;
  float y1 = 0.0f;
  float along = 0.0f;
};

struct MarkVertex {
  float x = 0.0f;
  float y = 0.0f;
  float spacing = 0.0f;
};

/// A point relative to the origin, as a float.
struct Near {
  Point origin;
  [[nodiscard]] float x(Point p) const { return static_cast<float>(p.x - origin.x); }
  [[nodiscard]] float y(Point p) const { return static_cast<float>(p.y - origin.y); }
};

// OpenGL takes an offset into the buffer in the guise of a pointer.
const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

template <class Vertex>
void fillBuffer(GlMesh& mesh, const std::vector<Vertex>& vertices) {
  glBindVertexArray(mesh.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  mesh.count = static_cast<GLsizei>(vertices.size());
}

void attribute(GLuint index, GLint size, GLenum type, bool normalized, std::size_t stride, std::size_t at) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, type, normalized ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stride), offset(at));
}

void describeFilled() {
  attribute(0, 2, GL_FLOAT, false, sizeof(FilledVertex), offsetof(FilledVertex, x));
  attribute(1, 4, GL_UNSIGNED_BYTE, true, sizeof(FilledVertex), offsetof(FilledVertex, fill));
}

/// Two triangles for every four vertices.
void quadIndices(GlMesh& mesh) {
  std::vector<std::uint32_t> indices;
  const auto quads = static_cast<std::uint32_t>(mesh.count / 4);
  indices.reserve(std::size_t{6} * quads);
  for (std::uint32_t q = 0; q < quads; ++q)
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(4 * q + corner);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
               GL_STATIC_DRAW);
  mesh.count = static_cast<GLsizei>(indices.size());
}

/// Interleaves the lower 16 bits of x and y: points near each other get numbers near each other.
std::uint32_t mortonOf(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v = (v | (v << 8u)) & 0x00FF00FFu;
    v = (v | (v << 4u)) & 0x0F0F0F0Fu;
    v = (v | (v << 2u)) & 0x33333333u;
    return (v | (v << 1u)) & 0x55555555u;
  };
  return spread(x) | (spread(y) << 1u);
}

constexpr std::size_t kTileTriangles = 2048;

/// By the upper half, equal ones as they come: in a quarter of the time of a sort by comparison.
void sortByUpperHalf(std::vector<std::uint64_t>& keys) {
  constexpr unsigned kBits = 11, kPasses = 3;
  std::vector<std::uint64_t> sorted(keys.size());
  for (unsigned pass = 0; pass < kPasses; ++pass) {
    const auto digit = [shift = 32 + kBits * pass](std::uint64_t key) { return key >> shift & ((1u << kBits) - 1); };
    std::array<std::size_t, std::size_t{1} << kBits> next{};
    for (const std::uint64_t key : keys) ++next[digit(key)];
    std::exclusive_scan(next.begin(), next.end(), next.begin(), std::size_t{0});
    for (const std::uint64_t key : keys) sorted[next[digit(key)]++] = key;
    keys.swap(sorted);
  }
}

/// An order of the triangles in which those near each other are close; as they come when they are few.
std::vector<std::uint32_t> spatialOrder(const TriangleBatch& batch) {
  std::vector<std::uint32_t> order(batch.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  if (order.size() <= 2 * kTileTriangles) return order;
  Box box;
  for (const Point& p : batch.points) box.include(p);
  const double toGrid = 65535.0 / std::max({box.width(), box.height(), 1e-300});
  std::vector<std::uint64_t> keyed(order.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    const Index3& corners = batch.triangles[t];
    const Point p = batch.points[corners[0]] - box.lo;
    // Those without extent make room for others, wherever these will be: they come last.
    const std::uint32_t morton = corners[0] == corners[1] ? ~0u
                                                          : mortonOf(static_cast<std::uint32_t>(p.x * toGrid),
                                                                     static_cast<std::uint32_t>(p.y * toGrid));
    keyed[t] = (std::uint64_t{morton} << 32u) | t;
  }
  sortByUpperHalf(keyed);
  std::transform(keyed.begin(), keyed.end(), order.begin(),
                 [](std::uint64_t k) { return static_cast<std::uint32_t>(k); });
  return order;
}

std::array<FilledVertex, 3> verticesOf(const TriangleBatch& batch, std::uint32_t t, Near nearby, Box& box) {
  constexpr Color kNone{0, 0, 0, 0};
  const Color fill = batch.fills.empty() ? kNone : batch.fills[batch.fills.size() == 1 ? 0 : t];
  const Index3& corners = batch.triangles[t];
  std::array<FilledVertex, 3> vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = batch.points[corners[i]];
    if (corners[0] != corners[1]) box.include(p);
    vertices[i] = {nearby.x(p), nearby.y(p), fill};
  }
  return vertices;
}

void uploadTriangles(GlTriangles& target, const TriangleBatch& batch, Near nearby) {
  std::vector<FilledVertex> vertices;
  vertices.reserve(3 * batch.triangles.size());
  target.places.resize(batch.triangles.size());
  for (const std::uint32_t t : spatialOrder(batch)) {
    if (vertices.size() % (3 * kTileTriangles) == 0)
      target.tiles.push_back({{}, static_cast<GLint>(vertices.size()), 0});
    GlTile& tile = target.tiles.back();
    target.places[t] = static_cast<GLint>(vertices.size());
    const std::array<FilledVertex, 3> corners = verticesOf(batch, t, nearby, tile.box);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    tile.count += 3;
  }
  target.wire = batch.wire;
  target.hatched = batch.hatched;
  fillBuffer(target.mesh, vertices);
  describeFilled();
}

/// Writes the triangles that have changed over what was in their places.
void mendTriangles(GlTriangles& target, const TriangleBatch& batch, const std::vector<std::uint32_t>& changed,
                   Near nearby) {
  glBindBuffer(GL_ARRAY_BUFFER, target.mesh.vertices.get());
  for (const std::uint32_t t : changed) {
    const auto place = static_cast<std::size_t>(target.places[t]);
    const std::array<FilledVertex, 3> vertices =
        verticesOf(batch, t, nearby, target.tiles[place / (3 * kTileTriangles)].box);
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(place * sizeof(FilledVertex)), sizeof(vertices),
                    vertices.data());
  }
}

void uploadSquares(GlSquares& target, const SquareBatch& batch, Near nearby) {
  std::vector<FilledVertex> vertices;
  vertices.reserve(4 * batch.squares.size());
  for (const auto& square : batch.squares)
    for (const Point step : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) {
      const Point p = square.corner + square.side * step;
      vertices.push_back({nearby.x(p), nearby.y(p), square.fill});
    }
  target.outline = batch.outline;
  fillBuffer(target.mesh, vertices);
  describeFilled();
  quadIndices(target.mesh);
}

void uploadLines(GlLines& target, const LineBatch& batch, Near nearby) {
  std::vector<LineVertex> vertices;
  vertices.reserve(4 * batch.segments.size());
  double along = 0.0;
  std::uint32_t last = ~0u;
  for (const Index2& segment : batch.segments) {
    const Point a = batch.points[segment[0]];
    const Point b = batch.points[segment[1]];
    if (segment[0] != last) along = 0.0;  // another polyline
    const LineVertex v{nearby.x(a), nearby.y(a), nearby.x(b), nearby.y(b), static_cast<float>(along)};
    vertices.insert(vertices.end(), 4, v);
    along += distance(a, b);
    last = segment[1];
  }
  target.style = batch.style;
  fillBuffer(target.mesh, vertices);
  attribute(0, 2, GL_FLOAT, false, sizeof(LineVertex), offsetof(LineVertex, x0));
  attribute(1, 2, GL_FLOAT, false, sizeof(LineVertex), offsetof(LineVertex, x1));
  attribute(2, 1, GL_FLOAT, false, sizeof(LineVertex), offsetof(LineVertex, along));
  quadIndices(target.mesh);
}

void uploadMarks(GlMarks& target, const MarkBatch& batch, Near nearby) {
  std::vector<MarkVertex> vertices;
  vertices.reserve(batch.at.size());
  for (std::size_t i = 0; i < batch.at.size(); ++i)
    vertices.push_back({nearby.x(batch.at[i]), nearby.y(batch.at[i]), batch.spacing.empty() ? 0.0f : batch.spacing[i]});
  target.shape = batch.shape;
  target.size = batch.size;
  target.fill = batch.fill;
  target.outline = batch.outline;
  fillBuffer(target.mesh, vertices);
  attribute(0, 2, GL_FLOAT, false, sizeof(MarkVertex), offsetof(MarkVertex, x));
  attribute(1, 1, GL_FLOAT, false, sizeof(MarkVertex), offsetof(MarkVertex, spacing));
}

}  // namespace

void upload(GlLayer& target, const Layer& layer, Point origin) {
  if (target.version == layer.version && target.origin == origin) return;
  const Near nearby{origin};
  if (layer.change.since != 0 && target.version == layer.change.since && target.origin == origin) {
    mendTriangles(target.triangles.front(), layer.triangles.front(), layer.change.triangles, nearby);
    target.version = layer.version;
    return;
  }
  target = {};
  target.version = layer.version;
  target.origin = origin;
  for (const SquareBatch& batch : layer.squares) uploadSquares(target.squares.emplace_back(), batch, nearby);
  for (const TriangleBatch& batch : layer.triangles) uploadTriangles(target.triangles.emplace_back(), batch, nearby);
  for (const LineBatch& batch : layer.lines) uploadLines(target.lines.emplace_back(), batch, nearby);
  for (const MarkBatch& batch : layer.marks) uploadMarks(target.marks.emplace_back(), batch, nearby);
  target.circles = layer.circles;
  glBindVertexArray(0);
}

}  // namespace triscope
