#include "core/session_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "core/counted.h"

namespace triscope {
namespace {

using std::chrono::milliseconds;

constexpr auto kSlice = milliseconds(5);           // a slice is not interrupted: this bounds how late a cancel is
constexpr auto kFrame = milliseconds(33);          // playing: no use in publishing more often than it is drawn
constexpr auto kLongStep = milliseconds(250);      // stepping: how often a long step shows how far it is
constexpr std::uint64_t kMostEvents = 16'000'000;  // about half a gigabyte; later events are made but not kept
constexpr std::size_t kMostHits = 10'000;

/// How far the run is, from 0 to 1: insertions make up most of it, step 6 the rest.
double fractionDone(const MeshState& s) {
  constexpr double kSearch = 0.1;  // for constraints: next to nothing for a few curves, most of the time for thousands
  constexpr double kInsertions = 0.85;
  if (s.stage == Stage::finished) return 1.0;
  if (s.stage == Stage::constraints && s.domain)
    return s.cursor.begun ? kSearch * fractionOf(s.search, *s.domain) : 0.0;
  if (s.stage == Stage::refine) {
    const double passes = std::max(1, s.settings.refinePasses);
    return kInsertions + (1.0 - kInsertions) * std::min(1.0, static_cast<double>(s.round) / passes);
  }
  if (s.stage < Stage::front1 || s.estimatedTriangles <= 0.0) return kSearch;
  const double made = std::min(1.0, static_cast<double>(s.mesh.liveCount()) / s.estimatedTriangles);
  return kSearch + (kInsertions - kSearch) * made;
}

}  // namespace

SessionWorker::SessionWorker(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { loop(); }) {}

SessionWorker::~SessionWorker() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    interrupt_ = true;
  }
  inboxChanged_.notify_one();
  thread_.join();
}

void SessionWorker::order(const Command& command) {
  {
    const std::lock_guard lock(mutex_);
    inbox_.push_back(command);
    interrupt_ = true;
    idle_ = false;
  }
  inboxChanged_.notify_one();
}

std::optional<Publication> SessionWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outbox_, std::nullopt);
}

bool SessionWorker::waitIdle(milliseconds patience) {
  std::unique_lock lock(mutex_);
  return becameIdle_.wait_for(lock, patience, [this] { return idle_; });
}

template <class Work>
void SessionWorker::survive(const Work& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    giveUp();
  }
}

void SessionWorker::loop() {
  std::unique_lock lock(mutex_);
  while (!quit_) {
    if (!inbox_.empty()) {
      const Command command = std::move(inbox_.front());
      inbox_.pop_front();
      interrupt_ = !inbox_.empty();
      lock.unlock();
      survive([&] { carryOut(command); });
      lock.lock();
      continue;
    }
    if (goal_.kind == Goal::Kind::none) {
      idle_ = true;
      becameIdle_.notify_all();
      if (traceLags()) {
        lock.unlock();
        survive([this] { carryTrace(); });
        lock.lock();
        continue;
      }
      inboxChanged_.wait(lock, [this] { return quit_ || !inbox_.empty(); });
      continue;
    }
    if (goal_.kind == Goal::Kind::play && owed_ < 1.0) {
      const double seconds = std::clamp((1.0 - owed_) / goal_.rate, 0.001, 0.1);
      inboxChanged_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return quit_ || !inbox_.empty(); });
    }
    lock.unlock();
    survive([this] { slice(); });
    lock.lock();
  }
}

void SessionWorker::slice() {
  const auto start = Clock::now();
  std::uint64_t decisions = chunk_;
  switch (goal_.kind) {
    case Goal::Kind::tick:
      decisions = std::min(chunk_, goal_.tick - std::min(goal_.tick, state_.tick));
      break;
    case Goal::Kind::play: {
      owed_ += goal_.rate * std::chrono::duration<double>(start - lastSlice_).count();
      decisions = std::min(chunk_, static_cast<std::uint64_t>(owed_));
      owed_ = std::min(owed_ - static_cast<double>(decisions), static_cast<double>(chunk_));  // debt is not hoarded
      break;
    }
    default:
      break;
  }
  lastSlice_ = start;
  if (goal_.kind == Goal::Kind::breakpoint)
    carryWatching(start + kSlice);
  else
    carry(decisions);
  const auto spent = Clock::now() - start;
  if (decisions == chunk_ && goal_.kind != Goal::Kind::breakpoint) {
    if (spent < kSlice / 2) chunk_ = std::min<std::uint64_t>(chunk_ * 2, 1u << 20u);
    if (spent > kSlice) chunk_ = std::max<std::uint64_t>(chunk_ / 2, 1);
  }
  if (reached()) {
    if (goal_.kind == Goal::Kind::breakpoint && !stopped_) {
      notice_ = "No breakpoint was met before the end of the run.";
      if (!heldFromStart_.empty())
        notice_ +=
            fmt::format(" Where it began, {} held already: that is met when it next becomes true.", heldFromStart_);
    }
    const std::optional<std::uint64_t> then = goal_.then;
    halt();
    if (then) seek(*then);
    return;
  }
  const auto now = Clock::now();
  const auto patience = goal_.kind == Goal::Kind::play ? kFrame : kLongStep;
  if (now - lastPublished_ < std::max<Clock::duration>(patience, 4 * publishCost_)) return;
  if (backup_)
    publishProgress();
  else
    publishState();
}

