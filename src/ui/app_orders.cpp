// What orders do.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

using std::chrono::milliseconds;

// A step that takes longer than this is shown when it is done; until then the window goes on.
constexpr auto kPatience = milliseconds(40);

}  // namespace

void App::carryOut(const Order& order) {
  struct Visitor {
    App& app;
    void operator()(Action action) const { app.perform(action); }
    void operator()(const Command& command) const { app.apply(command); }
    void operator()(const ViewOptions& options) const { app.ui_.options = options; }
    void operator()(const order::LayersFollow& o) const { app.ui_.layersFollow = o.on; }
    void operator()(const Camera& camera) const {
      app.ui_.camera = camera;
      app.fitted_ = false;
    }
    void operator()(const Appearance& look) const { app.ui_.look = look; }
    void operator()(const order::SelectElement& o) const {
      app.select(o.pick);
      if (o.pick.selection.kind == Selection::Kind::none) app.ui_.options.brush = {};  // a click beside everything
    }
    void operator()(const order::Frame& o) const { app.frameBox(o.box, 0.0); }
    void operator()(const order::Tune& o) const { app.tune({o.settings, app.session_.domain()}); }
    void operator()(const order::EndTuning&) const {
      app.ui_.density.held = false;
      app.endTuning();
    }
    void operator()(const order::SetSpeed& o) const {
      app.ui_.speed = o.decisionsPerSecond;
      if (app.session_.progress().activity == Activity::playing)
        app.session_.apply(command::Play{o.decisionsPerSecond});
    }
    void operator()(const order::ExportTo& o) const { app.exportTo(o.path); }
    void operator()(const order::ShowTab& o) const { app.wantedTab_ = o.name; }
    void operator()(const order::CloseDialog&) const { app.ui_.dialog = Dialog::none; }
    void operator()(const order::FollowLink& o) const { app.follow(o.ref); }
    void operator()(const order::ShowRange& o) const {
      app.ui_.debug.from = o.from;
      app.ui_.debug.to = o.to;
    }
    void operator()(const order::TypeCondition& o) const {
      app.ui_.debug.condition = o.text;
      app.ui_.debug.action = o.action;
      app.ui_.debug.complaint.reset();
    }
    void operator()(const order::AddBreakpoint&) const { app.addBreakpoint(); }
    void operator()(const SweepChoice& choice) const { app.ui_.sweep.choice = choice; }
    void operator()(const order::CancelSweep&) const { app.sweep_.cancel(); }
    void operator()(const order::ChooseCell& o) const { app.ui_.sweep.chosen = o.cell; }
    void operator()(const order::ShowPlot& o) const {
      app.ui_.debug.plot = static_cast<PlotOf>(o.plot);
      app.ui_.debug.histogram = static_cast<Measure>(o.histogram);
    }
    void operator()(const order::EditDensity& o) const { app.editDensity(o.density, o.held); }
    void operator()(const order::NameRequest& o) const { app.nameRequest(o); }
    void operator()(const order::PlaceRequest& o) const { app.placeRequest(o.at); }
    void operator()(const order::MoveRequest& o) const { app.moveRequest(o.to); }
    void operator()(const order::SelectRequest& o) const {
      app.selectRequest(o.index);
      app.ui_.density.held = o.held;
    }
    void operator()(const order::SaveTo& o) const { app.saveTo(o.path); }
    void operator()(const order::WriteNotes& o) const { app.ui_.document.notes = o.text; }
    void operator()(const order::NameBookmark& o) const { app.ui_.debug.bookmarks[o.index].name = o.name; }
    void operator()(const order::DropBookmark& o) const {
      std::vector<Bookmark>& marks = app.ui_.debug.bookmarks;
      marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(o.index));
    }
    void operator()(const order::Kept& o) const {
      app.ui_.document.offering = false;
      if (o.what == order::Kept::What::restore) app.restore();
      if (o.what == order::Kept::What::discard) app.discardKept();
    }
  };
  std::visit(Visitor{*this}, order);
}

void App::apply(const Command& command) {
  if (const auto* changed = std::get_if<command::Change>(&command)) return change(changed->settings);
  ui_.message.clear();
  entering_ = {};
  run(command);
}

