#include "ui/model/draft.h"

#include <algorithm>

#include "core/method/pipeline.h"

namespace triscope {
namespace {

bool sameBreakpoint(const Breakpoint& a, const Breakpoint& b) {
  return a.condition.text() == b.condition.text() && a.action == b.action && a.enabled == b.enabled;
}

}  // namespace

bool sameWork(const Draft& a, const Draft& b) {
  return a.domain == b.domain && a.settings == b.settings && a.bookmarks == b.bookmarks && a.notes == b.notes &&
         std::equal(a.breakpoints.begin(), a.breakpoints.end(), b.breakpoints.begin(), b.breakpoints.end(),
                    sameBreakpoint);
}

bool same(const Draft& a, const Draft& b) { return a.tick == b.tick && a.view == b.view && sameWork(a, b); }

SessionFile fileOf(const Draft& draft, const std::string& savedAs) {
  SessionFile file;
  file.domainFile = draft.domain->file;
  file.domainText = draft.domain->text;
  file.settings = draft.settings;
  file.tick = draft.tick;
  file.breakpoints = draft.breakpoints;
  file.bookmarks = draft.bookmarks;
  file.notes = draft.notes;
  file.view = draft.view;
  file.savedAs = savedAs;
  return file;
}

std::vector<StageHash> hashesOf(const Draft& draft, const std::function<bool()>& pulse) {
  Result<MeshState> start = begin(draft.domain, draft.settings);
  if (!start) return {};
  std::uint64_t furthest = draft.tick;
  for (const Bookmark& bookmark : draft.bookmarks) furthest = std::max(furthest, bookmark.tick);
  return stageHashes(std::move(*start), furthest, ~std::size_t{0}, [&pulse](const MeshState&) { return pulse(); });
}

}  // namespace triscope
