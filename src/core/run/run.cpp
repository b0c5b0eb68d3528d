#include "core/run/run.h"

#include <algorithm>
#include <utility>

namespace triscope {
namespace {

constexpr std::size_t kCheckpointBytes = 128u << 20u;
constexpr std::size_t kMostHits = 10'000;

void rememberStage(Run& run) {
  if (run.state.stage == Stage::finished) return;  // no setting begins to matter there
  for (const Checkpoint& c : run.checkpoints)
    if (c.state->stage == run.state.stage) return;
  const std::size_t bytes = bytesOf(run.state);
  std::size_t total = bytes;
  for (const Checkpoint& c : run.checkpoints) total += c.bytes;
  // The latest saves the most work; the earliest costs nearly nothing.
  while (total > kCheckpointBytes && run.checkpoints.size() > 1) {
    total -= run.checkpoints.back().bytes;
    run.checkpoints.pop_back();
  }
  run.checkpoints.push_back({std::make_shared<const MeshState>(run.state), run.events, run.last, bytes});
}

}  // namespace

double historyBytesAtMost(double triangles) {
  constexpr double kEventBytes = 30.0;         // packed
  constexpr double kEventsPerTriangle = 13.0;  // most are the optimiser's
  const double events = std::min(kEventsPerTriangle * triangles, static_cast<double>(kMostEvents));
  return static_cast<double>(kHistoryBytes + kCheckpointBytes) + kEventBytes * events;
}

Run runFrom(MeshState start, std::size_t budget) {
  Run run;
  run.state = std::move(start);
  run.history = History(budget);
  run.history.restart(run.state);
  rememberStage(run);
  return run;
}

std::size_t keep(Run& run, const Beat& beat, Stage stageBefore) {
  if (!beat.made.empty()) run.last = beat.made.back();
  run.events = beat.events;
  run.recorder.follow(run.state, beat);
  if (run.state.tick != beat.tickBefore) run.history.offer(run.state, run.events);
  if (run.state.stage != stageBefore && !run.state.cursor.begun) rememberStage(run);
  if (run.events <= run.known) return 0;
  return static_cast<std::size_t>(run.events - std::exchange(run.known, run.events));
}

void returnTo(Run& run, const Keyframe& keyframe) {
  const Settings settings = run.state.settings;
  run.state = keyframe.state;
  run.state.settings = settings;
  run.events = keyframe.events;
  run.last.reset();
}

void forgetWhatFollows(Run& run) {
  const std::uint64_t tick = run.state.tick;
  run.known = run.events;
  run.history.forgetAfter(tick);
  run.recorder.forgetAfter(tick, run.events);
  run.trace.forgetAfter(tick);
  std::erase_if(run.hits, [tick](const PassedHit& hit) { return hit.tick > tick; });
}

void takeOver(Run& run, const Settings& settings) {
  const Stage first = firstAffected(run.state.settings, settings);
  run.state.settings = settings;
  run.history.changeSettings(settings);
  // By stage: one that makes no decision ends at the tick that it began at.
  std::erase_if(run.checkpoints, [first](const Checkpoint& c) { return hasComeTo(*c.state, first); });
  forgetWhatFollows(run);
}

Run branchOf(const Run& run, const Settings& settings) {
  const Stage first = firstAffected(run.state.settings, settings);
  const auto last = std::find_if(run.checkpoints.rbegin(), run.checkpoints.rend(),
                                 [first](const Checkpoint& c) { return !hasComeTo(*c.state, first); });
  const Checkpoint& from = last == run.checkpoints.rend() ? run.checkpoints.front() : *last;
  Run branch;
  branch.state = *from.state;
  branch.state.settings = run.state.settings;
  branch.events = from.events;
  branch.last = from.last;
  branch.history = run.history;
  branch.recorder = run.recorder;
  branch.trace = run.trace.upTo(branch.state.tick);
  branch.checkpoints = run.checkpoints;
  branch.hits = run.hits;
  takeOver(branch, settings);
  return branch;
}

bool keepHit(Run& run, const Hit& hit, const Breakpoint& met) {
  std::vector<PassedHit>& hits = run.hits;
  if (hits.size() >= kMostHits) return false;
  const std::string& condition = met.condition.text();
  const auto after = std::upper_bound(hits.begin(), hits.end(), hit.tick,
                                      [](std::uint64_t tick, const PassedHit& h) { return tick < h.tick; });
  for (auto same = after; same != hits.begin() && (same - 1)->tick == hit.tick; --same)
    if ((same - 1)->condition == condition) return false;
  hits.insert(after, {hit.tick, condition, met.action, hit.event});
  return true;
}

}  // namespace triscope
