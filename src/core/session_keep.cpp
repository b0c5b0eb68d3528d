// What a session's worker keeps so that it can go back: keyframes, the entries of stages, and the run from before a
// change while the next one is being made.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/session_worker.h"

namespace triscope {
namespace {

constexpr std::size_t kCheckpointBytes = 128u << 20u;

}  // namespace

bool SessionWorker::startOver(std::shared_ptr<const Domain> domain, const Settings& settings) {
  MeshState probe;  // what is shown of the run while it has no state yet
  probe.settings = settings;
  probe.domain = domain;
  const Activity before = std::exchange(activity_, Activity::meshing);
  goalSince_ = Clock::now();
  publishBeginning(probe, 0.0);
  Result<MeshState> begun =
      begin(std::move(domain), settings, [&](double fraction) { return tellOfDeriving(probe, fraction); });
  activity_ = before;
  if (!begun) {
    if (backup_) cancel();
    if (begun.error().code == ExitCode::cancelled)
      publishProgress();
    else
      fail(begun.error());
    return false;
  }
  if (backup_ && !backup_->whole) {
    rejoinHistory();
    backup_->whole = std::exchange(history_, History(kHistoryBytes));
  }
  state_ = std::move(*begun);
  loaded_ = true;
  recorded_ = 0;
  last_.reset();
  checkpoints_.clear();
  history_.restart(state_);
  cutRun();
  rememberStage();
  return true;
}

// The decision that was being made may have been left half done: nothing of the run can be kept but what was there
// before a re-mesh, or else its beginning.
void SessionWorker::giveUp() {
  if (backup_) {
    cancel();
  } else if (loaded_) {
    goal_ = {};
    watch_.reset();
    const Settings settings = state_.settings;
    state_ = {};  // a copy would keep the room that it took
    state_.settings = settings;
    returnTo(history_.before(0).state, 0);
    beat_.clear();
    checkpoints_.clear();
    history_.forgetAfter(0);
    trace_ = {};
    cutRun();
    rememberStage();
    activity_ = Activity::idle;
    publishState();
  }
  fail(notEnoughMemory());
}

void SessionWorker::returnTo(const MeshState& state, std::uint64_t events) {
  const Settings settings = state_.settings;
  state_ = state;
  state_.settings = settings;
  recorded_ = events;
  last_.reset();
}

void SessionWorker::cutRun() {
  known_ = recorded_;
  kept_ = std::min(kept_, known_);
  fresh_.resize(std::min<std::size_t>(fresh_.size(), static_cast<std::size_t>(known_ - kept_)));
  recorder_.forgetAfter(state_.tick, recorded_);
  trace_.forgetAfter(state_.tick);
  std::erase_if(hits_, [this](const PassedHit& hit) { return hit.tick > state_.tick; });
  recordChanged_ = hitsChanged_ = true;
}

void SessionWorker::setAsideHistory(std::uint64_t branch) {
  if (!backup_ || backup_->whole || branch >= backup_->branch) return history_.forgetAfter(branch);
  history_.forgetAfter(backup_->branch);  // of a re-mesh that was changed again
  std::vector<Keyframe> later = history_.splitAfter(branch);
  std::move(backup_->later.begin(), backup_->later.end(), std::back_inserter(later));
  backup_->later = std::move(later);
  backup_->branch = branch;
}

void SessionWorker::rejoinHistory() {
  if (backup_->whole) return;
  history_.forgetAfter(backup_->branch);
  history_.changeSettings(backup_->at.state->settings);
  history_.append(std::exchange(backup_->later, {}));
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
  if (goal_.kind != Goal::Kind::none || !fresh_.empty()) publishState();
  backup_.emplace(Backup{});  // clang: not default-constructible to an optional inside the class
  backup_->at = {std::make_shared<const MeshState>(state_), recorded_, last_, 0};
  backup_->checkpoints = checkpoints_;
  backup_->recorder = recorder_;
  backup_->trace = trace_;
  backup_->hits = hits_;
  backup_->known = known_;
  backup_->kept = kept_;
}

}  // namespace triscope
