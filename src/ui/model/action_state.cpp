// What the panels ask of the state: what is selected, where the run is, which switches are on.
#include "ui/model/view.h"

namespace triscope {

const DensityRequest* View::request() const {
  const std::shared_ptr<const Domain>& domain = session.domain();
  const std::optional<std::size_t>& index = ui.density.request;
  if (now() == nullptr || domain == nullptr || ui.document.opening || !index) return nullptr;
  return *index < domain->density.size() ? &domain->density[*index] : nullptr;
}

Stage stageOf(const Snapshot& now) {
  return now.last && now.state.stage != Stage::finished ? now.last->stage : now.state.stage;
}

std::optional<bool> isOn(Action action, const UiState& ui) {
  const ViewOptions& o = ui.options;
  switch (action) {
    case Action::boundary:
      return o.boundary;
    case Action::boundary_points:
      return o.boundaryPoints;
    case Action::quadtree:
      return o.quadtree;
    case Action::constraints:
      return o.constraints;
    case Action::fronts:
      return o.fronts;
    case Action::steiner:
      return o.steiner;
    case Action::triangulation:
      return o.triangulation;
    case Action::obtuse:
      return o.obtuse;
    case Action::worst:
      return o.worst;
    case Action::decision:
      return o.decision;
    case Action::labels:
      return o.labels;
    case Action::legend:
      return ui.legendFolded ? ui.legendOver : ui.look.legend;
    case Action::side_panels:
      return ui.sidePanelsShown;
    case Action::place_density:
      return ui.density.placing;
    case Action::breakpoints_panel:
      return ui.debug.bottom == Panel::breakpoints;
    case Action::plots_panel:
      return ui.debug.bottom == Panel::plots;
    case Action::pin_run:
      return ui.pinned;
    case Action::compare_panel:
      return ui.debug.bottom == Panel::compare;
    case Action::sweep_panel:
      return ui.debug.bottom == Panel::sweep;
    case Action::help:
      return ui.dialog == Dialog::help;
    default:
      return std::nullopt;
  }
}

}  // namespace triscope
