// Which actions can be done now, and why the others cannot.
#include "ui/view.h"

namespace triscope {
namespace {

constexpr const char* kOpening = "Another domain is being opened; wait, or press Esc to keep this one.";

std::string needsForward(const View& view) {
  if (view.now() == nullptr) return "There is no mesh yet.";
  if (view.session.stale()) return "A new mesh is being made; wait, or press Esc to keep the old one.";
  const MeshState& state = view.now()->state;
  if (state.failed) return "The method stopped here; change a parameter or the domain.";
  if (state.stage == Stage::finished) return "The run is finished. Go back, or restart.";
  return {};
}

std::string needsBack(const View& view) {
  if (view.now() == nullptr) return "There is no mesh yet.";
  if (view.session.stale()) return "A new mesh is being made; wait, or press Esc to keep the old one.";
  if (view.now()->state.tick == 0) return "This is the start of the run.";
  return {};
}

std::string needsTriangle(const View& view, std::int32_t Quality::* slot) {
  if (view.now() == nullptr || view.now()->quality.*slot < 0) return "There are no triangles to judge yet.";
  return {};
}

}  // namespace

std::string whyNot(Action action, const View& view) {
  switch (action) {
    case Action::play_pause:
      return view.session.busy() && !view.session.stale() ? std::string() : needsForward(view);
    case Action::into:
      // Its phases are gone through even where nothing follows them.
      if (view.ui.insertion.now && view.ui.insertion.phase != InsertionPhase::filled) return {};
      return needsForward(view);
    case Action::step:
    case Action::insertion:
    case Action::stage:
    case Action::round:
    case Action::to_end:
      return needsForward(view);
    case Action::step_back:
    case Action::into_back:
    case Action::insertion_back:
    case Action::stage_back:
    case Action::restart:
      return needsBack(view);
    case Action::save_session:
    case Action::save_session_as:
      if (view.now() == nullptr) return "There is nothing to save yet.";
      return view.ui.document.saving ? "The session is being written." : "";
    case Action::restore_work:
      return view.ui.document.kept.empty() ? "No work was left behind." : "";
    case Action::export_mesh:
    case Action::save_picture:
    case Action::save_figure:
      if (view.now() == nullptr) return "There is nothing to write yet.";
      return view.ui.exporting ? "A file is being written." : "";
    case Action::reload:
      if (view.now() == nullptr) return "No domain is open.";
      return view.now()->state.domain->file.empty() ? "This sample is built in; there is no file to read again." : "";
    case Action::undo:
      if (view.ui.document.opening) return kOpening;
      return view.ui.undo.empty() ? "Nothing has been changed." : "";
    case Action::redo:
      if (view.ui.document.opening) return kOpening;
      return view.ui.redo.empty() ? "Nothing was taken back." : "";
    case Action::place_density:
      if (view.now() == nullptr) return "There is no domain yet.";
      return view.ui.document.opening ? kOpening : "";
    case Action::delete_density:
      return view.request() != nullptr ? "" : "No density constraint is selected.";
    case Action::worst_aspect:
      return needsTriangle(view, &Quality::aspectAt);
    case Action::worst_area:
      return needsTriangle(view, &Quality::areaRatioAt);
    case Action::worst_edge:
      return needsTriangle(view, &Quality::edgeRatioAt);
    case Action::fit:
    case Action::zoom_in:
    case Action::zoom_out:
      return view.now() == nullptr ? "There is nothing to look at yet." : "";
    case Action::slower:
      return view.ui.speed <= 1.0 ? "This is the slowest." : "";
    case Action::faster:
      return view.ui.speed >= 100000.0 ? "This is the fastest; go to the end instead." : "";
    case Action::larger:
      return view.ui.scale() >= 3.0 ? "300 % is the largest." : "";
    case Action::smaller:
      return view.ui.scale() <= 0.75 ? "75 % is the smallest." : "";
    case Action::run_sweep:
    case Action::save_sweep:
    case Action::cell_left:
    case Action::cell_right:
    case Action::cell_down:
    case Action::cell_up:
    case Action::take_cell:
      return whyNotSweep(action, view);
    default:
      return whyNotDebug(action, view);
  }
}

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
      return ui.debug.bottom == "Breakpoints";
    case Action::plots_panel:
      return ui.debug.bottom == "Plots";
    case Action::pin_run:
      return ui.pinned;
    case Action::compare_panel:
      return ui.debug.bottom == "Compare";
    case Action::sweep_panel:
      return ui.debug.bottom == "Sweep";
    case Action::help:
      return ui.dialog == Dialog::help;
    default:
      return std::nullopt;
  }
}

}  // namespace triscope
