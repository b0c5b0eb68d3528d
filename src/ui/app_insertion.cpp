// Stepping through one insertion. The state before it and the one after are the session's, as everywhere: the phases
// are what takeApart() finds in the one before.
#include <algorithm>

#include "core/geometry/circumcircle.h"
#include "core/mesh/edit.h"
#include "ui/app.h"

namespace triscope {
namespace {

using Phase = InsertionPhase;

Phase next(Phase phase, int by) { return static_cast<Phase>(static_cast<int>(phase) + by); }

/// What the phases show: candidate, walk, cavity and the circles about the point.
Box extentOf(const Insertion& insertion, const Mesh& mesh) {
  Box box;
  box.include(insertion.at);
  const auto add = [&](std::int32_t slot) {
    for (const std::int32_t v : triangleAt(mesh, slot).v) box.include(pointOf(mesh, v));
  };
  if (insertion.candidate >= 0) add(insertion.candidate);
  for (const std::int32_t slot : insertion.walk) add(slot);
  for (const std::int32_t slot : insertion.cavity.triangles) add(slot);
  if (insertion.measured) {
    const double reach =
        std::max(insertion.measured->limit, distance(insertion.measured->from, insertion.measured->to));
    box.include(insertion.measured->from - Point{reach, reach});
    box.include(insertion.measured->from + Point{reach, reach});
  }
  return box;
}

bool inside(const Box& inner, const Box& outer) {
  return inner.lo.x >= outer.lo.x && inner.lo.y >= outer.lo.y && inner.hi.x <= outer.hi.x && inner.hi.y <= outer.hi.y;
}

}  // namespace

void App::stepInto() {
  if (ui_.insertion.now && ui_.insertion.phase != Phase::filled) return showPhase(next(ui_.insertion.phase, 1));
  ui_.message.clear();
  entering_ = {Entering::Step::after, Phase::candidate, shown_->state.mesh.points.size(), 0};
  run(command::Advance{Grain::insertion});
}

void App::stepBackOut() {
  const InsertionUi& insertion = ui_.insertion;
  if (insertion.now && insertion.phase != Phase::candidate) return showPhase(next(insertion.phase, -1));
  ui_.message.clear();
  const bool here = shown_->last && inserts(*shown_->last);
  // In the middle of nothing the insertion just made is entered from its end; from the first phase it is the one
  // before.
  if (here) return enterInsertion(insertion.now ? Phase::filled : Phase::cavity);
  entering_ = {Entering::Step::after, Phase::filled, 0, 0};
  run(command::StepBack{Grain::insertion});
}

void App::enterInsertion(Phase phase) {
  entering_ = {Entering::Step::before, phase, 0, shown_->events};
  ui_.insertion = {};
  ui_.insertion.after = shown_->state.tick;
  run(command::Seek{shown_->state.tick - 1});
}

void App::takeApartHere() {
  InsertionUi& insertion = ui_.insertion;
  const Phase phase = entering_.phase;
  const Events events = session_.runEvents();
  const auto from = std::min<std::size_t>(static_cast<std::size_t>(shown_->events), events.size());
  const auto to = std::min<std::size_t>(static_cast<std::size_t>(entering_.events), events.size());
  entering_ = {};
  std::optional<Insertion> apart;
  for (std::size_t k = from; k < to && !apart; ++k) {
    if (inserts(events[k])) apart = takeApart(shown_->state, events[k]);
    // A repair may be two edits: the second one does not start from this state.
    if (events[k].createdCount > 0) break;
  }
  if (!apart) {
    const std::uint64_t after = insertion.after;
    insertion = {};
    run(command::Seek{after});
    ui_.message =
        "This insertion cannot be taken apart: the state before it has no triangulation, or it is the second of two "
        "edits.";
    return;
  }
  const Mesh& mesh = shown_->state.mesh;
  for (int k = 1; k <= kInsertionPhases; ++k)
    insertion.captions[static_cast<std::size_t>(k) - 1] = captionOf(*apart, mesh, static_cast<Phase>(k));
  insertion.now = std::make_shared<const Insertion>(std::move(*apart));
  insertion.phase = phase;
  // Where it would be too small to see, or is out of view, the camera follows.
  const Box extent = extentOf(*insertion.now, mesh);
  constexpr double kLeast = 60.0;  // pixels at 100 %
  const double size = std::max(extent.width(), extent.height());
  if (size * ui_.camera.scale < kLeast * ui_.scale() || !inside(extent, visibleBox(ui_.camera)))
    frameBox(extent, 0.2 * std::min(ui_.camera.width, ui_.camera.height) / ui_.scale());
  if (phase == Phase::filled) run(command::Seek{insertion.after});
}

void App::showPhase(Phase phase) {
  InsertionUi& insertion = ui_.insertion;
  entering_ = {};
  insertion.phase = phase;
  const std::uint64_t tick = phase == Phase::filled ? insertion.after : insertion.after - 1;
  if (shown_->state.tick != tick) run(command::Seek{tick});
}

void App::followInsertion() {
  if (shown_ == nullptr || session_.busy() || session_.stale()) return;
  InsertionUi& insertion = ui_.insertion;
  switch (entering_.step) {
    case Entering::Step::after: {
      const bool inserted = shown_->state.tick > 0 && shown_->state.mesh.points.size() > entering_.vertices;
      if (inserted) return enterInsertion(entering_.phase);
      entering_ = {};
      insertion = {};
      ui_.message = "No further point is inserted.";
      return;
    }
    case Entering::Step::before:
      return takeApartHere();
    case Entering::Step::none: {
      const std::uint64_t tick = insertion.phase == Phase::filled ? insertion.after : insertion.after - 1;
      if (insertion.now && shown_->state.tick != tick) insertion = {};  // it was left
      return;
    }
  }
}

}  // namespace triscope
