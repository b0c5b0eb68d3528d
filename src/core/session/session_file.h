// A session on disk, JSON: everything needed to see what somebody saw, and to check that it still is so.
// docs/debugging.md describes the members.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/version.h"
#include "core/method/state.h"
#include "core/run/breakpoint.h"
#include "core/words/settings.h"

namespace triscope {

/// What the state was when a stage was over.
struct StageHash {
  Stage stage = Stage::constraints;
  std::uint16_t round = 0;  // MeshState::round while in the stage
  std::uint64_t tick = 0;   // decisions made by then
  std::uint64_t hash = 0;   // of the state right after the stage was left
  friend bool operator==(const StageHash&, const StageHash&) = default;
};

struct Bookmark {
  std::uint64_t tick = 0;
  std::string name;
  friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// The part of the plane that was looked at.
struct SavedView {
  Point centre;
  double scale = 1.0;  // pixels per unit of length, > 0
  friend bool operator==(const SavedView&, const SavedView&) = default;
};

struct SessionFile {
  MadeBy madeBy;           // as read; what is written says which version writes it
  std::string domainFile;  // where it was read from; may be gone, the text below is what counts
  std::string domainText;
  Settings settings;
  std::uint64_t tick = 0;  // decisions made at the current event
  std::vector<Breakpoint> breakpoints;
  std::vector<Bookmark> bookmarks;
  std::string notes;
  std::optional<SavedView> view;
  std::vector<StageHash> hashes;  // of the stages passed, in order; may be empty
  std::string savedAs;            // of work kept automatically: the session file that it goes on from, if any
};

/// Tells a session from a domain file by its content; a text that is no JSON is none.
bool isSession(std::string_view json);

std::string sessionText(const SessionFile& session);
/// Reads a session. Errors say which member is wrong, and what is expected there. The domain's own text is checked when
/// it is parsed, not here. Members that are not known are passed over; missing ones keep their defaults, but for the
/// domain.
Result<SessionFile> parseSession(std::string_view json, const std::string& fileName);

Status writeSession(const std::string& path, const SessionFile& session);
Result<SessionFile> readSession(const std::string& path);

/// A file's bytes, for domainText. ErrorKind::no_input when it cannot be read.
Result<std::string> readTextFile(const std::string& path);

/// Runs from a state at tick 0 and notes the hash at the end of each stage, of `most` stages at most and of those that
/// are over after `limit` decisions. `pulse` is called now and then; false stops.
std::vector<StageHash> stageHashes(MeshState start, std::uint64_t limit, std::size_t most,
                                   const std::function<bool(const MeshState&)>& pulse);

}  // namespace triscope
