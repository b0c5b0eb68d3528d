// What a session tells its viewer.
#include <algorithm>
#include <utility>

#include "core/method/stages/stage_runs.h"
#include "core/session/session_steps.h"

namespace triscope {
namespace {

/// How far the run is up to step 6, from 0 to 1: insertions make up most of it.
double fractionOfSteps(const MeshState& s) {
  constexpr double kSearch = 0.1;  // for constraints: next to nothing for a few curves, most of the time for thousands
  constexpr double kInsertions = 0.85;
  if (s.stage == Stage::constraints && s.domain)
    return s.cursor.begun ? kSearch * fractionOf(s.search, *s.domain) : 0.0;
  if (refinesMesh(s.stage)) {
    const double passes = std::max(1, s.settings.refinePasses);
    return kInsertions + (1.0 - kInsertions) * std::min(1.0, static_cast<double>(s.round) / passes);
  }
  if (s.stage < Stage::front1 || s.estimatedTriangles <= 0.0) return kSearch;
  const double made = std::min(1.0, static_cast<double>(s.mesh.liveCount()) / s.estimatedTriangles);
  return kSearch + (kInsertions - kSearch) * made;
}

/// How far the run is, from 0 to 1. An optimiser takes about as long as all that comes before it.
double fractionDone(const MeshState& s) {
  const double steps = s.settings.optimise ? 0.5 : 1.0;
  if (s.stage == Stage::finished) return 1.0;
  if (!optimisesMesh(s.stage)) return steps * fractionOfSteps(s);
  return steps + (1.0 - steps) * std::min(1.0, static_cast<double>(s.round) / optimiserPasses());
}

/// What follows the last decision, the end of a stage, belongs to it.
std::uint64_t firstEventHere(const Run& run) {
  std::uint64_t first = run.events;
  for (; first > 0; --first) {
    const std::optional<std::uint64_t> tick = run.recorder.tickOfEvent(first - 1);
    if (tick && *tick < run.state.tick) break;
  }
  return first;
}

Progress progressAt(const SessionWork& work, const MeshState& state) {
  return {.activity = work.activity,
          .stage = state.stage,
          .tick = state.tick,
          .triangles = state.mesh.liveCount(),
          .estimated = state.estimatedTriangles,
          .fraction = fractionDone(state),
          .seconds = std::chrono::duration<double>(SessionWork::Clock::now() - work.goalSince).count()};
}

std::shared_ptr<const MeshState> beforeRefinement(const Run& run) {
  for (const Checkpoint& c : run.checkpoints)
    if (c.state->stage == Stage::refine) return c.state;
  return nullptr;
}

Publication news(const SessionWork& work) {
  Publication news;
  const Run& run = work.driver.run;
  news.progress = progressAt(work, run.state);
  news.settings = run.state.settings;
  news.domain = run.state.domain;
  news.beforeRefinement = beforeRefinement(run);
  news.ordersDone = work.ordersDone;
  news.error = work.error;
  news.failures = work.failures;
  news.notice = work.notice;
  news.stale = work.before.has_value() || (work.beginning && hasBegun(run));
  return news;
}

void deliver(SessionWork& work, Publication publication) {
  work.tell(std::move(publication));
  work.lastTold = SessionWork::Clock::now();
}

std::shared_ptr<const RunRecord> recordOf(const Run& run) {
  auto record = std::make_shared<RunRecord>(run.recorder.record());
  record->samples = run.trace.samples();
  return record;
}

}  // namespace

void tellProgress(SessionWork& work) { deliver(work, news(work)); }

void tellSearch(SessionWork& work, const MeshState& probe, std::optional<double> fraction) {
  Publication publication = news(work);
  publication.progress = progressAt(work, probe);
  if (fraction) publication.progress.fraction = *fraction;
  publication.settings = probe.settings;
  publication.domain = probe.domain;
  deliver(work, std::move(publication));
}

void tellState(SessionWork& work) {
  const auto start = SessionWork::Clock::now();
  const Run& run = work.driver.run;
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->revision = ++work.revision;
  snapshot->state = run.state;
  work.measured = work.told ? measureInParts(run.state.mesh, work.told->state.mesh, std::move(work.measured))
                            : measureInParts(run.state.mesh);
  snapshot->quality = work.measured.quality;
  snapshot->last = run.last;
  snapshot->events = run.events;
  snapshot->firstEvent = firstEventHere(run);
  Publication publication = news(work);
  work.told = snapshot;
  publication.snapshot = std::move(snapshot);
  if (std::exchange(work.recordChanged, false)) publication.record = recordOf(run);
  if (std::exchange(work.hitsChanged, false))
    publication.hits = std::make_shared<const std::vector<PassedHit>>(run.hits);
  publication.keepEvents = work.kept;
  work.kept += work.fresh.size();
  publication.freshEvents = std::exchange(work.fresh, {});
  deliver(work, std::move(publication));
  work.tellingCost = work.lastTold - start;
}

void traceOn(SessionWork& work) {
  constexpr auto kPatience = std::chrono::milliseconds(5);
  constexpr auto kBetweenNews = std::chrono::milliseconds(250);
  Run& run = work.driver.run;
  const auto start = SessionWork::Clock::now();
  const auto enough = [=] { return SessionWork::Clock::now() - start > kPatience; };
  const bool more = run.trace.carryOn(run.history, run.recorder.record(), enough);
  const auto now = SessionWork::Clock::now();
  if (more && now - work.lastTrace < kBetweenNews) return;
  work.lastTrace = now;
  Publication publication = news(work);
  publication.record = recordOf(run);
  work.tell(std::move(publication));
}

bool traceLags(const SessionWork& work) {
  const Run& run = work.driver.run;
  const std::vector<QualitySample>& samples = run.trace.samples();
  return hasBegun(run) && (samples.empty() ? 0 : samples.back().tick) < run.recorder.record().ticks;
}

void fail(SessionWork& work, Error error) {
  work.error = std::move(error);
  ++work.failures;
  tellProgress(work);
}

}  // namespace triscope
