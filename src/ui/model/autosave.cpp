#include "ui/model/autosave.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "core/domain/read.h"

namespace triscope {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

constexpr auto kQuiet = seconds(3);     // after the last change
constexpr auto kLongest = seconds(30);  // after the first one that has not been written
constexpr std::size_t kMostKept = 20;
constexpr const char* kExtension = ".session";

fs::path lockOf(fs::path file) { return file.replace_extension(".lock"); }

/// True when a running program works on this file.
bool inUse(const fs::path& file) {
  const int lock = ::open(lockOf(file).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return false;
  const bool taken = ::flock(lock, LOCK_EX | LOCK_NB) != 0;
  ::close(lock);
  return taken;
}

struct Found {
  fs::path path;
  std::time_t when = 0;
};

/// Files left behind, the newest first.
std::vector<Found> leftBehind(const fs::path& folder) {
  std::vector<Found> files;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    struct stat info{};
    if (at->path().extension() != kExtension || ::stat(at->path().c_str(), &info) != 0 || inUse(at->path())) continue;
    files.push_back({at->path(), info.st_mtime});
  }
  std::sort(files.begin(), files.end(),
            [](const Found& a, const Found& b) { return a.when != b.when ? a.when > b.when : a.path > b.path; });
  return files;
}

void removeWork(const fs::path& file) {
  std::error_code failure;
  fs::remove(file, failure);
  fs::remove(lockOf(file), failure);
}

std::string nameOf(const SessionFile& session) {
  if (!session.savedAs.empty()) return fs::path(session.savedAs).filename().string();
  const Result<Domain> domain = parseDomain(session.domainText, session.domainFile);
  return domain && !domain->name.empty() ? domain->name : std::string("a domain");
}

}  // namespace

std::string Autosave::defaultFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return (fs::path(state) / "triscope" / "autosave").string();
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return (fs::path(home) / ".local" / "state" / "triscope" / "autosave").string();
  return {};
}

Autosave::Autosave(std::string folder, std::function<void()> wake)
    : folder_(std::move(folder)), wake_(std::move(wake)), name_(fmt::format("{}-{}", std::time(nullptr), ::getpid())) {}

Autosave::~Autosave() {
  job_.wait();
  unlock();
}

void Autosave::follow(const Draft& draft, const std::string& savedAs, Clock::time_point now) {
  if (folder_.empty()) return;
  if (std::optional<Status> done = job_.finished(); done && !*done) complaint_ = done->error();
  if (pending_ ? !same(draft, pending_->draft) : !written_ || !same(draft, *written_)) {
    const Clock::time_point since = pending_ ? pending_->since : now;
    pending_ = Pending{draft, savedAs, since, now};
  }
  if (pending_ && now >= dueAt() && !job_.running()) write();
}

void Autosave::forget() {
  job_.wait();
  pending_.reset();
  written_.reset();
  if (!std::exchange(exists_, false)) return;
  unlock();
  removeWork(file());
}

void Autosave::flush() {
  job_.wait();
  if (pending_) write();
  job_.wait();
}

void Autosave::setAside() {
  flush();
  written_.reset();
  if (!std::exchange(exists_, false)) return;
  unlock();
  name_ = fmt::format("{}-{}-{}", std::time(nullptr), ::getpid(), ++asides_);
}

void Autosave::adopt(const KeptWork& work) {
  forget();
  name_ = fs::path(work.path).stem().string();
  exists_ = true;
  lock();
}

Autosave::Clock::time_point Autosave::dueAt() const {
  return std::min<Clock::time_point>(pending_->changed + kQuiet, pending_->since + kLongest);
}

std::optional<double> Autosave::due(Clock::time_point now) const {
  if (!pending_ || job_.running()) return std::nullopt;  // the job wakes
  return std::max(0.0, std::chrono::duration<double>(dueAt() - now).count());
}

std::optional<Error> Autosave::complaint() { return std::exchange(complaint_, std::nullopt); }

std::vector<KeptWork> Autosave::keptWork() const {
  std::vector<KeptWork> kept;
  if (folder_.empty()) return kept;
  std::vector<Found> files = leftBehind(folder_);
  for (; files.size() > kMostKept; files.pop_back()) removeWork(files.back().path);
  for (const Found& found : files) {
    const Result<SessionFile> session = readSession(found.path.string());
    if (!session) continue;
    std::tm local{};
    ::localtime_r(&found.when, &local);
    kept.push_back({found.path.string(), nameOf(*session), fmt::format("{:%d %b %H:%M}", local)});
  }
  return kept;
}

void Autosave::write() {
  std::error_code failure;
  if (lock_ < 0) {
    fs::create_directories(folder_, failure);
    fs::permissions(folder_, fs::perms::owner_all, failure);
    lock();
  }
  Pending work = std::move(*pending_);
  pending_.reset();
  written_ = work.draft;
  exists_ = true;
  job_.start([work = std::move(work), path = file()]() { return writeSession(path, fileOf(work.draft, work.savedAs)); },
             wake_);
}

void Autosave::lock() {
  lock_ = ::open(lockOf(file()).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock_ >= 0) (void)::flock(lock_, LOCK_EX | LOCK_NB);
}

void Autosave::unlock() {
  if (lock_ < 0) return;
  std::error_code failure;
  fs::remove(lockOf(file()), failure);
  ::close(std::exchange(lock_, -1));
}

void discard(const KeptWork& work) { removeWork(work.path); }

}  // namespace triscope
