// triscope debug: the debugger without a window. Goes somewhere in a run, on to a condition, and answers in words.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/answers.h"
#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/progress_line.h"
#include "core/debug/recording.h"
#include "core/io/output_set.h"
#include "core/session_file.h"

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

bool go(Recording& recording, const Goto& place) {
  switch (place.kind) {
    case Goto::Kind::start:
      return true;
    case Goto::Kind::end:
      return recording.toEnd();
    case Goto::Kind::tick:
      return recording.toTick(place.number);
    case Goto::Kind::event:
      return recording.toEvent(static_cast<std::size_t>(place.number));
    case Goto::Kind::stage:
      return recording.toStage(place.stage);
  }
  return false;
}

Error notReached(const Recording& recording) {
  return Error{
      .code = ExitCode::unmet,
      .message = "the run ends before the place that --goto names",
      .hint = fmt::format("it has {} decisions and {} events", recording.state().tick, recording.events().size())};
}

Status saveSession(const DebugCommand& options, const Recording& recording, std::vector<Breakpoint> breakpoints,
                   OutputSet& files) {
  Result<MeshState> start = begin(recording.state().domain, options.settings);
  if (!start.ok()) return start.error();
  SessionFile session;
  session.domainFile = options.domain;
  session.domainText = recording.state().domain->text;
  session.settings = options.settings;
  session.tick = recording.state().tick;
  session.breakpoints = std::move(breakpoints);
  session.hashes = stageHashes(std::move(*start), session.tick, ~std::size_t{0}, nullptr);
  if (Status written = files.write(options.saveSession, sessionText(session)); !written.ok()) return written;
  return files.commit();
}

}  // namespace

ExitCode runCommand(const DebugCommand& options) {
  Result<std::vector<Breakpoint>> breakpoints = compileAll(options.breaks);
  if (!breakpoints.ok()) {
    Error error = breakpoints.error();
    error.code = ExitCode::usage;
    return fail(error);
  }
  if (options.firstViolation) *breakpoints = violationBreakpoints();
  Result<MeshState> start = beginFile(options.domain, options.settings, true);
  if (!start.ok()) return fail(start.error());

  OutputSet files;
  if (!options.saveSession.empty()) {
    if (const Result<AtomicFile*> file = files.open(options.saveSession); !file.ok()) return fail(file.error());
  }

  Recording recording(std::move(*start));
  ProgressLine progress(!options.quiet);
  recording.onPulse([&](const MeshState& state) {
    progress.show(state);
    return true;
  });
  const bool reached = go(recording, placeOf(options));
  if (!reached) return fail(notReached(recording));

  std::optional<Hit> hit;
  if (!breakpoints->empty()) {
    std::vector<Hit> passed;
    hit = options.back ? recording.toPreviousHit(*breakpoints) : recording.toNextHit(*breakpoints, passed);
  }
  progress.clear();
  if (!options.saveSession.empty()) {
    if (const Status saved = saveSession(options, recording, *breakpoints, files); !saved.ok())
      return fail(saved.error());
  }

  const Stop stop{recording, hit ? breakpoints->at(hit->breakpoint).condition.text() : "",
                  hit ? std::optional<std::size_t>(recording.eventOf(*hit)) : std::nullopt};
  const std::string answers = options.json ? answersAsJson(stop, options.prints) : answersAsText(stop, options.prints);
  std::fwrite(answers.data(), 1, answers.size(), stdout);

  if (options.firstViolation && !hit && !options.quiet)
    fmt::print(stderr, "note: no rule of validity and no bound of the paper is broken up to the end of the run\n");
  if (options.firstViolation) return hit ? ExitCode::unmet : ExitCode::ok;
  if (!breakpoints->empty() && !hit) {
    fmt::print(stderr, "triscope: no breakpoint was met {}\n",
               options.back ? "before that" : "up to the end of the run");
    return ExitCode::unmet;
  }
  return ExitCode::ok;
}

}  // namespace triscope
