// Work that was not saved, kept in the user's state folder: written a few seconds after the last change, away from the
// window's thread, and found again when the program starts the next time.
//
// Each running program has a file of its own and holds a lock beside it as long as it runs; a file whose lock is free
// was left behind.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/model/background_job.h"
#include "ui/model/draft.h"

namespace triscope {

/// Work left behind by a program that was killed, or by opening something else over it.
struct KeptWork {
  std::string path;
  std::string name;  // of the domain, or of the session file that it goes on from
  std::string when;  // "22 Nov 14:32", local time
};

class Autosave {
 public:
  using Clock = std::chrono::steady_clock;

  /// $XDG_STATE_HOME/triscope/autosave, or under ~/.local/state; empty when there is no home.
  static std::string defaultFolder();

  /// `folder` is made when something is to be written; empty: nothing is kept. `wake` is called from another thread
  /// when a file has been written.
  Autosave(std::string folder, std::function<void()> wake);
  /// Waits for what is being written, and gives the lock back.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// To be told how things stand, often. Writes when it is time to.
  void follow(const Draft& draft, const std::string& savedAs, Clock::time_point now);
  /// There is nothing to keep: takes the file away.
  void forget();
  /// Writes what was last followed, if that has not been done, and waits for it.
  void flush();
  /// Leaves what was last followed to be found by keptWork(); what is followed from now on goes to another file.
  void setAside();
  /// Goes on writing to a file of keptWork() instead of the one of its own.
  void adopt(const KeptWork& work);

  /// Seconds until there is something to write; nothing when there is not.
  [[nodiscard]] std::optional<double> due(Clock::time_point now) const;
  /// Why the last file could not be written; once.
  std::optional<Error> complaint();

  /// What was left behind, the newest first. The oldest beyond 20 are deleted.
  [[nodiscard]] std::vector<KeptWork> keptWork() const;

 private:
  struct Pending {
    Draft draft;
    std::string savedAs;
    Clock::time_point since;    // the first change that has not been written
    Clock::time_point changed;  // the last
  };

  [[nodiscard]] Clock::time_point dueAt() const;
  [[nodiscard]] std::string file() const { return (folder_ / (name_ + ".session")).string(); }
  void write();
  void lock();
  void unlock();

  std::filesystem::path folder_;
  std::function<void()> wake_;
  std::string name_;  // of this program's file, without its extension
  int lock_ = -1;
  int asides_ = 0;
  bool exists_ = false;  // file() has been written
  std::optional<Draft> written_;
  std::optional<Pending> pending_;
  std::optional<Error> complaint_;
  BackgroundJob job_;
};

/// Deletes it.
void discard(const KeptWork& work);

}  // namespace triscope
