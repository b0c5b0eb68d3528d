// What is done for each action and when it can be: the one way from every key, menu entry and button.
#include <algorithm>
#include <utility>

#include "ui/app/action_when.h"
#include "ui/app/app.h"

namespace triscope {
namespace {

constexpr int kFramesToType = 5;  // until keys go elsewhere again, should the field not take them

void flip(bool& value) { value = !value; }

template <class Deeds>
constexpr bool inOrder(const Deeds& deeds) {
  for (std::size_t i = 0; i < deeds.size(); ++i)
    if (static_cast<std::size_t>(deeds[i].id) != i) return false;
  return deeds.size() == static_cast<std::size_t>(kActionCount);
}

}  // namespace

const App::Deed& App::deedOf(Action action) {
  static constexpr auto kDeeds = std::to_array<Deed>({
      // File
      {Action::open, when::always,
       [](App& app) {
         app.openDialog_.prepare(app.shownDomain_ ? app.shownDomain_->file : std::string());
         app.openDialog(Dialog::open);
       }},
      {Action::reload, when::readsAgain, [](App& app) { app.apply(command::OpenFile{app.shownDomain_->file}); }},
      {Action::save_session, when::savesSession,
       [](App& app) {
         const std::string& path = app.ui_.document.path;
         path.empty() ? app.askWhereToSave() : app.saveTo(path);
       }},
      {Action::save_session_as, when::savesSession, [](App& app) { app.askWhereToSave(); }},
      {Action::restore_work, when::restores, [](App& app) { app.restore(); }},
      {Action::export_mesh, when::writes, [](App& app) { app.askWhereToExport(".msh"); }},
      {Action::save_picture, when::writes, [](App& app) { app.exportTo(app.freePath(".png")); }},
      {Action::save_figure, when::writes, [](App& app) { app.exportTo(app.freePath(".svg")); }},
      {Action::quit, when::always, [](App& app) { app.closing_ = true; }},
      // Run
      {Action::play_pause, when::playsOrPauses,
       [](App& app) {
         if (app.session_.busy()) return app.apply(command::Pause{});
         app.apply(command::Play{app.ui_.speed});
       }},
      {Action::step, when::goesOn, [](App& app) { app.apply(command::Advance{Grain::decision}); }},
      {Action::step_back, when::goesBack, [](App& app) { app.apply(command::StepBack{Grain::decision}); }},
      {Action::into, when::stepsInto, [](App& app) { app.stepInto(); }},
      {Action::into_back, when::goesBack, [](App& app) { app.stepBackOut(); }},
      {Action::insertion, when::goesOn, [](App& app) { app.apply(command::Advance{Grain::insertion}); }},
      {Action::insertion_back, when::goesBack, [](App& app) { app.apply(command::StepBack{Grain::insertion}); }},
      {Action::stage, when::goesOn, [](App& app) { app.apply(command::Advance{Grain::stage}); }},
      {Action::stage_back, when::goesBack, [](App& app) { app.apply(command::StepBack{Grain::stage}); }},
      {Action::round, when::goesOn, [](App& app) { app.apply(command::Advance{Grain::round}); }},
      {Action::restart, when::goesBack, [](App& app) { app.apply(command::Restart{}); }},
      {Action::to_end, when::goesOn, [](App& app) { app.apply(command::Advance{Grain::all}); }},
      {Action::slower, when::slower,
       [](App& app) { app.carryOut(order::SetSpeed{std::max(1.0, app.ui_.speed * 0.5)}); }},
      {Action::faster, when::faster,
       [](App& app) { app.carryOut(order::SetSpeed{std::min(100000.0, app.ui_.speed * 2.0)}); }},
      {Action::cancel, when::always, [](App& app) { app.cancel(); }},
      // Edit
      {Action::undo, when::undoes, [](App& app) { app.undo(); }},
      {Action::redo, when::redoes, [](App& app) { app.redo(); }},
      {Action::place_density, when::placesDensity, [](App& app) { app.togglePlacing(); }},
      {Action::delete_density, when::deletesDensity, [](App& app) { app.deleteRequest(); }},
      // Break
      {Action::continue_forward, when::goesOn, [](App& app) { app.search(command::Continue{false}); }},
      {Action::continue_back, when::continuesBack, [](App& app) { app.search(command::Continue{true}); }},
      {Action::breakpoint, when::hasSelection, [](App& app) { app.toggleBreakpoint(); }},
      {Action::first_violation, when::holdsRun, [](App& app) { app.search(command::FindViolation{}); }},
      {Action::bookmark, when::holdsRun, [](App& app) { app.toggleBookmark(); }},
      {Action::previous_mark, when::hasMarkBefore, [](App& app) { app.goToMark(false); }},
      {Action::next_mark, when::hasMarkAfter, [](App& app) { app.goToMark(true); }},
      {Action::why, when::hasSelection, [](App& app) { app.wantedTab_ = Panel::why; }},
      {Action::breakpoints_panel, when::always,
       [](App& app) {
         app.toggleBottom(Panel::breakpoints);
         app.ui_.debug.typeSoon = app.ui_.debug.bottom == Panel::breakpoints ? kFramesToType : 0;
       }},
      {Action::plots_panel, when::always, [](App& app) { app.toggleBottom(Panel::plots); }},
      // Compare
      {Action::pin_run, when::holdsRun, [](App& app) { app.togglePinned(); }},
      {Action::first_difference, when::differs,
       [](App& app) { app.apply(command::SeekEvent{*app.pinned_->firstDifference()}); }},
      {Action::compare_panel, when::always, [](App& app) { app.toggleBottom(Panel::compare); }},
      {Action::sweep_panel, when::always, [](App& app) { app.toggleBottom(Panel::sweep); }},
      {Action::run_sweep, when::sweeps, [](App& app) { app.runSweep(); }},
      {Action::save_sweep, when::savesSweep, [](App& app) { app.askWhereToExport("-sweep.csv"); }},
      {Action::cell_left, when::hasSweep, [](App& app) { app.moveCell(Action::cell_left); }},
      {Action::cell_right, when::hasSweep, [](App& app) { app.moveCell(Action::cell_right); }},
      {Action::cell_down, when::hasSweep, [](App& app) { app.moveCell(Action::cell_down); }},
      {Action::cell_up, when::hasSweep, [](App& app) { app.moveCell(Action::cell_up); }},
      {Action::take_cell, when::takesCell, [](App& app) { app.takeCell(); }},
      // View
      {Action::fit, when::hasMesh, [](App& app) { app.fit(); }},
      {Action::zoom_in, when::hasMesh, [](App& app) { app.zoomMiddle(1.25); }},
      {Action::zoom_out, when::hasMesh, [](App& app) { app.zoomMiddle(0.8); }},
      {Action::worst_aspect, when::hasWorstAspect,
       [](App& app) { app.showWorst(app.shown_->quality.aspectAt, -1); }},
      {Action::worst_area, when::hasWorstArea,
       [](App& app) { app.showWorst(app.shown_->quality.areaRatioAt, app.shown_->quality.areaRatioOther); }},
      {Action::worst_edge, when::hasWorstEdge,
       [](App& app) { app.showWorst(app.shown_->quality.edgeRatioAt, -1); }},
      {Action::boundary, when::always, [](App& app) { flip(app.ui_.options.boundary); }},
      {Action::boundary_points, when::always, [](App& app) { flip(app.ui_.options.boundaryPoints); }},
      {Action::quadtree, when::always, [](App& app) { app.toggleQuadtree(); }},
      {Action::constraints, when::always,
       [](App& app) {
         app.ui_.layersFollow = false;
         flip(app.ui_.options.constraints);
       }},
      {Action::fronts, when::always, [](App& app) { flip(app.ui_.options.fronts); }},
      {Action::steiner, when::always, [](App& app) { flip(app.ui_.options.steiner); }},
      {Action::triangulation, when::always, [](App& app) { flip(app.ui_.options.triangulation); }},
      {Action::obtuse, when::always, [](App& app) { flip(app.ui_.options.obtuse); }},
      {Action::worst, when::always, [](App& app) { flip(app.ui_.options.worst); }},
      {Action::decision, when::always, [](App& app) { flip(app.ui_.options.decision); }},
      {Action::labels, when::always, [](App& app) { flip(app.ui_.options.labels); }},
      {Action::legend, when::always,
       [](App& app) { flip(app.ui_.legendFolded ? app.ui_.legendOver : app.ui_.look.legend); }},
      {Action::next_fill, when::always,
       [](App& app) {
         TriangleFill& fill = app.ui_.options.fill;
         fill = static_cast<TriangleFill>((static_cast<int>(fill) + 1) % kTriangleFillCount);
       }},
      {Action::side_panels, when::always, [](App& app) { app.ui_.sidePanels = !app.ui_.sidePanelsShown; }},
      {Action::next_theme, when::always,
       [](App& app) {
         ThemeKind& theme = app.ui_.look.theme;
         theme = static_cast<ThemeKind>((static_cast<int>(theme) + 1) % 3);
       }},
      {Action::larger, when::larger, [](App& app) { app.setScale(app.ui_.scale() + 0.25); }},
      {Action::smaller, when::smaller, [](App& app) { app.setScale(app.ui_.scale() - 0.25); }},
      {Action::normal_size, when::always, [](App& app) { app.ui_.look.scale = 0.0; }},
      // Help
      {Action::help, when::always,
       [](App& app) { app.openDialog(app.ui_.dialog == Dialog::help ? Dialog::none : Dialog::help); }},
      {Action::about, when::always, [](App& app) { app.openDialog(Dialog::about); }},
  });
  static_assert(inOrder(kDeeds));
  return kDeeds[static_cast<std::size_t>(action)];
}

std::string whyNot(Action action, const View& view) { return App::deedOf(action).whyNot(view); }

void App::perform(Action action) {
  const Deed& deed = deedOf(action);
  if (std::string reason = deed.whyNot(view()); !reason.empty()) {
    ui_.message = std::move(reason);
    return;
  }
  ui_.message.clear();  // of what was done before
  deed.perform(*this);
}

void App::askWhereToSave() {
  saveDialog_.prepare(ui_.document.path.empty() ? suggestedPath(".session") : ui_.document.path);
  openDialog(Dialog::save_as);
}

void App::askWhereToExport(const char* extension) {
  exportDialog_.prepare(suggestedPath(extension));
  openDialog(Dialog::export_to);
}

void App::undo() {
  endTuning();
  const Edit back = ui_.undo.back();
  ui_.redo.push_back(inForce());
  ui_.undo.pop_back();
  bring(back);
}

void App::redo() {
  if (tuning_) return endTuning();  // what is being changed comes after what was taken back
  const Edit again = ui_.redo.back();
  ui_.undo.push_back(inForce());
  ui_.redo.pop_back();
  bring(again);
}

void App::toggleBottom(Panel panel) {
  std::optional<Panel>& bottom = ui_.debug.bottom;
  bottom = bottom == panel ? std::nullopt : std::optional(panel);
}

void App::toggleQuadtree() {
  ViewOptions& o = ui_.options;
  ui_.layersFollow = false;
  flip(o.quadtree);
  if (o.quadtree && o.triangulation && o.fill != TriangleFill::plain)
    ui_.message = "The quadtree is hidden by the coloured triangles; T or C lets it be seen.";
}

}  // namespace triscope
