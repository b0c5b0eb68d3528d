// What orders do.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/app.h"
#include "ui/kit/widgets.h"

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
    void operator()(const order::ShowTab& o) const { app.wantedTab_ = o.panel; }
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
