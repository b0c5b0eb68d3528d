#include "core/session_worker.h"

#include <algorithm>
#include <utility>

#include "core/domain/read.h"

namespace triscope {
namespace {

using std::chrono::milliseconds;

constexpr auto kSlice = milliseconds(5);          // a slice is not interrupted: this bounds how late a cancel is
constexpr auto kFrame = milliseconds(33);         // playing: no use in publishing more often than it is drawn
constexpr auto kLongStep = milliseconds(250);     // stepping: how often a long step shows how far it is
constexpr std::uint64_t kMostEvents = 6'000'000;  // about half a gigabyte; later events are made but not kept
constexpr std::size_t kCheckpointBytes = 256u << 20u;

template <class T>
std::size_t bytesOf(const std::vector<T>& v) {
  return v.size() * sizeof(T);
}

std::size_t bytesOf(const MeshState& s) {
  const Mesh& m = s.mesh;
  return bytesOf(m.points) + bytesOf(m.kinds) + bytesOf(m.density) + bytesOf(m.vertexTriangle) + bytesOf(m.vertexEdge) +
         bytesOf(m.triangles) + bytesOf(m.ids) + bytesOf(m.flags) + bytesOf(m.freeSlots) + bytesOf(m.edges) +
         bytesOf(s.constraints) + bytesOf(s.tree.cells) + bytesOf(s.boundary) + bytesOf(s.front1) + bytesOf(s.front2) +
         bytesOf(s.cursor.worklist) + bytesOf(s.cursor.next);
}

bool refines(const Settings& s) { return s.laplacian || s.reduceObtuse || s.sharedEdge; }

/// First stage that the difference between two settings can matter to; `finished` when they are the same.
Stage firstAffected(const Settings& a, const Settings& b) {
  Stage first = Stage::finished;
  for (const SettingInfo& info : settingTable())
    if (settingValue(a, info) != settingValue(b, info)) first = std::min(first, info.firstStage);
  // Whether step 6 is entered at all is decided when the stage before it ends.
  return first == Stage::refine && refines(a) != refines(b) ? Stage::repair : first;
}

/// How far the run is, from 0 to 1: insertions make up most of it, step 6 the rest.
double fractionDone(const MeshState& s) {
  constexpr double kInsertions = 0.85;
  if (s.stage == Stage::finished) return 1.0;
  if (s.stage == Stage::refine) {
    const double passes = std::max(1, s.settings.refinePasses);
    return kInsertions + (1.0 - kInsertions) * std::min(1.0, static_cast<double>(s.round) / passes);
  }
  if (s.stage < Stage::front1 || s.estimatedTriangles <= 0.0) return 0.0;
  return kInsertions * std::min(1.0, static_cast<double>(s.mesh.liveCount()) / s.estimatedTriangles);
}

}  // namespace

SessionWorker::SessionWorker(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { loop(); }) {}

SessionWorker::~SessionWorker() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  inboxChanged_.notify_one();
  thread_.join();
}

void SessionWorker::order(const Command& command) {
  {
    const std::lock_guard lock(mutex_);
    inbox_.push_back(command);
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

void SessionWorker::loop() {
  std::unique_lock lock(mutex_);
  while (!quit_) {
    if (!inbox_.empty()) {
      const Command command = std::move(inbox_.front());
      inbox_.pop_front();
      lock.unlock();
      carryOut(command);
      lock.lock();
      continue;
    }
    if (goal_.kind == Goal::Kind::none) {
      idle_ = true;
      becameIdle_.notify_all();
      inboxChanged_.wait(lock, [this] { return quit_ || !inbox_.empty(); });
      continue;
    }
    if (goal_.kind == Goal::Kind::play && owed_ < 1.0) {
      const double seconds = std::clamp((1.0 - owed_) / goal_.rate, 0.001, 0.1);
      inboxChanged_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return quit_ || !inbox_.empty(); });
    }
    lock.unlock();
    slice();
    lock.lock();
  }
}

