// What the commands of a session do.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/counted.h"
#include "core/domain/read.h"
#include "core/explain/bound_text.h"
#include "core/run/travel.h"
#include "core/session/session_steps.h"
#include "core/study/compare.h"

namespace triscope {
namespace {

constexpr auto kDerivingNews = std::chrono::milliseconds(250);
constexpr auto kSearchNews = std::chrono::milliseconds(100);  // how often a search tells how far it is …
constexpr std::uint64_t kLooksPerNews = 64;                   // … where it looks at the clock after so many decisions

/// ": aspect ratio 15, not < 4.31, at (1, 2)" of the first bound that the mesh does not meet once the rounds are over.
std::string unmetIn(const MeshState& state) {
  if (!isPastRounds(state.stage)) return {};
  const Quality quality = measure(state.mesh);
  for (const WorstMeasure& worst : worstOf(quality))
    if (!worst.met()) return ": " + unmetText(state.mesh, quality, worst);
  return {};
}

/// For a search through `total` decisions (0: not known how many): tells now and then how far it is, and gives it up
/// when a command waits.
SearchPulse searchPulse(SessionWork& work, std::uint64_t total) {
  return [&work, total, looked = std::uint64_t{0}](const MeshState& probe) mutable {
    if (work.interrupted()) return false;
    if (++looked % kLooksPerNews == 0 && SessionWork::Clock::now() - work.lastTold >= kSearchNews)
      tellSearch(work, probe,
                 total == 0 ? std::nullopt : std::optional(static_cast<double>(looked) / static_cast<double>(total)));
    return true;
  };
}

void beginSearch(SessionWork& work) {
  if (isUnderWay(work)) tellState(work);
  setOut(work, {}, Activity::searching);
}

/// Where the run is, after a search that led nowhere.
void rest(SessionWork& work, std::string notice) {
  work.notice = std::move(notice);
  work.activity = Activity::idle;
  tellProgress(work);
}

bool opens(const Command& order) {
  return std::holds_alternative<command::OpenFile>(order) || std::holds_alternative<command::OpenDomain>(order) ||
         std::holds_alternative<command::Load>(order);
}

/// Whether a command takes the place of a run that is being begun; the others are for what comes of it.
bool supersedes(const SessionWork& work, const Command& order, bool opening) {
  if (std::holds_alternative<command::SetBreakpoints>(order)) return false;
  if (std::holds_alternative<command::Pause>(order)) return false;
  if (std::holds_alternative<command::Change>(order)) return !opening;
  // A step is of the run from before, or of the one to come where there is none.
  return hasBegun(work.driver.run) || opens(order) || std::holds_alternative<command::Cancel>(order);
}

/// Puts a run at its start in the place of the one at hand. False when there can be none: the error says why.
bool startOver(SessionWork& work, std::shared_ptr<const Domain> domain, const Settings& settings) {
  MeshState probe;  // what is shown of the run while it has no state yet
  probe.settings = settings;
  probe.domain = domain;
  const Activity before = std::exchange(work.activity, Activity::meshing);
  work.goalSince = SessionWork::Clock::now();
  work.beginning = true;
  tellSearch(work, probe, 0.0);
  const bool opening = domain != work.driver.run.state.domain;
  const CommandTest test = [&](const Command& order) { return supersedes(work, order, opening); };
  Result<MeshState> begun = begin(std::move(domain), settings, [&](double fraction) {
    if (work.interrupted() && work.waits(test)) return false;
    if (SessionWork::Clock::now() - work.lastTold >= kDerivingNews) tellSearch(work, probe, fraction);
    return true;
  });
  work.beginning = false;
  work.activity = before;
  if (begun) {
    replaceRun(work, runFrom(std::move(*begun)));
    return true;
  }
  if (work.before) cancel(work);
  if (begun.error().kind == ErrorKind::cancelled)
    tellProgress(work);
  else
    fail(work, begun.error());
  return false;
}

void open(SessionWork& work, std::shared_ptr<const Domain> domain) {
  const std::shared_ptr<const Domain> old = work.driver.run.state.domain;
  Settings settings = work.driver.run.state.settings;
  settings.minEdge = 0.0;  // Δx belongs to the domain; everything else is the user's
  const bool another = old && (old->file.empty() || old->file != domain->file);
  if (!startOver(work, std::move(domain), settings)) return;
  const std::string kept = differencesText(differences(Settings{}, settings), &SettingDifference::b);
  if (another && !kept.empty())
    work.notice = fmt::format("Kept from the domain before: {}. Params sets it back.", kept);
  setOut(work, {.kind = Goal::Kind::end}, Activity::meshing);
}

// Where a run with other settings is to be looked at: its end, the beginning of the stage that this one is at or on its
// way to, or after as many decisions.
Goal sameWhere(const Run& run, const Goal& goal) {
  const MeshState& state = run.state;
  const auto entry = [](Stage stage) { return Goal{.kind = Goal::Kind::entry, .tick = kUnknown, .stage = stage}; };
  const bool isHeaded = !arrived(run, goal);
  if (isHeaded && goal.kind == Goal::Kind::entry && !inRounds(goal.stage)) return entry(goal.stage);
  if (isHeaded && goal.kind == Goal::Kind::entry && goal.tick != kUnknown)
    return {.kind = Goal::Kind::tick, .tick = goal.tick};
  if (isHeaded && goal.kind == Goal::Kind::tick) return goal;
  if (isOver(run) || goal.kind == Goal::Kind::end) return {.kind = Goal::Kind::end};
  if (!state.cursor.begun && state.tick > 0 && !inRounds(state.stage)) return entry(state.stage);
  return {.kind = Goal::Kind::tick, .tick = state.tick};
}

void change(SessionWork& work, const Settings& settings) {
  Run& run = work.driver.run;
  if (!hasBegun(run)) {
    run.state.settings = settings;  // for the domain to come
    return tellProgress(work);
  }
  const Stage first = firstAffected(run.state.settings, settings);
  // What the first stage needs (Δx, the root of the quadtree) is worked out before it begins.
  const bool derives = first == Stage::constraints;
  if (first == Stage::finished) {
    run.state.settings = settings;
  } else if (!derives && !hasComeTo(run.state, first)) {
    takeOver(run, settings);
    // A run with these may come to where it is headed after another number of decisions.
    if (Goal& goal = work.driver.goal; goal.kind == Goal::Kind::entry && !inRounds(goal.stage)) goal.tick = kUnknown;
    dropEventsAfter(work);
  } else {
    const Run& shown = work.before ? work.before->run : run;
    const Goal where = sameWhere(shown, work.driver.goal);
    if (derives) {
      if (!startOver(work, run.state.domain, settings)) return;
    } else {
      replaceRun(work, branchOf(run, settings));
    }
    return setOut(work, where, Activity::meshing);
  }
  if (!work.before && !isUnderWay(work)) tellState(work);
}

void setBreakpoints(SessionWork& work, std::vector<Breakpoint> list) {
  Run& run = work.driver.run;
  work.driver.breakpoints = std::move(list);
  std::erase_if(run.hits, [&](const PassedHit& hit) {
    return std::none_of(work.driver.breakpoints.begin(), work.driver.breakpoints.end(),
                        [&hit](const Breakpoint& b) { return b.condition.text() == hit.condition; });
  });
  work.hitsChanged = true;
  headFor(work.driver, Goal(work.driver.goal));  // what is watched for has changed
  if (hasBegun(run) && !work.before && !isUnderWay(work)) tellState(work);
}

void goBackToBreakpoint(SessionWork& work) {
  beginSearch(work);
  Driver& driver = work.driver;
  const std::uint64_t now = driver.run.state.tick;
  const std::optional<Hit> hit = continueBackward(driver.run.history, now, driver.breakpoints, searchPulse(work, now));
  if (!hit)
    return rest(work, work.interrupted() ? "The search was stopped." : "No breakpoint stops before this decision.");
  const Breakpoint& met = driver.breakpoints[hit->breakpoint];
  work.notice = fmt::format("Stopped at decision {}: {}", grouped(hit->tick), met.condition.text());
  if (keepHit(driver.run, *hit, met)) work.hitsChanged = true;
  setOut(work, towardsTick(driver.run, hit->tick), Activity::stepping);
}

void goOn(SessionWork& work, bool backwards) {
  if (backwards) return goBackToBreakpoint(work);
  Driver& driver = work.driver;
  const bool any =
      std::any_of(driver.breakpoints.begin(), driver.breakpoints.end(), [](const Breakpoint& b) { return b.enabled; });
  setOut(work, {.kind = any ? Goal::Kind::breakpoint : Goal::Kind::end}, Activity::stepping);
  work.heldFromStart.clear();
  if (driver.watch && driver.watch->heldFromStart())
    work.heldFromStart = driver.breakpoints[*driver.watch->heldFromStart()].condition.text();
}

void findViolation(SessionWork& work) {
  beginSearch(work);
  Run& run = work.driver.run;
  const std::vector<Breakpoint> rules = violationBreakpoints();
  MeshState probe = run.history.stateBefore(0);
  std::vector<Hit> passed;
  const RunRecord& record = run.recorder.record();
  const std::optional<Hit> hit =
      continueForward(probe, rules, passed, searchPulse(work, record.complete ? record.ticks : 0));
  if (!hit)
    return rest(work, work.interrupted() ? "The search was stopped."
                                         : "No rule is broken in the whole run, and no bound once steps 1–5 are over.");
  work.notice =
      fmt::format("Decision {}: {}{}.", grouped(hit->tick), violationRules()[hit->breakpoint].words, unmetIn(probe));
  if (keepHit(run, *hit, rules[hit->breakpoint])) work.hitsChanged = true;
  setOut(work, towardsTick(run, hit->tick), Activity::stepping);
}

/// What a command asks of a run that has begun. One that is being made anew is given up for the one that is shown.
struct Going {
  SessionWork& work;
  void step(const Goal& goal) const { setOut(work, goal, Activity::stepping); }
  [[nodiscard]] Run& run() const { return work.driver.run; }
  void operator()(const command::Advance& c) const { step(forward(run(), c.grain)); }
  void operator()(const command::Seek& c) const { step(towardsTick(run(), c.tick)); }
  void operator()(const command::StepBack& c) const { step(back(run(), c.grain)); }
  void operator()(const command::SeekEvent& c) const { step(towardsEvent(run(), c.index)); }
  void operator()(const command::GoTo& c) const { step(towardsStage(run(), c.stage)); }
  void operator()(const command::Restart&) const { step(towardsTick(run(), 0)); }
  void operator()(const command::Continue& c) const { goOn(work, c.backwards); }
  void operator()(const command::FindViolation&) const { findViolation(work); }
};

struct Obeying {
  SessionWork& work;
  void operator()(const command::OpenFile& c) const {
    Result<Domain> domain = readDomain(c.path);
    if (domain)
      open(work, std::make_shared<const Domain>(std::move(*domain)));
    else
      fail(work, domain.error());
  }
  void operator()(const command::OpenDomain& c) const { open(work, c.domain); }
  void operator()(const command::Load& c) const {
    if (!startOver(work, c.domain, c.settings)) return;
    setOut(work, {.kind = Goal::Kind::end}, Activity::meshing);
    work.then = c.tick;
  }
  void operator()(const command::Change& c) const { change(work, c.settings); }
  void operator()(const command::SetBreakpoints& c) const { setBreakpoints(work, c.list); }
  void operator()(const command::Play& c) const {
    if (!hasBegun(work.driver.run)) return tellProgress(work);
    setOut(work, {.kind = Goal::Kind::end}, Activity::playing);
    work.pace = SessionWork::Pace{.perSecond = std::max(c.decisionsPerSecond, 0.01)};
  }
  void operator()(const command::Pause&) const { hasBegun(work.driver.run) ? halt(work) : tellProgress(work); }
  void operator()(const command::Cancel&) const { hasBegun(work.driver.run) ? cancel(work) : tellProgress(work); }
  template <class Command>
  void operator()(const Command& c) const {
    if (!hasBegun(work.driver.run)) return tellProgress(work);  // nothing to work on yet
    if (work.before) cancel(work);
    Going{work}(c);
  }
};

}  // namespace

void obey(SessionWork& work, const Command& order) {
  ++work.ordersDone;
  work.error.reset();
  // What was given up is still to be told.
  if (!std::holds_alternative<command::SetBreakpoints>(order) && !std::holds_alternative<command::Cancel>(order))
    work.notice.clear();
  survive(work, [&] { std::visit(Obeying{work}, order); });
}

}  // namespace triscope
