#include "ui/app/density_editing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/density/wanted.h"
#include "core/io/domain_text.h"
#include "ui/app/action_when.h"
#include "ui/kit/density_handles.h"

namespace triscope {
namespace {

Point within(const Box& box, Point p) {
  return {std::clamp(p.x, box.lo.x, box.hi.x), std::clamp(p.y, box.lo.y, box.hi.y)};
}

/// Half of what is wanted there now, so that a new constraint shows; three digits are easier to read on.
double suggestedLength(const MeshState& state, const Domain& domain, Point p) {
  const double extent = std::max(domain.bounds.width(), domain.bounds.height());
  const std::optional<Wanted> now = wantedAt(state.tree, p);
  const double half = std::strtod(fmt::format("{:.3g}", now ? 0.5 * now->length : extent / 40.0).c_str(), nullptr);
  return std::max({half, domain.minEdgeLength, state.minEdge});
}

}  // namespace

void DensityEditing::edit(const order::EditDensity& order) {
  const Edit edit{desk_.session.settings(), withDensity(*desk_.session.domain(), order.density)};
  order.held ? tuning_.hold(edit) : tuning_.change(edit);
}

void DensityEditing::name(const order::NameRequest& typed) {
  DensityUi& ui = desk_.ui.density;
  if (!typed.done) {
    ui.name = typed.text;
    return;
  }
  const std::optional<std::string> name = std::exchange(ui.name, std::nullopt);
  const DensityRequest* const request = runOf(desk_).request();
  if (!name || request == nullptr || request->name == *name) return;
  std::vector<DensityRequest> density = desk_.session.domain()->density;
  density[*ui.request].name = *name;
  edit({std::move(density), false});
}

void DensityEditing::place(Point at) {
  if (std::string reason = when::placesDensity(runOf(desk_)); !reason.empty()) {
    desk_.ui.message = std::move(reason);
    return;
  }
  const Domain& domain = *desk_.session.domain();
  DensityRequest request;
  request.at = within(domain.bounds, at);
  request.length = suggestedLength(desk_.shown->state, domain, request.at);
  std::vector<DensityRequest> density = domain.density;
  density.push_back(request);
  const std::size_t index = density.size() - 1;
  edit({std::move(density), false});
  select({index, desk_.ui.density.held});
}

void DensityEditing::move(Point to) {
  if (runOf(desk_).request() == nullptr) return;
  const Domain& domain = *desk_.session.domain();
  std::vector<DensityRequest> density = domain.density;
  DensityRequest& request = density[*desk_.ui.density.request];
  if (request.where == DensityRequest::Where::loop) {
    desk_.ui.message = fmt::format("It holds all along the loop '{}', so it cannot be moved.", request.loop);
    return;
  }
  const Point by = within(domain.bounds, to) - handleOf(domain, request);
  request.at = request.at + by;
  request.to = request.to + by;
  if (request != domain.density[*desk_.ui.density.request]) edit({std::move(density), true});
}

void DensityEditing::remove() {
  if (runOf(desk_).request() == nullptr) return;
  std::vector<DensityRequest> density = desk_.session.domain()->density;
  density.erase(density.begin() + static_cast<std::ptrdiff_t>(*desk_.ui.density.request));
  desk_.ui.density.request.reset();
  letGo();
  edit({std::move(density), false});
}

void DensityEditing::select(const order::SelectRequest& order) {
  triscope::select(desk_.ui, {});
  desk_.ui.density.request = order.index;
  desk_.ui.density.held = order.held;
  desk_.orders.emplace_back(order::ShowTab{Panel::inspect});
}

void DensityEditing::togglePlacing() {
  desk_.ui.density.placing = !desk_.ui.density.placing;
  desk_.ui.message.clear();  // the status bar tells what the mouse does now
}

void DensityEditing::follow() {
  if (runOf(desk_).request() == nullptr) desk_.ui.density.request.reset();
}

}  // namespace triscope
