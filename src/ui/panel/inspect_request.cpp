// The density constraint that is selected: what it asks for, to be changed.
#include <imgui.h>
// After imgui.h, which it needs.
#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/density/sources.h"
#include "core/density/wanted.h"
#include "ui/kit/density_handles.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

constexpr int kCoarsestRank = 64;

/// The rank whose edge length is nearest. Ranks of a constraint are multiples of the Δx in force, see lengthWanted(),
/// and not of the tree's own length: what a domain file asks for does not change with its shortest edge.
int rankOf(double length, double minEdge) {
  return std::clamp(static_cast<int>(std::lround(3.0 * std::log2(length / minEdge))) + 1, 1, kCoarsestRank);
}

/// The control for the wish; true when it was changed. A drag is held until it is let go.
bool wish(const View& view, DensityRequest& request) {
  const double minEdge = view.now()->state.minEdge;
  const Domain& domain = *view.session.domain();
  bool byRank = request.rank > 0;
  bool changed = false;
  if (ImGui::RadioButton("edge length", !byRank) && byRank) {
    request.length = std::max(lengthWanted(request, minEdge), domain.minEdgeLength);
    request.rank = 0;
    changed = true;
  }
  note(view, "request.by_length");
  besideIfFits("    density rank");
  byRank = request.rank > 0;
  if (ImGui::RadioButton("density rank", byRank) && !byRank) {
    request.rank = rankOf(request.length, minEdge);
    request.length = 0.0;
    changed = true;
  }
  note(view, "request.by_rank");
  ImGui::SetNextItemWidth(-1.0f);
  if (request.rank > 0) {
    changed |= ImGui::DragInt("##rank", &request.rank, 0.1f, 1, kCoarsestRank, "rank %d", ImGuiSliderFlags_AlwaysClamp);
  } else {
    const double extent = std::max(domain.bounds.width(), domain.bounds.height());
    const double least = domain.minEdgeLength > 0.0 ? domain.minEdgeLength : 1e-5 * extent;
    const auto pace = static_cast<float>(0.01 * request.length);
    changed |= ImGui::DragScalar("##length", ImGuiDataType_Double, &request.length, pace, &least, &extent, "h %.4g",
                                 ImGuiSliderFlags_AlwaysClamp);
  }
  note(view, "request.value");
  return changed;
}

}  // namespace

void inspectRequest(const View& view, Orders& orders, DensityRequest request) {
  const std::vector<DensityRequest>& density = view.session.domain()->density;
  const std::size_t index = *view.ui.density.request;
  title(view, fmt::format("Density constraint {}", index + 1), "inspect.title");
  const auto edit = [&](bool held) {
    std::vector<DensityRequest> list = density;
    list[index] = request;
    orders.emplace_back(order::EditDensity{std::move(list), held});
  };
  muted(view, "name");
  ImGui::SetNextItemWidth(-1.0f);
  std::string name = view.ui.density.name.value_or(request.name);
  if (ImGui::InputText("##name", &name)) orders.emplace_back(order::NameRequest{name, false});
  note(view, "request.name");
  if (ImGui::IsItemDeactivated()) orders.emplace_back(order::NameRequest{"", true});
  muted(view, "asks for");
  const bool changed = wish(view, request);
  if (changed) edit(true);
  // The buttons before it are done with one click; the drag goes on until it is let go.
  if (ImGui::IsItemDeactivated() || (changed && !ImGui::IsItemActive())) orders.emplace_back(order::EndTuning{});
  tip(view, "Drag, or Ctrl+click to type a value.");
  const Point at = handleOf(*view.session.domain(), request);
  const std::optional<Wanted> wanted = view.session.stale() ? std::nullopt : wantedAt(view.now()->state.tree, at);
  if (wanted) figure(view, "h wanted there now", compact(wanted->length, 4));
  if (request.where == DensityRequest::Where::loop) {
    figure(view, "on the loop", request.loop);
    muted(view, "It holds all along the loop, so it cannot be moved.");
  } else {
    figure(view, "position", fmt::format("{}, {}", compact(at.x, 5), compact(at.y, 5)));
  }
  actionButton(view, orders, Action::delete_density, Icon::none);
  muted(view, "It is part of the session. Ctrl+E, .json writes the domain file with it.");
}

}  // namespace triscope
