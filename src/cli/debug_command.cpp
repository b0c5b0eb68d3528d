// triscope debug: the debugger without a window. Goes somewhere in a run, on to a condition, and answers in words.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/answers.h"
#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/progress_line.h"
#include "core/base/output_set.h"
#include "core/run/driver.h"
#include "core/run/travel.h"
#include "core/session/session_file.h"

namespace triscope {
namespace {

Result<std::vector<Breakpoint>> compileAll(const std::vector<std::string>& texts) {
  std::vector<Breakpoint> list;
  for (const std::string& text : texts) {
    Result<Condition> condition = Condition::compile(text);
    if (!condition.ok()) return condition.error();
    list.push_back({std::move(*condition)});
  }
  return list;
}

/// Where to begin. Without --goto: at the start when there is something to run to, else at the end.
Goto placeOf(const DebugCommand& options) {
  if (options.place) return *options.place;
  const bool onwards = !options.breaks.empty() || options.firstViolation;
  return {.kind = onwards && !options.back ? Goto::Kind::start : Goto::Kind::end};
}

/// A run, every event of it as far as it has been carried, and where that is told.
struct Debuggee {
  Driver driver;
  EventLog log;
  ProgressLine progress;
};

Events eventsOf(const Debuggee& at) { return Events(at.log).first(static_cast<std::size_t>(at.driver.run.events)); }

/// False when the run ends before the goal.
bool go(Debuggee& at, const Goal& goal) {
  constexpr std::uint64_t kBeatsPerLook = 1024;  // a few milliseconds
  headFor(at.driver, goal);
  std::vector<Event> fresh;
  while (!isThere(at.driver)) {
    carryOn(at.driver, kBeatsPerLook, {}, fresh);
    at.log.append(fresh);
    fresh.clear();
    at.progress.show(at.driver.run.state);
  }
  return at.driver.stopped || arrived(at.driver.run, goal);
}

Goal goalOf(Run& run, const Goto& place) {
  switch (place.kind) {
    case Goto::Kind::start:
      return {};
    case Goto::Kind::end:
      return {.kind = Goal::Kind::end};
    case Goto::Kind::tick:
      return towardsTick(run, place.number);
    case Goto::Kind::event:
      return towardsEvent(run, place.number);
    case Goto::Kind::stage:
      return towardsStage(run, place.stage);
  }
  return {};
}

/// On, or back, to a decision that meets a breakpoint; where the run is when going back meets none.
std::optional<Hit> goToHit(Debuggee& at, bool backwards) {
  Driver& driver = at.driver;
  if (!backwards) {
    go(at, {.kind = Goal::Kind::breakpoint});
    return driver.stopped;
  }
  const auto pulse = [&at, looked = 0](const MeshState& state) mutable {
    if (++looked % 64 == 0) at.progress.show(state);
    return true;
  };
  const std::optional<Hit> hit = continueBackward(driver.run.history, driver.run.state.tick, driver.breakpoints, pulse);
  if (hit) go(at, towardsTick(driver.run, hit->tick));
  return hit;
}

Error notReached(const Run& run) {
  return Error{.kind = ErrorKind::unmet,
               .message = "the run ends before the place that --goto names",
               .hint = fmt::format("it has {} decisions and {} events", run.state.tick, run.events)};
}

Status saveSession(const DebugCommand& options, const Driver& driver, OutputSet& files) {
  const MeshState& state = driver.run.state;
  Result<MeshState> start = begin(state.domain, options.settings);
  if (!start.ok()) return start.error();
  SessionFile session;
  session.domainFile = options.domain;
  session.domainText = state.domain->text;
  session.settings = options.settings;
  session.tick = state.tick;
  session.breakpoints = driver.breakpoints;
  session.hashes = stageHashes(std::move(*start), session.tick, ~std::size_t{0}, nullptr);
  if (Status written = files.write(options.saveSession, sessionText(session)); !written.ok()) return written;
  return files.commit();
}

}  // namespace

ExitCode runCommand(const DebugCommand& options) {
  Result<std::vector<Breakpoint>> breakpoints = compileAll(options.breaks);
  if (!breakpoints.ok()) {
    Error error = breakpoints.error();
    error.kind = ErrorKind::usage;
    return fail(error);
  }
  if (options.firstViolation) *breakpoints = violationBreakpoints();
  Result<MeshState> start = beginFile(options.domain, options.settings, Notices::none);
  if (!start.ok()) return fail(start.error());

  OutputSet files;
  if (!options.saveSession.empty()) {
    if (const Result<AtomicFile*> file = files.open(options.saveSession); !file.ok()) return fail(file.error());
  }

  Debuggee at{.driver = {}, .log = {}, .progress = ProgressLine(options.notices)};
  Driver& driver = at.driver;
  driver.run = runFrom(std::move(*start));
  driver.breakpoints = std::move(*breakpoints);
  if (!go(at, goalOf(driver.run, placeOf(options)))) return fail(notReached(driver.run));
  const bool onwards = !driver.breakpoints.empty();
  const std::optional<Hit> hit = onwards ? goToHit(at, options.back) : std::nullopt;
  at.progress.clear();
  if (!options.saveSession.empty()) {
    if (const Status saved = saveSession(options, driver, files); !saved.ok()) return fail(saved.error());
  }

  const Stop stop{driver.run, eventsOf(at), hit ? driver.breakpoints.at(hit->breakpoint).condition.text() : "",
                  hit ? std::optional(static_cast<std::size_t>(hit->number)) : std::nullopt};
  const std::string answers = options.json ? answersAsJson(stop, options.prints) : answersAsText(stop, options.prints);
  answerText(answers);

  if (options.firstViolation && !hit && options.notices == Notices::shown)
    say("note: no rule of validity and no bound of the paper is broken up to the end of the run\n");
  if (options.firstViolation) return hit ? ExitCode::unmet : ExitCode::ok;
  if (onwards && !hit) {
    say("triscope: no breakpoint was met {}\n", options.back ? "before that" : "up to the end of the run");
    return ExitCode::unmet;
  }
  return ExitCode::ok;
}

}  // namespace triscope
