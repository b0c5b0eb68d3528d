#include "ui/app/insertion_walk.h"

#include <algorithm>
#include <utility>

#include "core/geometry/circumcircle.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

using Phase = InsertionPhase;

// What was measured is too small to read below this width, in pixels at 100 % …
constexpr double kLeast = 120.0;
// … and in a small canvas below this part of its smaller side.
constexpr double kLeastShare = 0.33;
// The part of it that it fills once the camera has gone near.
constexpr double kShare = 0.42;

Phase next(Phase phase, int by) { return static_cast<Phase>(static_cast<int>(phase) + by); }

/// The circles about what was measured; empty where nothing was.
Box circlesOf(const Insertion& insertion) {
  Box box;
  if (!insertion.measured) return box;
  const Measured& m = *insertion.measured;
  const double reach = std::max(m.limit, distance(m.from, m.to));
  box.include(m.from - Point{reach, reach});
  box.include(m.from + Point{reach, reach});
  return box;
}

/// What the phases show: candidate, walk, cavity and the circles about the point.
Box extentOf(const Insertion& insertion, const Mesh& mesh) {
  Box box;
  box.include(insertion.at);
  const auto add = [&](Slot slot) {
    for (const Vertex v : triangleAt(mesh, slot).v) box.include(pointOf(mesh, v));
  };
  if (insertion.candidate.exists()) add(insertion.candidate);
  for (const Slot slot : insertion.walk) add(slot);
  for (const Slot slot : insertion.cavity.triangles()) add(slot);
  if (const Box circles = circlesOf(insertion); !circles.empty()) {
    box.include(circles.lo);
    box.include(circles.hi);
  }
  return box;
}

double sizeOf(const Box& box) { return std::max(box.width(), box.height()); }

/// `focus` at its share of the picture, or less where all of `extent` is to be seen with it; never below `least`
/// pixels.
Camera cameraOn(Camera camera, const Box& focus, const Box& extent, double least) {
  const Point middle = midpoint(focus.lo, focus.hi);
  const Point out{std::max(extent.hi.x - middle.x, middle.x - extent.lo.x),
                  std::max(extent.hi.y - middle.y, middle.y - extent.lo.y)};
  const double smaller = std::min(camera.width, camera.height);
  const Camera whole = fitted({middle - out, middle + out}, camera.width, camera.height, 0.06 * smaller);
  camera.centre = middle;
  camera.scale = std::max(std::min(whole.scale, kShare * smaller / sizeOf(focus)), least / sizeOf(focus));
  return camera;
}

}  // namespace

void InsertionWalk::stepInto() {
  if (desk_.ui.insertion.now && desk_.ui.insertion.phase != Phase::filled)
    return showPhase(next(desk_.ui.insertion.phase, 1));
  desk_.ui.message.clear();
  entering_ = {Entering::Step::after, Phase::candidate, desk_.shown->state.mesh.points.size(), 0};
  give(desk_, command::Advance{Grain::insertion});
}

void InsertionWalk::stepBack() {
  const InsertionUi& insertion = desk_.ui.insertion;
  if (insertion.now && insertion.phase != Phase::candidate) return showPhase(next(insertion.phase, -1));
  desk_.ui.message.clear();
  const bool here = desk_.shown->last && inserts(*desk_.shown->last);
  // In the middle of nothing the insertion just made is entered from its end; from the first phase it is the one
  // before.
  if (here) return enter(insertion.now ? Phase::filled : Phase::cavity);
  entering_ = {Entering::Step::after, Phase::filled, 0, 0};
  give(desk_, command::StepBack{Grain::insertion});
}

void InsertionWalk::enter(Phase phase) {
  entering_ = {Entering::Step::before, phase, 0, desk_.shown->events};
  desk_.ui.insertion = {};
  desk_.ui.insertion.after = desk_.shown->state.tick;
  give(desk_, command::Seek{desk_.shown->state.tick - 1});
}