void SessionWorker::carryOut(const Command& order) {
  ++ordersDone_;
  error_.reset();
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
    void operator()(const command::Change& c) const { w.change(c.settings); }
    void operator()(const command::Advance& c) const { w.headFor(c.grain); }
    void operator()(const command::Seek& c) const { w.seek(c.tick); }
    void operator()(const command::StepBack& c) const { w.stepBack(c.grain); }
    void operator()(const command::GoTo& c) const { w.goTo(c.stage); }
    void operator()(const command::Restart&) const { w.seek(0); }
    void operator()(const command::Play& c) const {
      w.head({.kind = Goal::Kind::play, .rate = std::max(c.decisionsPerSecond, 0.01)}, Activity::playing);
    }
    void operator()(const command::Pause&) const { w.halt(); }
    void operator()(const command::Cancel&) const { w.cancel(); }
  };
  const bool opens =
      std::holds_alternative<command::OpenFile>(order) || std::holds_alternative<command::OpenDomain>(order);
  if (!loaded_ && !opens)
    publishProgress();  // nothing to work on yet
  else
    std::visit(Visitor{*this}, order);
}

void SessionWorker::open(std::shared_ptr<const Domain> domain) {
  keepBackup();
  Settings settings = state_.settings;
  settings.minEdge = 0.0;  // Δx belongs to the domain; everything else is the user's
  if (startOver(std::move(domain), settings)) head({.kind = Goal::Kind::end}, Activity::meshing);
}

void SessionWorker::change(const Settings& settings) {
  const Stage first = firstAffected(state_.settings, settings);
  const bool untouched = state_.stage < first || (state_.stage == first && !state_.cursor.begun);
  if (first == Stage::finished || untouched) {
    state_.settings = settings;
    std::erase_if(checkpoints_, [first](const Checkpoint& c) {
      return c.state->stage > first || (c.state->stage == first && c.state->cursor.begun);
    });
    if (!backup_ && goal_.kind == Goal::Kind::none) publishState();
    return;
  }
  keepBackup();
  const MeshState& before = *backup_->at.state;
  const bool toEnd = before.stage == Stage::finished || goal_.kind == Goal::Kind::end;
  const std::uint64_t tick = before.tick;
  if (first == Stage::constraints) {
    if (!startOver(state_.domain, settings)) return;
  } else {
    const auto last = std::find_if(checkpoints_.rbegin(), checkpoints_.rend(), [first](const Checkpoint& c) {
      return c.state->stage < first || (c.state->stage == first && !c.state->cursor.begun);
    });
    const Checkpoint start = *last;  // there is always one: the first stage's
    state_.settings = settings;
    returnTo(start);
  }
  head({.kind = toEnd ? Goal::Kind::end : Goal::Kind::tick, .tick = tick}, Activity::meshing);
}

void SessionWorker::seek(std::uint64_t tick) {
  if (backup_) cancel();
  const auto last = std::find_if(checkpoints_.rbegin(), checkpoints_.rend(),
                                 [tick](const Checkpoint& c) { return c.state->tick <= tick; });
  if (state_.tick > tick || last->state->tick > state_.tick) {
    const Checkpoint start = *last;
    const std::vector<Checkpoint> later(last.base(), checkpoints_.end());  // the run ahead is the same run
    returnTo(start);
    checkpoints_.insert(checkpoints_.end(), later.begin(), later.end());
  }
  head({.kind = Goal::Kind::tick, .tick = tick}, Activity::stepping);
}

void SessionWorker::stepBack(Grain grain) {
  const std::uint64_t now = state_.tick;
  if (grain == Grain::decision) return seek(now == 0 ? 0 : now - 1);
  if (grain == Grain::insertion) {
    if (const auto tick = lastInsertionBefore(now)) return seek(*tick);
    return halt();
  }
  const auto before = std::find_if(checkpoints_.rbegin(), checkpoints_.rend(),
                                   [now](const Checkpoint& c) { return c.state->tick < now; });
  seek(before == checkpoints_.rend() ? 0 : before->state->tick);
}

