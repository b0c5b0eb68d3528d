#include "core/run/driver.h"

#include <iterator>

namespace triscope {
namespace {

/// What a beat began from.
struct Before {
  explicit Before(const MeshState& state) : stage(state.stage), tick(state.tick), points(state.mesh.points.size()) {}
  Stage stage;
  std::uint64_t tick;
  std::size_t points;
};

void take(Run& run, const Before& before, std::span<const Event> made, std::vector<Event>& fresh) {
  const Beat beat{before.tick, before.points, made, run.events + made.size()};
  const std::size_t unknown = keep(run, beat, before.stage);
  fresh.insert(fresh.end(), made.end() - static_cast<std::ptrdiff_t>(unknown), made.end());
}

void takeHits(Driver& driver, std::span<const Hit> hits) {
  for (const Hit& hit : hits) {
    const Breakpoint& met = driver.breakpoints[hit.breakpoint];
    if (met.action == Breakpoint::Action::stop && !driver.stopped) driver.stopped = hit;
    keepHit(driver.run, hit, met);
  }
}

}  // namespace

void headFor(Driver& driver, const Goal& goal) {
  driver.goal = goal;
  driver.stopped.reset();
  driver.watch.reset();
  if (goal.kind == Goal::Kind::breakpoint)
    driver.watch.emplace(driver.run.state, driver.run.events, driver.breakpoints);
}

bool isThere(const Driver& driver) { return isOver(driver.run) || driver.stopped || arrived(driver.run, driver.goal); }

void carryOn(Driver& driver, std::uint64_t beats, const std::function<bool()>& enough, std::vector<Event>& fresh) {
  Run& run = driver.run;
  std::vector<Event> made;
  std::vector<Hit> hits;
  Journal journal{&made};
  for (; beats > 0 && !isThere(driver); --beats) {
    const Before before(run.state);
    bool mayBeLong = true;
    if (driver.watch) {
      const bool more = driver.watch->step(run.state, driver.breakpoints, hits);
      take(run, before, driver.watch->events(), fresh);
      takeHits(driver, hits);
      hits.clear();
      if (!more) return;
    } else {
      made.clear();
      advanceUntil(run.state, before.stage, 1, journal);
      take(run, before, made, fresh);
      mayBeLong =
          run.state.tick == before.tick && run.state.stage == before.stage;  // a piece of the work for a decision
    }
    if (mayBeLong && enough && enough()) return;
  }
}

}  // namespace triscope