void InsertionWalk::takeApartHere() {
  InsertionUi& insertion = desk_.ui.insertion;
  const Phase phase = entering_.phase;
  const Events events = desk_.session.runEvents();
  const auto from = std::min<std::size_t>(static_cast<std::size_t>(desk_.shown->events), events.size());
  const auto to = std::min<std::size_t>(static_cast<std::size_t>(entering_.events), events.size());
  entering_ = {};
  std::optional<Insertion> apart;
  for (std::size_t k = from; k < to && !apart; ++k) {
    if (inserts(events[k])) apart = takeApart(desk_.shown->state, events[k]);
    // A repair may be two edits: the second one does not start from this state.
    if (events[k].createdCount > 0) break;
  }
  if (!apart) {
    const std::uint64_t after = insertion.after;
    leave();
    give(desk_, command::Seek{after});
    desk_.ui.message =
        "This insertion cannot be taken apart: the state before it has no triangulation, or it is the second of two "
        "edits.";
    return;
  }
  const Mesh& mesh = desk_.shown->state.mesh;
  for (int k = 1; k <= kInsertionPhases; ++k)
    insertion.captions[static_cast<std::size_t>(k) - 1] = captionOf(*apart, mesh, static_cast<Phase>(k));
  insertion.now = std::make_shared<const Insertion>(std::move(*apart));
  insertion.phase = phase;
  goNear(*insertion.now);
  if (phase == Phase::filled) give(desk_, command::Seek{insertion.after});
}

void InsertionWalk::showPhase(Phase phase) {
  InsertionUi& insertion = desk_.ui.insertion;
  entering_ = {};
  insertion.phase = phase;
  const std::uint64_t tick = phase == Phase::filled ? insertion.after : insertion.after - 1;
  if (desk_.shown->state.tick != tick) give(desk_, command::Seek{tick});
}

/// Where it would be too small to read, or is out of view, the camera follows.
void InsertionWalk::goNear(const Insertion& insertion) {
  const Box extent = extentOf(insertion, desk_.shown->state.mesh);
  const Box circles = circlesOf(insertion);
  const Box& focus = circles.empty() ? extent : circles;
  if (sizeOf(focus) <= 0.0) return;
  const double least =
      std::min(kLeast * desk_.ui.scale(), kLeastShare * std::min(desk_.ui.camera.width, desk_.ui.camera.height));
  if (sizeOf(focus) * desk_.ui.camera.scale >= least && shows(desk_.ui.camera, extent)) return;
  const bool moved = !near_ || !near_->isAt(desk_.ui.camera);
  if (moved) near_ = Near{desk_.ui.camera, desk_.ui.fitted, {}};
  desk_.ui.camera = near_->camera = cameraOn(desk_.ui.camera, focus, extent, least);
  desk_.ui.fitted = false;
}

void InsertionWalk::leave() {
  desk_.ui.insertion = {};
  // Unless it has been moved by hand meanwhile, the camera goes back to where it was.
  if (const std::optional<Near> was = std::exchange(near_, std::nullopt); was && was->isAt(desk_.ui.camera)) {
    desk_.ui.camera = resized(was->before, desk_.ui.camera.width, desk_.ui.camera.height);
    desk_.ui.fitted = was->fitted;
  }
}

void InsertionWalk::follow() {
  if (desk_.shown == nullptr || desk_.session.busy() || desk_.session.stale()) return;
  InsertionUi& insertion = desk_.ui.insertion;
  switch (entering_.step) {
    case Entering::Step::after: {
      const bool inserted = desk_.shown->state.tick > 0 && desk_.shown->state.mesh.points.size() > entering_.vertices;
      if (inserted) return enter(entering_.phase);
      entering_ = {};
      leave();
      desk_.ui.message = "No further point is inserted.";
      return;
    }
    case Entering::Step::before:
      return takeApartHere();
    case Entering::Step::none: {
      const std::uint64_t tick = insertion.phase == Phase::filled ? insertion.after : insertion.after - 1;
      if (insertion.now && desk_.shown->state.tick != tick) leave();
      return;
    }
  }
}

void InsertionWalk::forget() {
  desk_.ui.insertion = {};
  near_.reset();
  entering_ = {};
}

}  // namespace triscope
