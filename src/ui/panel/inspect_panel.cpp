#include <fmt/format.h>

#include <cmath>

#include "core/base/index_text.h"
#include "core/base/number.h"
#include "core/density/wanted.h"
#include "core/explain/caption.h"
#include "core/quality/bound_figure.h"
#include "core/run/element_events.h"
#include "render/star.h"
#include "ui/kit/density_handles.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

std::string place(Point p) { return fmt::format("{}, {}", compact(p.x, 5), compact(p.y, 5)); }

std::string_view nameOf(VertexKind kind) {
  switch (kind) {
    case VertexKind::helper:
      return "corner of the box around everything";
    case VertexKind::kept:
      return "input point, never moved";
    case VertexKind::boundary:
      return "boundary point";
    case VertexKind::split:
      return "boundary point from a split";
    case VertexKind::front1:
      return "first front";
    case VertexKind::front2:
      return "second front";
    case VertexKind::steiner:
      return "inserted by steps 1 to 5";
    case VertexKind::removed:
      return "removed";
  }
  return "";
}

void selectTriangle(Orders& orders, const Mesh& mesh, Slot slot) {
  orders.emplace_back(order::SelectElement{pickOf(mesh, slot)});
}

void selectVertex(Orders& orders, Vertex vertex) { orders.emplace_back(order::SelectElement{pickOf(vertex)}); }

/// A link on the line begun.
void linkTo(const View& view, Orders& orders, Vertex vertex) {
  ImGui::SameLine();
  ImGui::PushID(vertex.n);
  if (link(view, std::to_string(vertex.n))) selectVertex(orders, vertex);
  ImGui::PopID();
}

/// The event that made the element, told in words.
void birth(const View& view, Ref ref) {
  const Events events = view.session.events();
  const std::optional<std::size_t> born = birthOf(events, ref);
  if (!born) return;
  heading(view, "Why it is here");
  muted(view, fmt::format("Event {}. {}", grouped(*born), captionOf(events[*born])));
}

void inspectTriangle(const View& view, Orders& orders, const MeshState& state, Slot slot) {
  const Mesh& mesh = state.mesh;
  const Triangle& t = mesh.triangles[slot];
  const TriangleQuality q = qualityOf(mesh, slot);
  const Color bad = view.theme().worstAspect;
  const auto judged = [&](const char* label, const std::string& value, bool good) {
    figure(view, label, value, good ? view.theme().text : bad);
  };
  judged("aspect ratio R/r", besideBound(q.aspect, Bounds::aspect, 3), q.aspect < Bounds::aspect);
  judged("edge ratio", besideBound(q.edgeRatio, Bounds::edgeRatio, 3), q.edgeRatio < Bounds::edgeRatio);
  judged("smallest angle", besideBound(q.minAngle, Bounds::minAngle, 1) + "°", q.minAngle > Bounds::minAngle);
  judged("largest angle", besideBound(q.maxAngle, Bounds::maxAngle, 1) + "°", q.maxAngle < Bounds::maxAngle);
  figure(view, "shape", q.obtuse ? "obtuse" : "not obtuse", q.obtuse ? bad : view.theme().text);
  figure(view, "circumradius R", compact(q.circumradius, 4));
  figure(view, "inradius r", compact(q.inradius, 4));
  figure(view, "shortest edge e", compact(q.shortest, 4));
  figure(view, "longest edge", compact(q.longest, 4));
  figure(view, "area", compact(std::fabs(q.area), 4));

  ImGui::TextDisabled("vertices");
  for (const Vertex v : t.v) linkTo(view, orders, v);
  heading(view, "Neighbours and area ratios");
  for (const Half half : t.adj) {
    if (!half.exists()) {
      muted(view, "boundary");
      continue;
    }
    const Slot other = triangleOf(half);
    const double area = std::fabs(0.5 * twiceArea(mesh, other));
    const double mine = std::fabs(q.area);
    const double ratio = area > mine ? area / mine : mine / area;
    ImGui::PushID(other.n);
    if (link(view, fmt::format("triangle {}", mesh.ids[other]))) selectTriangle(orders, mesh, other);
    ImGui::PopID();
    const std::string value = fmt::format("{:.3f}", ratio);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
    ImGui::TextColored(toImVec4(ratio < Bounds::areaRatio ? view.theme().text : bad), "%s", value.c_str());
  }
  birth(view, {Ref::Kind::triangle, mesh.ids[slot].n});
}

