// Density constraints edited with the mouse: each edit is another domain, and its mesh is made at once.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/density/wanted.h"
#include "core/io/domain_text.h"
#include "ui/app/app.h"
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

void App::editDensity(std::vector<DensityRequest> density, bool held) {
  const Edit edit{session_.settings(), withDensity(*session_.domain(), std::move(density))};
  if (held) return tune(edit);
  endTuning();
  remember(inForce());
  bring(edit);
}

void App::nameRequest(const order::NameRequest& typed) {
  DensityUi& ui = ui_.density;
  if (!typed.done) {
    ui.name = typed.text;
    return;
  }
  const std::optional<std::string> name = std::exchange(ui.name, std::nullopt);
  const DensityRequest* const request = view().request();
  if (!name || request == nullptr || request->name == *name) return;
  std::vector<DensityRequest> density = session_.domain()->density;
  density[*ui.request].name = *name;
  editDensity(std::move(density), false);
}

void App::placeRequest(Point at) {
  if (const std::string reason = whyNot(Action::place_density, view()); !reason.empty()) {
    ui_.message = reason;
    return;
  }
  const Domain& domain = *session_.domain();
  DensityRequest request;
  request.at = within(domain.bounds, at);
  request.length = suggestedLength(shown_->state, domain, request.at);
  std::vector<DensityRequest> density = domain.density;
  density.push_back(request);
  const std::size_t index = density.size() - 1;
  editDensity(std::move(density), false);
  selectRequest(index);
}

void App::moveRequest(Point to) {
  if (view().request() == nullptr) return;
  const Domain& domain = *session_.domain();
  std::vector<DensityRequest> density = domain.density;
  DensityRequest& request = density[*ui_.density.request];
  if (request.where == DensityRequest::Where::loop) {
    ui_.message = fmt::format("It holds all along the loop '{}', so it cannot be moved.", request.loop);
    return;
  }
  const Point by = within(domain.bounds, to) - handleOf(domain, request);
  request.at = request.at + by;
  request.to = request.to + by;
  if (request != domain.density[*ui_.density.request]) editDensity(std::move(density), true);
}

void App::deleteRequest() {
  if (view().request() == nullptr) return;
  std::vector<DensityRequest> density = session_.domain()->density;
  density.erase(density.begin() + static_cast<std::ptrdiff_t>(*ui_.density.request));
  ui_.density.request.reset();
  ui_.density.held = false;
  editDensity(std::move(density), false);
}

void App::selectRequest(std::optional<std::size_t> index) {
  select({});
  ui_.density.request = index;
  wantedTab_ = Panel::inspect;
}

void App::togglePlacing() {
  DensityUi& density = ui_.density;
  density.placing = !density.placing;
  ui_.message.clear();  // the status bar tells what the mouse does now
}

}  // namespace triscope
