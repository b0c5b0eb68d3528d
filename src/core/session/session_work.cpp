#include "core/session/session_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/counted.h"
#include "core/base/free_memory.h"
#include "core/run/travel.h"
#include "core/session/session_steps.h"

namespace triscope {
namespace {

using std::chrono::milliseconds;

constexpr auto kSlice = milliseconds(5);       // a slice is not interrupted: this bounds how late a cancel is
constexpr auto kFrame = milliseconds(33);      // playing: no use in publishing more often than it is drawn
constexpr auto kLongStep = milliseconds(250);  // stepping: how often a long step shows how far it is
constexpr std::uint64_t kUntilEnough = ~std::uint64_t{0};

/// Decisions that are due, by the time since the last slice.
std::uint64_t earned(SessionWork& work, SessionWork::Clock::time_point now) {
  SessionWork::Pace& pace = *work.pace;
  pace.owed += pace.perSecond * std::chrono::duration<double>(now - work.lastSlice).count();
  const std::uint64_t due = std::min(work.chunk, static_cast<std::uint64_t>(pace.owed));
  pace.owed = std::min(pace.owed - static_cast<double>(due), static_cast<double>(work.chunk));  // debt is not hoarded
  return due;
}

void standStill(SessionWork& work) {
  headFor(work.driver, {});
  work.pace.reset();
  work.then.reset();
  work.activity = Activity::idle;
}

std::string noticeOf(const SessionWork& work) {
  if (work.driver.stopped) {
    const Breakpoint& met = work.driver.breakpoints[work.driver.stopped->breakpoint];
    return fmt::format("Stopped at decision {}: {}", grouped(work.driver.stopped->tick), met.condition.text());
  }
  std::string text = "No breakpoint stopped the run before its end.";
  if (!work.heldFromStart.empty())
    text += fmt::format(" Where it began, {} held already: that is met when it next becomes true.", work.heldFromStart);
  return text;
}

void slice(SessionWork& work) {
  const auto start = SessionWork::Clock::now();
  const bool watching = work.driver.watch.has_value();
  const std::uint64_t beats = watching ? kUntilEnough : work.pace ? earned(work, start) : work.chunk;
  work.lastSlice = start;
  // A piece of the work for a decision may take longer than the decisions that the slice was measured by.
  const auto enough = [&] { return work.interrupted() || SessionWork::Clock::now() - start > kSlice; };
  const std::size_t hits = work.driver.run.hits.size();
  const std::uint64_t known = work.driver.run.known;
  carryOn(work.driver, beats, enough, work.fresh);
  if (work.driver.run.hits.size() != hits) work.hitsChanged = true;
  if (work.driver.run.known != known) work.recordChanged = true;
  work.fresh.resize(std::min(work.fresh.size(), kMostEvents - std::min<std::size_t>(kMostEvents, work.kept)));
  const auto now = SessionWork::Clock::now();
  if (beats == work.chunk && !isThere(work.driver)) {
    if (now - start < kSlice / 2) work.chunk = std::min<std::uint64_t>(work.chunk * 2, 1u << 20u);
    if (now - start > kSlice) work.chunk = std::max<std::uint64_t>(work.chunk / 2, 1);
  }
  if (isThere(work.driver)) {
    if (watching) work.notice = noticeOf(work);
    const std::optional<std::uint64_t> then = std::exchange(work.then, std::nullopt);
    halt(work);
    if (then) setOut(work, towardsTick(work.driver.run, *then), Activity::stepping);
    return;
  }
  const auto patience = work.pace ? kFrame : kLongStep;
  if (now - work.lastTold < std::max<SessionWork::Clock::duration>(patience, 4 * work.tellingCost)) return;
  // On the way to a known place what lies between is of no interest, and to draw it would take from the time.
  const Goal::Kind kind = work.driver.goal.kind;
  const bool passingBy = kind == Goal::Kind::tick || kind == Goal::Kind::entry;
  if (work.before || (passingBy && !work.pace))
    tellProgress(work);
  else
    tellState(work);
}

}  // namespace

void giveUp(SessionWork& work) {
  work.beginning = false;
  if (work.before) {
    cancel(work);
  } else if (hasBegun(work.driver.run)) {
    // The decision that was being made may have been left half done: nothing can be kept but the beginning.
    MeshState start = work.driver.run.history.stateBefore(0);
    work.driver.run = {};  // gives back the room that it took
    work.driver.run = runFrom(std::move(start));
    dropEventsAfter(work);
    halt(work);
  }
  fail(work, notEnoughMemory());
}

bool isUnderWay(const SessionWork& work) { return work.driver.goal.kind != Goal::Kind::none; }

SessionWork::Clock::duration untilDue(const SessionWork& work) {
  if (!work.pace || work.pace->owed >= 1.0) return {};
  const double seconds = std::clamp((1.0 - work.pace->owed) / work.pace->perSecond, 0.001, 0.1);
  return std::chrono::duration_cast<SessionWork::Clock::duration>(std::chrono::duration<double>(seconds));
}

void carrySlice(SessionWork& work) {
  survive(work, [&] { slice(work); });
}

void carryTrace(SessionWork& work) {
  survive(work, [&] { traceOn(work); });
}

void rest(const SessionWork& work) {
  constexpr std::size_t kLarge = 200'000;  // triangles, which leave some hundred bytes each behind in the heap
  if (work.driver.run.state.mesh.liveCount() >= kLarge) giveBackFreeMemory();
}

void setOut(SessionWork& work, const Goal& goal, Activity activity) {
  headFor(work.driver, goal);
  work.activity = activity;
  work.pace.reset();
  work.then.reset();
  work.goalSince = work.lastSlice = SessionWork::Clock::now();
  tellProgress(work);
}

void halt(SessionWork& work) {
  standStill(work);
  work.before.reset();
  tellState(work);
}

void cancel(SessionWork& work) {
  if (!work.before) return halt(work);
  work.driver.run = std::move(work.before->run);
  work.kept = work.before->kept;
  work.before.reset();
  work.fresh.clear();
  standStill(work);
  tellProgress(work);
}

void replaceRun(SessionWork& work, Run run) {
  if (!work.before && hasBegun(work.driver.run)) {
    if (isUnderWay(work) || !work.fresh.empty()) tellState(work);
    work.before = SessionWork::SetAside{std::move(work.driver.run), work.kept};
  }
  work.driver.run = std::move(run);
  dropEventsAfter(work);
}

void dropEventsAfter(SessionWork& work) {
  const std::uint64_t known = work.driver.run.known;
  work.kept = std::min(work.kept, known);
  work.fresh.resize(std::min<std::size_t>(work.fresh.size(), static_cast<std::size_t>(known - work.kept)));
  work.recordChanged = work.hitsChanged = true;
}

}  // namespace triscope