void App::run(const Command& command) {
  if (const auto* file = std::get_if<command::OpenFile>(&command))
    openFile(file->path);
  else
    session_.apply(command);
  // What is quick is shown in this very frame.
  if (!std::holds_alternative<command::Play>(command)) session_.settle(kPatience);
  followRun();
  followInsertion();
  showFound();
}

void App::change(const Settings& settings) {
  endTuning();
  remember(inForce());
  bring({settings, session_.domain()});
}

void App::remember(const Edit& before) {
  if (ui_.document.opening) return;  // it is of another document than what can be taken back
  ui_.undo.push_back(before);
  ui_.redo.clear();
}

void App::bring(const Edit& edit) {
  leaveInsertion();
  entering_ = {};
  if (edit.domain == session_.domain()) {
    session_.apply(command::Change{edit.settings});
  } else {
    versions_.push_back(edit.domain);
    const MeshState& now = shown_->state;
    const bool toEnd = now.stage == Stage::finished;
    session_.apply(
        command::Load{edit.domain, edit.settings, toEnd ? std::optional<std::uint64_t>() : std::optional(now.tick)});
  }
  session_.settle(kPatience);
  followRun();
}

void App::tune(const Edit& edit) {
  if (ui_.document.opening) return bring(edit);
  if (!tuning_) tuning_ = Tuning{inForce()};
  if (!tuning_->cancelled) bring(edit);
}

void App::endTuning() {
  const std::optional<Tuning> tuned = std::exchange(tuning_, std::nullopt);
  if (tuned && inForce() != tuned->before) remember(tuned->before);
}

void App::cancelTuning() {
  tuning_->cancelled = true;  // what the control says until it is let go is passed over
  const Edit before = tuning_->before;
  if (session_.stale() && shown_ != nullptr && Edit{shown_->state.settings, shown_->state.domain} == before)
    return apply(command::Cancel{});
  if (inForce() != before) bring(before);
}

void App::perform(Action action) {
  if (const std::string reason = whyNot(action, view()); !reason.empty()) {
    ui_.message = reason;
    return;
  }
  ui_.message.clear();  // of what was done before
  switch (action) {
    case Action::open:
      openDialog_.prepare(shownDomain_ ? shownDomain_->file : std::string());
      return openDialog(Dialog::open);
    case Action::reload:
      return apply(command::OpenFile{shownDomain_->file});
    case Action::save_session:
      if (!ui_.document.path.empty()) return saveTo(ui_.document.path);
      [[fallthrough]];
    case Action::save_session_as:
      saveDialog_.prepare(ui_.document.path.empty() ? suggestedPath(".session") : ui_.document.path);
      return openDialog(Dialog::save_as);
    case Action::restore_work:
      return restore();
    case Action::export_mesh:
      exportDialog_.prepare(suggestedPath(".msh"));
      return openDialog(Dialog::export_to);
    case Action::save_picture:
      return exportTo(freePath(".png"));
    case Action::save_figure:
      return exportTo(freePath(".svg"));
    case Action::quit:
      closing_ = true;
      return;
    case Action::help:
      return openDialog(ui_.dialog == Dialog::help ? Dialog::none : Dialog::help);
    case Action::about:
      return openDialog(Dialog::about);
    case Action::cancel:
      return cancel();
    case Action::fit:
      return fit();
    case Action::zoom_in:
      return zoomMiddle(1.25);
    case Action::zoom_out:
      return zoomMiddle(0.8);
    case Action::worst_aspect:
      return showWorst(shown_->quality.aspectAt, -1);
    case Action::worst_area:
      return showWorst(shown_->quality.areaRatioAt, shown_->quality.areaRatioOther);
    case Action::worst_edge:
      return showWorst(shown_->quality.edgeRatioAt, -1);
    case Action::place_density:
      return togglePlacing();
    case Action::delete_density:
      return deleteRequest();
    case Action::into:
      return stepInto();
    case Action::into_back:
      return stepBackOut();
    case Action::next_theme:
      ui_.look.theme = static_cast<ThemeKind>((static_cast<int>(ui_.look.theme) + 1) % 3);
      return;
    case Action::larger:
      return setScale(ui_.scale() + 0.25);
    case Action::smaller:
      return setScale(ui_.scale() - 0.25);
    case Action::normal_size:
      ui_.look.scale = 0.0;
      return;
    case Action::next_fill:
      ui_.options.fill = static_cast<TriangleFill>((static_cast<int>(ui_.options.fill) + 1) % kTriangleFillCount);
      return;
    default:
      break;
  }
  if (infoOf(action).menu == Menu::debug || infoOf(action).menu == Menu::compare)
    performDebug(action);
  else if (isOn(action, ui_))
    toggle(action);
  else
    performOnRun(action);
}