void SessionWorker::carry(std::uint64_t beats) {
  Journal journal{&beat_};
  const auto start = Clock::now();
  for (; beats > 0 && !over(); --beats) {
    beat_.clear();
    const Stage stage = state_.stage;
    const std::uint64_t tick = state_.tick;
    const std::size_t points = state_.mesh.points.size();
    advanceUntil(state_, stage, 1, journal);
    recorder_.follow(state_, recordBeat(tick, points));
    if (state_.tick != tick) history_.offer(state_, recorded_);
    if (state_.stage != stage) rememberStage();
    if (reached()) return;
    // A piece of the work for a decision may take longer than the decisions that the slice was measured by.
    const bool worked = state_.tick == tick && state_.stage == stage;
    if (worked && (interrupt_.load(std::memory_order_relaxed) || Clock::now() - start > kSlice)) return;
  }
}

void SessionWorker::carryWatching(Clock::time_point end) {
  std::vector<Hit> hits;
  while (!reached()) {
    const std::uint64_t tick = state_.tick;
    const std::size_t points = state_.mesh.points.size();
    const bool more = watch_->step(hits);
    beat_.assign(watch_->events().begin(), watch_->events().end());
    recorder_.follow(state_, recordBeat(tick, points));
    if (state_.tick != tick) history_.offer(state_, recorded_);
    for (const Hit& hit : hits) takeHit(hit, breakpoints_);
    hits.clear();
    if (!more || Clock::now() >= end) return;
  }
}

Beat SessionWorker::recordBeat(std::uint64_t tickBefore, std::size_t pointsBefore) {
  if (!beat_.empty()) last_ = beat_.back();
  recorded_ += beat_.size();
  if (recorded_ > known_) {
    // A replay makes events again that the viewer has.
    const auto fresh = static_cast<std::ptrdiff_t>(recorded_ - known_);
    if (known_ < kMostEvents) fresh_.insert(fresh_.end(), beat_.end() - fresh, beat_.end());
    known_ = recorded_;
    recordChanged_ = true;
  }
  return {tickBefore, pointsBefore, beat_, recorded_};
}

void SessionWorker::takeHit(const Hit& hit, std::span<const Breakpoint> breakpoints) {
  const Breakpoint& met = breakpoints[hit.breakpoint];
  const std::string& condition = met.condition.text();
  if (met.action == Breakpoint::Action::stop) {
    stopped_ = true;
    notice_ = fmt::format("Stopped at decision {}: {}", grouped(hit.tick), condition);
  }
  if (hits_.size() >= kMostHits) return;
  const auto after = std::upper_bound(hits_.begin(), hits_.end(), hit.tick,
                                      [](std::uint64_t tick, const PassedHit& h) { return tick < h.tick; });
  for (auto same = after; same != hits_.begin() && (same - 1)->tick == hit.tick; --same)
    if ((same - 1)->condition == condition) return;
  hits_.insert(after, {hit.tick, condition, met.action, hit.event});
  hitsChanged_ = true;
}

bool SessionWorker::reached() const {
  if (over()) return true;
  switch (goal_.kind) {
    case Goal::Kind::none:
      return true;
    case Goal::Kind::insertion:
      return state_.mesh.points.size() > goal_.vertices;
    case Goal::Kind::stage:
      return state_.stage != goal_.stage;
    case Goal::Kind::round:
      return state_.round != goal_.round || (goal_.round == 0 && state_.stage != goal_.stage);
    case Goal::Kind::tick:
      return state_.tick >= goal_.tick;
    case Goal::Kind::entry:
      if (goal_.tick == kUnknown) return state_.stage >= goal_.stage;
      return state_.tick > goal_.tick ||
             (state_.tick == goal_.tick && state_.stage == goal_.stage && state_.round == goal_.round);
    case Goal::Kind::breakpoint:
      return stopped_;
    case Goal::Kind::end:
    case Goal::Kind::play:
      return false;
  }
  return true;
}