void SessionWorker::goTo(Stage stage) {
  if (backup_) cancel();
  const auto entry = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                  [stage](const Checkpoint& c) { return c.state->stage >= stage; });
  if (entry != checkpoints_.end()) return seek(entry->state->tick);
  head({.kind = Goal::Kind::entry, .stage = stage}, Activity::stepping);
}

bool SessionWorker::interrupted() {
  const std::lock_guard lock(mutex_);
  return quit_ || !inbox_.empty();
}

std::optional<std::uint64_t> SessionWorker::lastInsertionBefore(std::uint64_t tick) {
  constexpr std::uint64_t kBetweenLooks = 256;
  Journal deaf;
  for (auto from = checkpoints_.rbegin(); from != checkpoints_.rend(); ++from) {
    if (from->state->tick >= tick) continue;
    MeshState replay = *from->state;
    replay.settings = state_.settings;
    // Beyond the next checkpoint nothing was found already.
    const std::uint64_t end = from == checkpoints_.rbegin() ? tick : std::min(tick, from.base()->state->tick + 1);
    std::optional<std::uint64_t> found;
    for (std::size_t vertices = replay.mesh.points.size();
         advance(replay, Grain::decision, deaf) && replay.tick < end;) {
      if (replay.mesh.points.size() > vertices) found = replay.tick;
      vertices = replay.mesh.points.size();
      if (replay.tick % kBetweenLooks == 0 && interrupted()) return std::nullopt;
    }
    if (found) return found;
  }
  return 0;
}

void SessionWorker::cancel() {
  if (!backup_) return halt();
  const Backup backup = std::move(*backup_);
  backup_.reset();
  state_ = *backup.at.state;
  recorded_ = kept_ = backup.at.events;
  fresh_.clear();
  last_ = backup.at.last;
  checkpoints_ = backup.checkpoints;
  goal_ = {};
  progress_.activity = Activity::idle;
  publishProgress();
}

void SessionWorker::head(Goal goal, Activity activity) {
  goal_ = goal;
  progress_.activity = activity;
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
      goal.kind = Goal::Kind::decision;
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
  backup_.reset();
  progress_.activity = Activity::idle;
  publishState();
}

void SessionWorker::fail(Error error) {
  error_ = std::move(error);
  ++failures_;
  publishProgress();
}

