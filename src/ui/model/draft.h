// What a session file is made from, as it is at one moment: cheap to copy and to compare.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session_file.h"

namespace triscope {

struct Draft {
  std::shared_ptr<const Domain> domain;
  Settings settings;
  std::vector<Breakpoint> breakpoints;
  std::vector<Bookmark> bookmarks;
  std::string notes;
  // Where somebody looks, which is no work of theirs:
  std::uint64_t tick = 0;
  std::optional<SavedView> view;  // nothing while the whole domain is shown
};

/// The same but for where somebody looks.
bool sameWork(const Draft& a, const Draft& b);
bool same(const Draft& a, const Draft& b);

/// Without hashes. `savedAs`: the session file that it goes on from, for work that is kept automatically.
SessionFile fileOf(const Draft& draft, const std::string& savedAs);

/// Of the stages passed before the current event and the last bookmark: makes that much of the mesh again. `pulse` is
/// called now and then; false stops, and the stages after are left out.
std::vector<StageHash> hashesOf(const Draft& draft, const std::function<bool()>& pulse);

}  // namespace triscope
