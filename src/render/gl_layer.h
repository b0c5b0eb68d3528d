// One layer of a scene as the graphics card has it.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_object.h"
#include "render/scene.h"

namespace triscope {

/// Vertices of one draw call and how to read them.
struct GlMesh {
  GlVertexArray array;
  GlBuffer vertices;
  GlBuffer indices;  // none: drawn in order
  GLsizei count = 0;
};

/// A run of triangles that lie together, to be left out when they are not in view.
struct GlTile {
  Box box;  // world; holds them all, and perhaps more
  GLint first = 0;
  GLsizei count = 0;  // vertices
};

struct GlTriangles {
  GlMesh mesh;
  std::vector<GlTile> tiles;
  std::vector<GLint> places;  // by triangle of the batch: its first vertex
  LineStyle wire;
  bool hatched = false;
};

struct GlSquares {
  GlMesh mesh;
  LineStyle outline;
};

struct GlLines {
  GlMesh mesh;
  LineStyle style;
};

struct GlMarks {
  GlMesh mesh;
  Shape shape = Shape::circle;
  float size = 0.0f;  // pixels at 100 %
  Color fill;
  Color outline;
};

/// Coordinates are floats relative to `origin`.
struct GlLayer {
  std::uint64_t version = 0;
  Point origin;
  std::vector<GlSquares> squares;
  std::vector<GlTriangles> triangles;
  std::vector<GlLines> lines;
  std::vector<Circle> circles;
  std::vector<GlMarks> marks;
};

/// Uploads the layer unless `target` already has this version and origin; of the version after that of `target` only
/// what has changed.
void upload(GlLayer& target, const Layer& layer, Point origin);

}  // namespace triscope