void SessionWorker::slice() {
  const auto start = Clock::now();
  std::uint64_t decisions = chunk_;
  switch (goal_.kind) {
    case Goal::Kind::decision:
    case Goal::Kind::insertion:
      decisions = 1;
      break;
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
  // Single decisions are taken until the slice is full; larger chunks fill one at once.
  do carry(decisions);
  while (goal_.kind == Goal::Kind::insertion && !reached() && Clock::now() - start < kSlice);
  const auto spent = Clock::now() - start;
  if (decisions == chunk_) {
    if (spent < kSlice / 2) chunk_ = std::min<std::uint64_t>(chunk_ * 2, 1u << 20u);
    if (spent > kSlice) chunk_ = std::max<std::uint64_t>(chunk_ / 2, 1);
  }
  if (reached()) return halt();
  const auto now = Clock::now();
  const auto patience = goal_.kind == Goal::Kind::play ? kFrame : kLongStep;
  if (now - lastPublished_ < std::max<Clock::duration>(patience, 4 * publishCost_)) return;
  if (backup_)
    publishProgress();
  else
    publishState();
}

void SessionWorker::carry(std::uint64_t decisions) {
  if (decisions == 0 || over()) return;
  slice_.clear();
  Journal journal{&slice_};
  const Stage before = state_.stage;
  if (decisions == 1)
    advance(state_, Grain::decision, journal);
  else
    advanceUntil(state_, before, decisions, journal);  // never beyond the stage: its end is a checkpoint
  if (!slice_.empty()) last_ = slice_.back();
  if (recorded_ < kMostEvents) {
    fresh_.insert(fresh_.end(), slice_.begin(), slice_.end());
    recorded_ += slice_.size();
  }
  if (state_.stage != before) rememberStage();
}

bool SessionWorker::reached() const {
  if (over()) return true;
  switch (goal_.kind) {
    case Goal::Kind::none:
    case Goal::Kind::decision:
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
      return state_.stage >= goal_.stage;
    case Goal::Kind::end:
    case Goal::Kind::play:
      return false;
  }
  return true;
}

bool SessionWorker::startOver(std::shared_ptr<const Domain> domain, const Settings& settings) {
  Result<MeshState> begun = begin(std::move(domain), settings);
  if (!begun) {
    if (backup_) cancel();
    fail(begun.error());
    return false;
  }
  state_ = std::move(*begun);
  loaded_ = true;
  recorded_ = kept_ = 0;
  fresh_.clear();
  last_.reset();
  checkpoints_.clear();
  rememberStage();
  return true;
}

void SessionWorker::returnTo(const Checkpoint& checkpoint) {
  const Settings settings = state_.settings;
  state_ = *checkpoint.state;
  state_.settings = settings;
  recorded_ = checkpoint.events;
  if (recorded_ >= kept_) {
    fresh_.resize(static_cast<std::size_t>(recorded_ - kept_));
  } else {
    kept_ = recorded_;
    fresh_.clear();
  }
  last_ = checkpoint.last;
  const std::uint64_t tick = state_.tick;
  std::erase_if(checkpoints_, [tick](const Checkpoint& c) { return c.state->tick > tick; });
}

void SessionWorker::rememberStage() {
  for (const Checkpoint& c : checkpoints_)
    if (c.state->stage == state_.stage) return;
  const std::size_t bytes = bytesOf(state_);
  std::size_t total = bytes;
  for (const Checkpoint& c : checkpoints_) total += c.bytes;
  // The latest saves the most work; the earliest costs nearly nothing.
  while (total > kCheckpointBytes && checkpoints_.size() > 1) {
    total -= checkpoints_.back().bytes;
    checkpoints_.pop_back();
  }
  checkpoints_.push_back({std::make_shared<const MeshState>(state_), recorded_, last_, bytes});
}

void SessionWorker::keepBackup() {
  if (backup_ || !loaded_) return;
  if (recorded_ != kept_ || !fresh_.empty()) publishState();
  backup_ = Backup{{std::make_shared<const MeshState>(state_), recorded_, last_, 0}, checkpoints_};
}

Publication& SessionWorker::outbox() {
  if (!outbox_) outbox_.emplace();
  Publication& news = *outbox_;
  progress_.stage = state_.stage;
  progress_.tick = state_.tick;
  progress_.triangles = state_.mesh.liveCount();
  progress_.estimated = state_.estimatedTriangles;
  progress_.fraction = fractionDone(state_);
  progress_.seconds = std::chrono::duration<double>(Clock::now() - goalSince_).count();
  news.progress = progress_;
  news.settings = state_.settings;
  news.ordersDone = ordersDone_;
  news.error = error_;
  news.failures = failures_;
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

void SessionWorker::publishState() {
  const auto start = Clock::now();
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->revision = ++revision_;
  snapshot->state = state_;
  snapshot->quality = measure(state_.mesh);
  snapshot->last = last_;
  snapshot->events = recorded_;
  {
    const std::lock_guard lock(mutex_);
    Publication& news = outbox();
    // An earlier snapshot that nobody has taken yet gives way; its events are still wanted.
    if (news.snapshot && kept_ >= news.keepEvents) {
      news.freshEvents.resize(static_cast<std::size_t>(kept_ - news.keepEvents));
      news.freshEvents.insert(news.freshEvents.end(), fresh_.begin(), fresh_.end());
    } else {
      news.keepEvents = kept_;
      news.freshEvents = std::move(fresh_);
    }
    news.snapshot = std::move(snapshot);
  }
  fresh_.clear();
  kept_ = recorded_;
  lastPublished_ = Clock::now();
  publishCost_ = lastPublished_ - start;
  if (wake_) wake_();
}

}  // namespace triscope