void App::performOnRun(Action action) {
  switch (action) {
    case Action::play_pause:
      if (session_.busy()) return apply(command::Pause{});
      return apply(command::Play{ui_.speed});
    case Action::step:
      return apply(command::Advance{Grain::decision});
    case Action::step_back:
      return apply(command::StepBack{Grain::decision});
    case Action::insertion:
      return apply(command::Advance{Grain::insertion});
    case Action::insertion_back:
      return apply(command::StepBack{Grain::insertion});
    case Action::stage:
      return apply(command::Advance{Grain::stage});
    case Action::stage_back:
      return apply(command::StepBack{Grain::stage});
    case Action::round:
      return apply(command::Advance{Grain::round});
    case Action::restart:
      return apply(command::Restart{});
    case Action::to_end:
      return apply(command::Advance{Grain::all});
    case Action::slower:
      return carryOut(order::SetSpeed{std::max(1.0, ui_.speed * 0.5)});
    case Action::faster:
      return carryOut(order::SetSpeed{std::min(100000.0, ui_.speed * 2.0)});
    case Action::undo: {
      endTuning();
      const Edit back = ui_.undo.back();
      ui_.redo.push_back(inForce());
      ui_.undo.pop_back();
      return bring(back);
    }
    case Action::redo: {
      if (tuning_) return endTuning();  // what is being changed comes after what was taken back
      const Edit again = ui_.redo.back();
      ui_.undo.push_back(inForce());
      ui_.redo.pop_back();
      return bring(again);
    }
    default:
      return;
  }
}

void App::toggle(Action action) {
  ViewOptions& o = ui_.options;
  const auto flip = [](bool& value) { value = !value; };
  switch (action) {
    case Action::boundary:
      return flip(o.boundary);
    case Action::boundary_points:
      return flip(o.boundaryPoints);
    case Action::quadtree:
      ui_.layersFollow = false;
      flip(o.quadtree);
      if (o.quadtree && o.triangulation && o.fill != TriangleFill::plain)
        ui_.message = "The quadtree is hidden by the coloured triangles; T or C lets it be seen.";
      return;
    case Action::constraints:
      ui_.layersFollow = false;
      return flip(o.constraints);
    case Action::fronts:
      return flip(o.fronts);
    case Action::steiner:
      return flip(o.steiner);
    case Action::triangulation:
      return flip(o.triangulation);
    case Action::obtuse:
      return flip(o.obtuse);
    case Action::worst:
      return flip(o.worst);
    case Action::decision:
      return flip(o.decision);
    case Action::labels:
      return flip(o.labels);
    case Action::legend:
      return flip(ui_.legendFolded ? ui_.legendOver : ui_.look.legend);
    case Action::side_panels:
      ui_.sidePanels = !ui_.sidePanelsShown;
      return;
    default:
      return;
  }
}

void App::cancel() {
  if (ui_.dialog != Dialog::none)
    ui_.dialog = Dialog::none;
  else if (menuOpen())
    closeMenus();
  else if (tuning_ && !tuning_->cancelled)
    cancelTuning();
  else if (session_.busy())
    apply(command::Cancel{});
  else if (ui_.sweep.making)
    sweep_.cancel();
  else if (heatMapShown() && ui_.sweep.chosen)
    ui_.sweep.chosen.reset();
  else if (ui_.insertion.now)
    leaveInsertion();
  else if (ui_.density.placing)
    togglePlacing();
  else if (ui_.options.brush.on)
    ui_.options.brush = {};
  else if (ui_.density.request)
    ui_.density.request.reset();
  else if (ui_.selected.selection.kind != Selection::Kind::none)
    select({});
}

void App::select(const Pick& pick) {
  ui_.selected = pick;
  ui_.density.request.reset();
}

void App::setScale(double scale) { ui_.look.scale = std::clamp(std::round(scale * 4.0) / 4.0, 0.75, 3.0); }

void App::openDialog(Dialog dialog) {
  ui_.dialog = dialog;
  if (dialog != Dialog::error) ui_.error.reset();
}

}  // namespace triscope
