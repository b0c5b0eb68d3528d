#include "core/explain/element.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/index_text.h"
#include "core/density/wanted.h"
#include "core/explain/fields.h"
#include "core/explain/why.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr std::array<std::string_view, 8> kVertexKinds{// in the order of VertexKind
                                                       "a corner of the box around everything",
                                                       "an input point, never moved",
                                                       "a boundary point",
                                                       "a boundary point from a split",
                                                       "a point of the first front",
                                                       "a point of the second front",
                                                       "inserted by the method's steps",
                                                       "removed"};
constexpr std::array<std::string_view, 4> kCellTypes{"outside", "boundary", "adjacent to the boundary",
                                                     "interior"};  // in the order of CellType

double areaOf(const Mesh& mesh, Slot slot) { return 0.5 * std::fabs(twiceArea(mesh, slot)); }

std::vector<Line> ofTriangle(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const TriangleQuality q = qualityOf(mesh, slot);
  std::vector<Line> lines{linked(fmt::format("Triangle {} joins vertices {}, {} and {} around {}.", idOf(mesh, slot),
                                             t.v[0], t.v[1], t.v[2], placeText(centroidOf(mesh, slot)))),
                          linked(fmt::format("Circumradius R = {:.4g}, inradius r = {:.4g}, aspect ratio R/r = {:.4g}.",
                                             q.circumradius, q.inradius, q.aspect)),
                          linked(fmt::format("Shortest edge e = {:.4g}, longest {:.4g}, edge ratio {:.4g}.", q.shortest,
                                             q.longest, q.edgeRatio)),
                          linked(fmt::format("Angles from {:.4g}° to {:.4g}°, {}; area {:.4g}.", q.minAngle, q.maxAngle,
                                             q.obtuse ? "obtuse" : "not obtuse", std::fabs(q.area)))};
  for (const Half across : t.adj) {
    if (!across.exists()) {
      lines.push_back(linked("Beyond one edge lies the outside."));
      continue;
    }
    const double own = areaOf(mesh, slot);
    const double other = areaOf(mesh, triangleOf(across));
    lines.push_back(linked(fmt::format("Area ratio {:.4g} with triangle {}.", std::max(own / other, other / own),
                                       idOf(mesh, triangleOf(across)))));
  }
  return lines;
}

std::vector<Line> ofVertex(const MeshState& state, Vertex vertex) {
  const Mesh& mesh = state.mesh;
  const Point p = pointOf(mesh, vertex);
  std::vector<Line> lines{linked(fmt::format("Vertex {} at {}: {}.", vertex, placeText(p),
                                             kVertexKinds[static_cast<std::size_t>(mesh.kinds[vertex])]))};
  if (const std::optional<Wanted> wanted = wantedAt(state.tree, p))
    lines.push_back(linked(fmt::format("Edges of length h = {:.4g} are wanted here, in cell {} of density rank {}.",
                                       wanted->length, wanted->cell, wanted->rank)));
  Star star;
  starOf(mesh, vertex, star);
  std::string list;
  for (const Half rim : star.rim) list += fmt::format("{}{}", list.empty() ? "" : ", ", idOf(mesh, triangleOf(rim)));
  if (!list.empty()) lines.push_back(linked(fmt::format("{} around it: triangles {}.", star.rim.size(), list)));
  return lines;
}

std::vector<Line> ofCell(const MeshState& state, const Cell& cell, std::uint32_t index) {
  std::vector<Line> lines{
      linked(fmt::format("Cell {} of rank {}, side {:.4g}, lower left corner {}.", index, cell.rank,
                         state.tree.side(cell), placeText(state.tree.corner(cell)))),
      linked(fmt::format("Density rank {}: edges of length h = {:.4g}, about {:.3g} triangles in a whole cell.",
                         cell.density, edgeLengthOf(state.tree, cell.density),
                         trianglesInCell(cell.rank, cell.density)))};
  if (cell.child >= 0)
    lines.push_back(linked(fmt::format("It was split into cells {} to {}.", cell.child, cell.child + 3)));
  else if (!makesDensity(state.stage))
    lines.push_back(linked(fmt::format("Its type is {}.", kCellTypes[static_cast<std::size_t>(cell.type)])));
  return lines;
}

}  // namespace

std::vector<Line> figuresOf(const MeshState& state, Events events, Ref ref) {
  const Mesh& mesh = state.mesh;
  switch (ref.kind) {
    case Ref::Kind::triangle:
      if (const Slot slot = slotOf(mesh, TriangleId(ref.id)); slot.exists()) return ofTriangle(mesh, slot);
      break;
    case Ref::Kind::vertex:
      if (ref.id < mesh.points.size()) return ofVertex(state, Vertex(ref.id));
      break;
    case Ref::Kind::cell:
      if (const Cell* const cell = cellOf(state.tree, ref.id)) return ofCell(state, *cell, ref.id);
      break;
    case Ref::Kind::event:
      if (ref.id < events.size()) return {lineOf(events, ref.id)};
      break;
  }
  return {linked(fmt::format("There is no {} at this moment.", nameOf(ref)))};
}

std::array<WorstMeasure, 5> worstOf(const Quality& q) {
  return {{{"aspect ratio", "aspect_ratio", q.aspectMax, Bounds::aspect, true, q.aspectAt},
           {"area ratio", "area_ratio", q.areaRatioMax, Bounds::areaRatio, true, q.areaRatioAt},
           {"edge ratio", "edge_ratio", q.edgeRatioMax, Bounds::edgeRatio, true, q.edgeRatioAt},
           {"smallest angle", "min_angle", q.minAngle, Bounds::minAngle, false, q.minAngleAt},
           {"largest angle", "max_angle", q.maxAngle, Bounds::maxAngle, true, q.maxAngleAt}}};
}

}  // namespace triscope
