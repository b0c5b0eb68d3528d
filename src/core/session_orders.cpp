// What the commands of a session do.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/counted.h"
#include "core/debug/bound_text.h"
#include "core/debug/compare.h"
#include "core/domain/read.h"
#include "core/session_worker.h"

namespace triscope {
namespace {

constexpr auto kSearchNews = std::chrono::milliseconds(100);  // how often a search tells how far it is …
constexpr std::uint64_t kLooksPerNews = 64;                   // … where it looks at the clock after so many decisions

/// ": aspect ratio 15, not < 4.31, at (1, 2)" of the first bound that the mesh does not meet once the rounds are over.
std::string unmetIn(const MeshState& state) {
  if (state.stage < Stage::refine) return {};
  const Quality quality = measure(state.mesh);
  for (const WorstMeasure& worst : worstOf(quality))
    if (!worst.met()) return ": " + unmetText(state.mesh, quality, worst);
  return {};
}

bool opens(const Command& order) {
  return std::holds_alternative<command::OpenFile>(order) || std::holds_alternative<command::OpenDomain>(order) ||
         std::holds_alternative<command::Load>(order);
}

}  // namespace

void SessionWorker::carryOut(const Command& order) {
  ++ordersDone_;
  error_.reset();
  // What was given up is still to be told.
  if (!std::holds_alternative<command::SetBreakpoints>(order) && !std::holds_alternative<command::Cancel>(order))
    notice_.clear();
  struct Visitor {
    SessionWorker& w;
    void operator()(const command::OpenFile& c) const {
      Result<Domain> domain = readDomain(c.path);
      if (domain)
        w.open(std::make_shared<const Domain>(std::move(*domain)));
      else
        w.fail(domain.error());
    }
    void operator()(const command::OpenDomain& c) const { w.open(c.domain); }
    void operator()(const command::Load& c) const { w.load(c); }
    void operator()(const command::Change& c) const { w.change(c.settings); }
    void operator()(const command::Advance& c) const { w.headFor(c.grain); }
    void operator()(const command::Seek& c) const { w.seek(c.tick); }
    void operator()(const command::StepBack& c) const { w.stepBack(c.grain); }
    void operator()(const command::SeekEvent& c) const { w.seekEvent(c.index); }
    void operator()(const command::SetBreakpoints& c) const { w.setBreakpoints(c.list); }
    void operator()(const command::Continue& c) const { w.goOn(c.backwards); }
    void operator()(const command::FindViolation&) const { w.findViolation(); }
    void operator()(const command::GoTo& c) const { w.goTo(c.stage); }
    void operator()(const command::Restart&) const { w.seek(0); }
    void operator()(const command::Play& c) const {
      w.head({.kind = Goal::Kind::play, .rate = std::max(c.decisionsPerSecond, 0.01)}, Activity::playing);
    }
    void operator()(const command::Pause&) const { w.halt(); }
    void operator()(const command::Cancel&) const { w.cancel(); }
  };
  const bool always = opens(order) || std::holds_alternative<command::SetBreakpoints>(order) ||
                      std::holds_alternative<command::Change>(order);
  if (!loaded_ && !always)
    publishProgress();  // nothing to work on yet
  else
    std::visit(Visitor{*this}, order);
}

void SessionWorker::open(std::shared_ptr<const Domain> domain) {
  keepBackup();
  Settings settings = state_.settings;
  settings.minEdge = 0.0;  // Δx belongs to the domain; everything else is the user's
  const bool another = state_.domain && (state_.domain->file.empty() || state_.domain->file != domain->file);
  if (!startOver(std::move(domain), settings)) return;
  const std::string kept = differencesText(differences(Settings{}, settings), &SettingDifference::b);
  if (another && !kept.empty()) notice_ = fmt::format("Kept from the domain before: {}. Params sets it back.", kept);
  head({.kind = Goal::Kind::end}, Activity::meshing);
}

bool SessionWorker::supersedes(bool opening) {
  const auto supersede = [&](const Command& order) {
    if (std::holds_alternative<command::SetBreakpoints>(order)) return false;
    if (std::holds_alternative<command::Pause>(order)) return false;
    if (std::holds_alternative<command::Change>(order)) return !opening;
    // A step is of the run from before, or of the one to come where there is none.
    return loaded_ || opens(order) || std::holds_alternative<command::Cancel>(order);
  };
  const std::lock_guard lock(mutex_);
  return quit_ || std::any_of(inbox_.begin(), inbox_.end(), supersede);
}

void SessionWorker::load(const command::Load& what) {
  keepBackup();
  if (startOver(what.domain, what.settings)) head({.kind = Goal::Kind::end, .then = what.tick}, Activity::meshing);
}

void SessionWorker::change(const Settings& settings) {
  if (!loaded_) {
    state_.settings = settings;  // for the domain to come
    return publishProgress();
  }
  const Stage first = firstAffected(state_.settings, settings);
  // What the first stage needs (Δx, the root of the quadtree) is worked out before it begins.
  const bool derives = first == Stage::constraints;
  const bool untouched = !derives && !hasComeTo(state_, first);
  if (first == Stage::finished || untouched) {
    state_.settings = settings;
    if (first != Stage::finished) {
      history_.changeSettings(settings);
      history_.forgetAfter(state_.tick);
      std::erase_if(checkpoints_, [first](const Checkpoint& c) { return hasComeTo(*c.state, first); });
      cutRun();
    }
    if (!backup_ && goal_.kind == Goal::Kind::none) publishState();
    return;
  }
  keepBackup();
  const MeshState& before = *backup_->at.state;
  const bool toEnd = before.stage == Stage::finished || goal_.kind == Goal::Kind::end;
  const std::uint64_t tick = before.tick;
  if (derives) {
    if (!startOver(state_.domain, settings)) return;
  } else {
    const auto last = std::find_if(checkpoints_.rbegin(), checkpoints_.rend(),
                                   [first](const Checkpoint& c) { return !hasComeTo(*c.state, first); });
    const Checkpoint& start = *last;  // there is always one: the first stage's
    state_.settings = settings;
    setAsideHistory(start.state->tick);
    history_.changeSettings(settings);
    returnTo(*start.state, start.events);
    last_ = start.last;
    // By stage: one that made no decision ends at the tick that it began at.
    std::erase_if(checkpoints_, [this](const Checkpoint& c) { return c.state->stage > state_.stage; });
    cutRun();
  }
  head({.kind = toEnd ? Goal::Kind::end : Goal::Kind::tick, .tick = tick}, Activity::meshing);
}

void SessionWorker::seek(std::uint64_t tick) {
  if (backup_) cancel();
  // At least one decision is made again, so that the last event is known.
  const Keyframe& start = history_.before(tick == 0 ? 0 : tick - 1);
  if (state_.tick > tick || start.state.tick > state_.tick) returnTo(start.state, start.events);
  head({.kind = Goal::Kind::tick, .tick = tick}, Activity::stepping);
}

void SessionWorker::seekEntry(const StageEntry& entry) {
  if (backup_) cancel();
  const Keyframe& start = history_.before(entry.tick);
  if (recorded_ > entry.event || start.state.tick > state_.tick) returnTo(start.state, start.events);
  head({.kind = Goal::Kind::entry, .stage = entry.stage, .round = entry.round, .tick = entry.tick}, Activity::stepping);
}

void SessionWorker::seekEvent(std::uint64_t index) {
  seek(recorder_.tickOfEvent(index).value_or(kUnknown));  // beyond the last decision: the end
}

void SessionWorker::stepBack(Grain grain) {
  if (backup_) cancel();
  const std::uint64_t now = state_.tick;
  if (grain == Grain::decision) return seek(now == 0 ? 0 : now - 1);
  if (grain == Grain::insertion) return seek(recorder_.insertionBefore(now));
  const StageEntry* const entry = entryOfDecision(recorder_.record(), now);
  if (entry == nullptr || entry->tick == 0) return seek(0);
  seekEntry(StageEntry(*entry));
}

void SessionWorker::goTo(Stage stage) {
  if (backup_) cancel();
  if (const StageEntry* const entry = firstEntry(recorder_.record(), stage)) return seekEntry(StageEntry(*entry));
  const Keyframe& start = history_.before(kUnknown);
  if (start.state.tick > state_.tick) returnTo(start.state, start.events);
  head({.kind = Goal::Kind::entry, .stage = stage, .tick = kUnknown}, Activity::stepping);
}

void SessionWorker::setBreakpoints(std::vector<Breakpoint> list) {
  watch_.reset();
  breakpoints_ = std::move(list);
  std::erase_if(hits_, [this](const PassedHit& hit) {
    return std::none_of(breakpoints_.begin(), breakpoints_.end(),
                        [&hit](const Breakpoint& b) { return b.condition.text() == hit.condition; });
  });
  hitsChanged_ = true;
  if (goal_.kind == Goal::Kind::breakpoint) watch_.emplace(state_, breakpoints_);
  if (loaded_ && !backup_ && goal_.kind == Goal::Kind::none) publishState();
}

void SessionWorker::goOn(bool backwards) {
  if (backup_) cancel();
  stopped_ = false;
  if (backwards) return goBackToBreakpoint();
  const bool any = std::any_of(breakpoints_.begin(), breakpoints_.end(), [](const Breakpoint& b) { return b.enabled; });
  if (!any) return head({.kind = Goal::Kind::end}, Activity::stepping);
  head({.kind = Goal::Kind::breakpoint}, Activity::stepping);
  watch_.emplace(state_, breakpoints_);
  const Breakpoint* const holding = watch_->holding();
  heldFromStart_ = holding != nullptr ? holding->condition.text() : std::string();
}

void SessionWorker::goBackToBreakpoint() {
  if (goal_.kind != Goal::Kind::none) publishState();
  head({}, Activity::searching);
  const std::optional<Hit> hit = continueBackward(history_, state_.tick, breakpoints_, searchPulse(state_.tick));
  if (hit) {
    takeHit(*hit, breakpoints_);
    return seek(hit->tick);
  }
  rest(interrupt_ ? "The search was stopped." : "No breakpoint is met before this decision.");
}

void SessionWorker::findViolation() {
  if (backup_) cancel();
  if (goal_.kind != Goal::Kind::none) publishState();
  head({}, Activity::searching);
  const std::vector<Breakpoint> rules = violationBreakpoints();
  MeshState probe = history_.before(0).state;
  probe.settings = state_.settings;
  std::vector<Hit> passed;
  const RunRecord& run = recorder_.record();
  const std::optional<Hit> hit = continueForward(probe, rules, passed, searchPulse(run.complete ? run.ticks : 0));
  if (hit) {
    takeHit(*hit, rules);
    notice_ =
        fmt::format("Decision {}: {}{}.", grouped(hit->tick), violationRules()[hit->breakpoint].words, unmetIn(probe));
    return seek(hit->tick);
  }
  rest(interrupt_ ? "The search was stopped."
                  : "No rule is broken in the whole run, and no bound once steps 1–5 are over.");
}

SearchPulse SessionWorker::searchPulse(std::uint64_t total) {
  return [this, total, looked = std::uint64_t{0}](const MeshState& probe) mutable {
    if (interrupt_.load(std::memory_order_relaxed)) return false;
    if (++looked % kLooksPerNews == 0 && Clock::now() - lastPublished_ >= kSearchNews)
      publishSearch(
          probe, total == 0 ? std::nullopt : std::optional(static_cast<double>(looked) / static_cast<double>(total)));
    return true;
  };
}

void SessionWorker::cancel() {
  if (!backup_) return halt();
  rejoinHistory();
  Backup backup = std::move(*backup_);
  backup_.reset();
  if (backup.whole) history_ = std::move(*backup.whole);
  state_ = *backup.at.state;
  recorded_ = backup.at.events;
  known_ = backup.known;
  kept_ = backup.kept;
  fresh_.clear();
  last_ = backup.at.last;
  checkpoints_ = std::move(backup.checkpoints);
  recorder_ = std::move(backup.recorder);
  trace_ = std::move(backup.trace);
  hits_ = std::move(backup.hits);
  goal_ = {};
  watch_.reset();
  activity_ = Activity::idle;
  publishProgress();
}

void SessionWorker::head(Goal goal, Activity activity) {
  watch_.reset();
  goal_ = goal;
  activity_ = activity;
  owed_ = goal.kind == Goal::Kind::play ? 1.0 : 0.0;  // the first decision at once
  goalSince_ = lastSlice_ = Clock::now();
  lastPublished_ = goalSince_;
  publishProgress();
}

void SessionWorker::headFor(Grain grain) {
  if (backup_) cancel();
  Goal goal{.stage = state_.stage, .round = state_.round, .vertices = state_.mesh.points.size()};
  switch (grain) {
    case Grain::decision:
      goal.kind = Goal::Kind::tick;
      goal.tick = state_.tick + 1;
      break;
    case Grain::insertion:
      goal.kind = Goal::Kind::insertion;
      break;
    case Grain::stage:
      goal.kind = Goal::Kind::stage;
      break;
    case Grain::round:
      goal.kind = Goal::Kind::round;
      break;
    case Grain::all:
      goal.kind = Goal::Kind::end;
      break;
  }
  head(goal, Activity::stepping);
}

void SessionWorker::halt() {
  goal_ = {};
  watch_.reset();
  backup_.reset();
  activity_ = Activity::idle;
  publishState();
}

void SessionWorker::rest(std::string notice) {
  notice_ = std::move(notice);
  activity_ = Activity::idle;
  publishProgress();
}

void SessionWorker::fail(Error error) {
  error_ = std::move(error);
  ++failures_;
  publishProgress();
}

}  // namespace triscope