void inspectVertex(const View& view, Orders& orders, const MeshState& state, Vertex vertex) {
  const Mesh& mesh = state.mesh;
  figure(view, "kind", std::string(nameOf(mesh.kinds[vertex])));
  figure(view, "position", place(mesh.points[vertex]));
  if (const std::optional<Wanted> wanted = wantedAt(state.tree, mesh.points[vertex])) {
    figure(view, "edge length h wanted here", compact(wanted->length, 4));
    figure(view, "density rank here", std::to_string(wanted->rank));
  }
  if (!mesh.vertexTriangle[vertex].exists()) return;
  Star star;
  starOf(mesh, vertex, star);
  const std::vector<Slot> slots = slotsOf(star);
  figure(view, "triangles around it", std::to_string(slots.size()));
  for (const Slot slot : slots) {
    ImGui::PushID(slot.n);
    if (link(view, fmt::format("triangle {}", mesh.ids[slot]))) selectTriangle(orders, mesh, slot);
    ImGui::PopID();
  }
  birth(view, {Ref::Kind::vertex, vertex.word()});
}

void inspectEdge(const View& view, Orders& orders, const MeshState& state, const Selection& selection) {
  const Mesh& mesh = state.mesh;
  const Half half = selection.half();
  const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
  figure(view, "length", compact(distance(mesh.points[a], mesh.points[b]), 4));
  figure(view, "kind", constrained(mesh, half) ? "on the boundary" : "inside");
  ImGui::TextDisabled("between vertices");
  linkTo(view, orders, a);
  linkTo(view, orders, b);
  for (const Half side : {half, oppositeOf(mesh, half)}) {
    if (!side.exists()) continue;
    const Slot slot = triangleOf(side);
    ImGui::PushID(slot.n);
    if (link(view, fmt::format("triangle {}", mesh.ids[slot]))) selectTriangle(orders, mesh, slot);
    ImGui::PopID();
  }
}

void inspectCell(const View& view, const MeshState& state, std::int32_t index) {
  const Cell& cell = state.tree.cells[static_cast<std::size_t>(index)];
  figure(view, "cell rank j", fmt::format("{}", cell.rank));
  figure(view, "side", compact(state.tree.side(cell), 4));
  figure(view, "density rank i", fmt::format("{}", cell.density));
  figure(view, "edge length h", compact(edgeLengthOf(state.tree, cell.density), 4));
  figure(view, "type", std::string(name(cell.type)));
  figure(view, "triangles by Table 1", compact(trianglesInCell(cell.rank, cell.density)));
  const Point corner = state.tree.corner(cell);
  figure(view, "lower left corner", place(corner));
}

std::string titleOf(const Pick& pick) {
  switch (pick.selection.kind) {
    case Selection::Kind::none:
      return "";
    case Selection::Kind::vertex:
      return fmt::format("Vertex {}", pick.id);
    case Selection::Kind::edge:
      return fmt::format("Edge of triangle {}", pick.id);
    case Selection::Kind::triangle:
      return fmt::format("Triangle {}", pick.id);
    case Selection::Kind::cell:
      return fmt::format("Cell {}", pick.id);
  }
  return "";
}

}  // namespace

void drawInspect(const View& view, Orders& orders) {
  if (const DensityRequest* const request = view.request()) {
    // What is edited goes first, where it does not have to be scrolled to.
    inspectRequest(view, orders, *request);
    ImGui::Dummy({0, view.px(4)});
    return drawMeshFigures(view, orders);
  }
  drawMeshFigures(view, orders);
  const Pick& pick = view.ui.selected;
  ImGui::Dummy({0, view.px(4)});
  if (pick.selection.kind == Selection::Kind::none || view.now() == nullptr) {
    heading(view, "Nothing is selected");
    muted(view,
          "Click a vertex, an edge, a triangle or, where the quadtree is shown alone, a cell. Ctrl+click picks the "
          "cell below.");
    return;
  }
  title(view, titleOf(pick), "inspect.title");
  const Selection here = view.selection();
  const MeshState& state = view.now()->state;
  switch (here.kind) {
    case Selection::Kind::triangle:
      inspectTriangle(view, orders, state, here.slot());
      break;
    case Selection::Kind::vertex:
      inspectVertex(view, orders, state, here.vertex());
      break;
    case Selection::Kind::edge:
      inspectEdge(view, orders, state, here);
      break;
    case Selection::Kind::cell:
      inspectCell(view, state, here.index);
      break;
    case Selection::Kind::none:
      muted(view, "It is not part of the mesh at this moment.");
      break;
  }
}

}  // namespace triscope
