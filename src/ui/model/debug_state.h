// What the debugger's panels show beyond the run itself: the choices made in them, and answers worked out once for
// each place in the run instead of at every frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/quality/running_quality.h"
#include "core/run/breakpoint.h"
#include "core/session/session.h"
#include "core/session/session_file.h"
#include "core/words/links.h"
#include "render/pick.h"
#include "ui/model/panel.h"

namespace triscope {

enum class PlotOf : std::uint8_t { aspect, area_ratio, edge_ratio, min_angle, max_angle, triangles, obtuse };
inline constexpr int kPlotOfCount = static_cast<int>(PlotOf::obtuse) + 1;

/// Choices made by the user.
struct DebugUi {
  std::optional<Panel> bottom;  // panel above the timeline; nothing: none
  Panel rightTab = Panel::inspect;
  double from = 0.0;  // decisions that the timeline and the plots show; all when to <= from
  double to = 0.0;
  std::vector<Bookmark> bookmarks;  // by tick
  std::string condition;            // being typed
  int typeSoon = 0;                 // frames that the panel, just opened, has left to give its field the keyboard
  Breakpoint::Action action = Breakpoint::Action::stop;
  std::optional<Error> complaint;  // about what was typed
  PlotOf plot = PlotOf::aspect;
  Measure histogram = Measure::aspect;
};

/// Why, why not and history of what is selected.
struct Answers {
  std::optional<Ref> about;
  std::uint64_t revision = 0;  // of the snapshot that they are about
  std::vector<Line> why;
  std::vector<Line> whyNot;  // of triangles
  std::vector<Line> history;
  std::optional<std::size_t> birth;  // events
  std::optional<std::size_t> previous;
  std::optional<std::size_t> next;
};

/// How many triangles of the current mesh have a measure in each of some intervals of the same width.
struct Histogram {
  std::uint64_t revision = 0;
  Measure measure = Measure::aspect;
  double low = 0.0;
  double high = 0.0;  // of the intervals; the last one takes what lies beyond, up to …
  double most = 0.0;  // … the largest
  std::vector<std::uint32_t> counts;
  [[nodiscard]] double width() const { return (high - low) / static_cast<double>(counts.size()); }
};

struct DebugAnswers {
  Answers answers;
  Histogram histogram;
};

/// The element that is selected, as the debugger names it; an edge stands for its triangle.
std::optional<Ref> refOf(const Pick& pick);
/// Brings the answers up to date with the session's current place.
void update(Answers& answers, const Session& session, const std::optional<Ref>& about);
void update(Histogram& histogram, const Session& session, Measure measure);

/// The decisions shown, first and last.
struct TickRange {
  double from;
  double to;
};
TickRange shownRange(const DebugUi& ui, const RunRecord& record);

}  // namespace triscope
