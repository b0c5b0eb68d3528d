#include "ui/model/debug_state.h"

#include <algorithm>
#include <cmath>

#include "core/explain/life.h"
#include "core/explain/why.h"
#include "core/mesh/inside_box.h"

namespace triscope {

std::optional<Ref> refOf(const Pick& pick) {
  switch (pick.selection.kind) {
    case Selection::Kind::vertex:
      return Ref{Ref::Kind::vertex, pick.id};
    case Selection::Kind::edge:
    case Selection::Kind::triangle:
      return Ref{Ref::Kind::triangle, pick.id};
    case Selection::Kind::cell:
      return Ref{Ref::Kind::cell, pick.id};
    case Selection::Kind::none:
      break;
  }
  return std::nullopt;
}

void update(Answers& answers, const Session& session, const std::optional<Ref>& about) {
  const Snapshot* const now = session.current().get();
  if (now == nullptr) return;
  if (answers.about == about && answers.revision == now->revision) return;
  answers = {};
  answers.about = about;
  answers.revision = now->revision;
  if (!about) return;
  const Events events = session.events();
  TriangleFacts facts;
  if (about->kind == Ref::Kind::triangle) {
    facts = factsOf(now->state.mesh, TriangleId(about->id)).value_or(TriangleFacts{});
    answers.whyNot = whyNot(events, about->id, facts);
  }
  answers.why = why(events, *about, facts);
  answers.history = historyOf(events, *about, facts);
  // Beyond the current decision the run may be known already.
  const Events run = session.runEvents();
  answers.birth = birthOf(run, *about);
  // Those of the decision that led here are neither before nor after it.
  const std::vector<std::size_t> all = eventsAbout(run, *about);
  const auto here = std::lower_bound(all.begin(), all.end(), now->firstEvent);
  if (here != all.begin()) answers.previous = *(here - 1);
  const auto after = std::lower_bound(here, all.end(), now->events);
  if (after != all.end()) answers.next = *after;
}

void update(Histogram& histogram, const Session& session, Measure measure) {
  const Snapshot* const now = session.current().get();
  if (now == nullptr || (histogram.revision == now->revision && histogram.measure == measure)) return;
  constexpr std::size_t kBars = 48;
  histogram = {now->revision, measure, 0.0, 0.0, 0.0, {}};
  const Mesh& mesh = now->state.mesh;
  const InsideBox inside(mesh);
  std::vector<double> values;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!inside.has(slot)) continue;
    const double value = measuresOf(mesh, slot)[static_cast<std::size_t>(measure)];
    if (std::isfinite(value)) values.push_back(value);
  }
  if (values.empty()) return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  histogram.low = *least;
  histogram.most = *most;
  // A few very bad triangles would press all others into one bar: the last bar takes what lies beyond.
  std::vector<double> sorted = values;
  const auto beyond = sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), beyond, sorted.end());
  histogram.high = std::min(*most, *least + 1.5 * (*beyond - *least));
  if (histogram.high <= histogram.low) histogram.high = histogram.low + std::max(1e-9, 1e-6 * std::fabs(histogram.low));
  histogram.counts.assign(kBars, 0);
  for (const double value : values) {
    const double bar = (value - histogram.low) / histogram.width();
    ++histogram.counts[std::min(kBars - 1, static_cast<std::size_t>(bar))];
  }
}

TickRange shownRange(const DebugUi& ui, const RunRecord& record) {
  const auto end = static_cast<double>(std::max<std::uint64_t>(record.ticks, 1));
  if (ui.to <= ui.from) return {0.0, end};
  const double from = std::clamp(ui.from, 0.0, end);
  const double to = std::clamp(ui.to, 1.0, end);
  return from < to ? TickRange{from, to} : TickRange{0.0, end};  // the run may have become shorter than the range
}

}  // namespace triscope
