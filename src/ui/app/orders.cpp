#include "ui/app/orders.h"

#include <utility>

#include "ui/app/framing.h"
#include "ui/app/switches.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

bool searches(const Command& command) {
  return std::holds_alternative<command::Continue>(command) || std::holds_alternative<command::FindViolation>(command);
}

struct CarryOut {
  Parts& p;
  UiState& ui = p.desk.ui;

  void operator()(Action action) const { perform(p, action); }
  void operator()(const Command& command) const { apply(p, command); }
  // The picture.
  void operator()(const ViewOptions& options) const { ui.options = options; }
  void operator()(const order::LayersFollow& o) const { ui.layersFollow = o.on; }
  void operator()(const Camera& camera) const {
    ui.camera = camera;
    ui.fitted = false;
  }
  void operator()(const order::Frame& o) const { frameBox(ui, o.box); }
  void operator()(const order::SelectElement& o) const {
    select(ui, o.pick);
    if (o.pick.selection.kind == Selection::Kind::none) ui.options.brush = {};  // a click beside everything
  }
  // The window.
  void operator()(const Appearance& look) const { ui.look = look; }
  void operator()(const order::ShowTab& o) const { p.wantedTab = o.panel; }
  void operator()(const order::CloseDialog&) const { ui.dialog = Dialog::none; }
  void operator()(const order::SetSpeed& o) const { setSpeed(p.desk, o.decisionsPerSecond); }
  // Parameters and density.
  void operator()(const order::Tune& o) const { p.tuning.hold({o.settings, p.desk.session.domain()}); }
  void operator()(const order::EndTuning&) const {
    p.density.letGo();
    p.tuning.end();
  }
  void operator()(const order::EditDensity& o) const { p.density.edit(o); }
  void operator()(const order::NameRequest& o) const { p.density.name(o); }
  void operator()(const order::PlaceRequest& o) const { p.density.place(o.at); }
  void operator()(const order::MoveRequest& o) const { p.density.move(o.to); }
  void operator()(const order::SelectRequest& o) const { p.density.select(o); }
  // The document.
  void operator()(const order::SaveTo& o) const { p.document.saveTo(o.path); }
  void operator()(const order::ExportTo& o) const { p.exporting.writeTo(o.path); }
  void operator()(const order::WriteNotes& o) const { ui.document.notes = o.text; }
  void operator()(const order::Kept& o) const { p.document.answerOffer(o); }
  // The debugger.
  void operator()(const order::FollowLink& o) const { p.debugging.follow(o.ref); }
  void operator()(const order::ShowRange& o) const {
    ui.debug.from = o.from;
    ui.debug.to = o.to;
  }
  void operator()(const order::TypeCondition& o) const { p.debugging.type(o); }
  void operator()(const order::AddBreakpoint&) const { p.debugging.addBreakpoint(); }
  void operator()(const order::NameBookmark& o) const { ui.debug.bookmarks[o.index].name = o.name; }
  void operator()(const order::DropBookmark& o) const {
    ui.debug.bookmarks.erase(ui.debug.bookmarks.begin() + static_cast<std::ptrdiff_t>(o.index));
  }
  void operator()(const order::ShowPlot& o) const {
    ui.debug.plot = static_cast<PlotOf>(o.plot);
    ui.debug.histogram = static_cast<Measure>(o.histogram);
  }
  // Sweeps.
  void operator()(const SweepChoice& choice) const { ui.sweep.choice = choice; }
  void operator()(const order::CancelSweep&) const { p.sweeping.cancel(); }
  void operator()(const order::ChooseCell& o) const { ui.sweep.chosen = o.cell; }
};

}  // namespace

void carryOut(Parts& parts, const Order& order) {
  std::visit(CarryOut{parts}, order);
  follow(parts);
}

void carryOut(Parts& parts, const Orders& orders) {
  for (const Order& order : orders) {
    carryOut(parts, order);
    // What an owner orders in turn comes before what was ordered after.
    carryOut(parts, std::exchange(parts.desk.orders, {}));
  }
}

void perform(Parts& parts, Action action) {
  if (std::string reason = infoOf(action).whyNot(viewOf(parts)); !reason.empty()) {
    parts.desk.ui.message = std::move(reason);
    return;
  }
  parts.desk.ui.message.clear();  // of what was done before
  infoOf(action).perform(parts);
}

void apply(Parts& parts, const Command& command) {
  if (const auto* changed = std::get_if<command::Change>(&command))
    return parts.tuning.change({changed->settings, parts.desk.session.domain()});
  parts.desk.ui.message.clear();
  parts.walk.giveUpEntering();
  if (const auto* file = std::get_if<command::OpenFile>(&command)) return parts.document.open(file->path);
  if (searches(command)) parts.debugging.expectFound();
  give(parts.desk, command);
}

void cancelInnermost(Parts& parts) {
  UiState& ui = parts.desk.ui;
  if (ui.dialog != Dialog::none)
    ui.dialog = Dialog::none;
  else if (menuOpen())
    closeMenus();
  else if (parts.tuning.canCancel())
    parts.tuning.cancel();
  else if (parts.desk.session.busy())
    apply(parts, command::Cancel{});
  else if (ui.sweep.making)
    parts.sweeping.cancel();
  else if (parts.sweeping.mapShown() && ui.sweep.chosen)
    ui.sweep.chosen.reset();
  else if (ui.insertion.now)
    parts.walk.leave();
  else if (ui.density.placing)
    parts.density.togglePlacing();
  else if (ui.options.brush.on)
    ui.options.brush = {};
  else if (ui.density.request)
    ui.density.request.reset();
  else if (ui.selected.selection.kind != Selection::Kind::none)
    select(ui, {});
}

}  // namespace triscope