bool SessionWorker::traceLags() const {
  const std::vector<QualitySample>& samples = trace_.samples();
  return loaded_ && (samples.empty() ? 0 : samples.back().tick) < recorder_.record().ticks;
}

void SessionWorker::carryTrace() {
  const bool more = trace_.carryOn(history_, recorder_.record().ticks, kSlice);
  const auto now = Clock::now();
  if (more && now - lastTrace_ < kLongStep) return;
  lastTrace_ = now;
  {
    const std::lock_guard lock(mutex_);
    outbox().record = record();
  }
  if (wake_) wake_();
}

std::shared_ptr<const RunRecord> SessionWorker::record() const {
  auto record = std::make_shared<RunRecord>(recorder_.record());
  record->samples = trace_.samples();
  return record;
}

std::shared_ptr<const MeshState> SessionWorker::beforeRefinement() const {
  for (const Checkpoint& c : checkpoints_)
    if (c.state->stage == Stage::refine) return c.state;
  return nullptr;
}

Progress SessionWorker::progressAt(const MeshState& state) const {
  return {.activity = activity_,
          .stage = state.stage,
          .tick = state.tick,
          .triangles = state.mesh.liveCount(),
          .estimated = state.estimatedTriangles,
          .fraction = fractionDone(state),
          .seconds = std::chrono::duration<double>(Clock::now() - goalSince_).count()};
}

Publication& SessionWorker::outbox() {
  if (!outbox_) outbox_.emplace();
  Publication& news = *outbox_;
  news.progress = progressAt(state_);
  news.settings = state_.settings;
  news.domain = state_.domain;
  news.beforeRefinement = beforeRefinement();
  news.ordersDone = ordersDone_;
  news.error = error_;
  news.failures = failures_;
  news.notice = notice_;
  news.stale = backup_.has_value();
  return news;
}

void SessionWorker::publishProgress() {
  {
    const std::lock_guard lock(mutex_);
    outbox();
  }
  lastPublished_ = Clock::now();
  if (wake_) wake_();
}

void SessionWorker::publishSearch(const MeshState& probe, std::optional<double> fraction) {
  {
    const std::lock_guard lock(mutex_);
    Progress& progress = outbox().progress;
    progress = progressAt(probe);
    if (fraction) progress.fraction = *fraction;
  }
  lastPublished_ = Clock::now();
  if (wake_) wake_();
}

bool SessionWorker::tellOfDeriving(const MeshState& probe, double fraction) {
  if (interrupt_.load(std::memory_order_relaxed) && supersedes(probe.domain != state_.domain)) return false;
  if (Clock::now() - lastPublished_ >= kLongStep) publishBeginning(probe, fraction);
  return true;
}

void SessionWorker::publishBeginning(const MeshState& probe, double fraction) {
  {
    const std::lock_guard lock(mutex_);
    Publication& news = outbox();
    news.progress = progressAt(probe);
    news.progress.fraction = fraction;
    news.settings = probe.settings;
    news.domain = probe.domain;
  }
  lastPublished_ = Clock::now();
  if (wake_) wake_();
}

void SessionWorker::publishState() {
  const auto start = Clock::now();
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->revision = ++revision_;
  snapshot->state = state_;
  snapshot->quality = measure(state_.mesh);
  snapshot->last = last_;
  snapshot->events = recorded_;
  std::shared_ptr<const RunRecord> fresh;
  std::shared_ptr<const std::vector<PassedHit>> hits;
  if (std::exchange(recordChanged_, false)) fresh = record();
  if (std::exchange(hitsChanged_, false)) hits = std::make_shared<const std::vector<PassedHit>>(hits_);
  {
    const std::lock_guard lock(mutex_);
    Publication& news = outbox();
    // An earlier snapshot that nobody has taken yet gives way; its events are still wanted.
    if (news.snapshot && kept_ >= news.keepEvents) {
      news.freshEvents.resize(static_cast<std::size_t>(kept_ - news.keepEvents));
      news.freshEvents.insert(news.freshEvents.end(), fresh_.begin(), fresh_.end());
    } else {
      news.keepEvents = kept_;
      news.freshEvents = fresh_;
    }
    news.snapshot = std::move(snapshot);
    if (fresh) news.record = std::move(fresh);
    if (hits) news.hits = std::move(hits);
  }
  kept_ += std::exchange(fresh_, {}).size();
  lastPublished_ = Clock::now();
  publishCost_ = lastPublished_ - start;
  if (wake_) wake_();
}

}  // namespace triscope
