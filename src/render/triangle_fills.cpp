// What the colour of a triangle may say, a row each: its name, the ends of its scale, and how it is measured.
#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "core/base/stands_by_ids.h"
#include "core/density/wanted.h"
#include "core/mesh/centroid.h"
#include "render/scene_parts.h"

namespace triscope {
namespace detail {
namespace {

double areaRatio(const MeshState& state, Slot slot) {
  const Mesh& mesh = state.mesh;
  const double area = twiceArea(mesh, slot);
  if (area <= 0.0) return 0.0;
  double worst = 1.0;
  for (const Half half : triangleAt(mesh, slot).adj) {
    const double other = half.exists() ? twiceArea(mesh, triangleOf(half)) : 0.0;
    if (other > 0.0) worst = std::max({worst, other / area, area / other});
  }
  return worst;
}

double densityRank(const MeshState& state, Slot slot) {
  return wantedAt(state.tree, centroidOf(state.mesh, slot)).value_or(Wanted{}).rank;
}

/// How many times longer, or shorter, than the h of its middle the edge is that is furthest from it.
double offTheSize(const MeshState& state, Slot slot) {
  const Mesh& mesh = state.mesh;
  double worst = 1.0;
  for (int i = 0; i < 3; ++i) {
    const Point a = pointOf(mesh, startOf(mesh, halfOf(slot, i))), b = pointOf(mesh, endOf(mesh, halfOf(slot, i)));
    const double h = wantedAt(state.tree, midpoint(a, b)).value_or(Wanted{}).length;
    if (h > 0.0) worst = std::max({worst, distance(a, b) / h, h / distance(a, b)});
  }
  return worst;
}

struct Row {
  TriangleFill id;
  std::string_view name;
  MeasureScale scale;
  double (*measure)(const MeshState&, Slot);
};

constexpr std::array<Row, kTriangleFillCount> kRows{{
    {TriangleFill::plain, "plain", {}, [](const MeshState&, Slot) { return 0.0; }},
    {TriangleFill::aspect,
     "aspect ratio R/r",
     {2.0, Bounds::aspect},
     [](const MeshState& s, Slot t) { return qualityOf(s.mesh, t).aspect; }},
    {TriangleFill::min_angle,
     "smallest angle",
     {60.0, Bounds::minAngle, "°"},
     [](const MeshState& s, Slot t) { return qualityOf(s.mesh, t).minAngle; }},
    {TriangleFill::max_angle,
     "largest angle",
     {60.0, Bounds::maxAngle, "°"},
     [](const MeshState& s, Slot t) { return qualityOf(s.mesh, t).maxAngle; }},
    {TriangleFill::area_ratio, "area ratio", {1.0, Bounds::areaRatio}, areaRatio},
    {TriangleFill::edge_ratio,
     "edge ratio",
     {1.0, Bounds::edgeRatio},
     [](const MeshState& s, Slot t) { return qualityOf(s.mesh, t).edgeRatio; }},
    {TriangleFill::density, "density rank", {}, densityRank},
    {TriangleFill::size, "edge length against h", {1.0, std::numbers::sqrt2, {}, "further off"}, offTheSize},
}};
static_assert(standsByIds(kRows));

const Row& rowOf(TriangleFill fill) { return kRows[static_cast<std::size_t>(fill)]; }

}  // namespace

MeasureScale scaleOf(TriangleFill fill) { return rowOf(fill).scale; }

float measureSlot(const MeshState& state, Slot slot, TriangleFill fill) {
  return static_cast<float>(rowOf(fill).measure(state, slot));
}

}  // namespace detail

std::string_view name(TriangleFill fill) { return detail::rowOf(fill).name; }

}  // namespace triscope
