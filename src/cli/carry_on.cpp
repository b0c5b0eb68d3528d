#include "cli/carry_on.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <vector>

#include "cli/messages.h"
#include "cli/progress_line.h"
#include "core/density/request_text.h"
#include "core/domain/read.h"
#include "core/method/estimate.h"
#include "core/method/pipeline.h"
#include "core/method/triangle_limit.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

constexpr int kSlice = 4096;  // decisions between two times that the progress is shown: a few milliseconds

// Where many curves meet at small angles, their common point is what to look at: it is named, with their number.
std::string hubAt(const MeshState& state, const Event& failure) {
  constexpr int kMany = 3;
  if (failure.rule != Rule::recover_edge || !state.mesh.edges.has(EdgeId(failure.subject))) return "";
  const std::vector<Curve>& curves = state.domain->curves;
  const Curve& curve = curves[state.mesh.edges[EdgeId(failure.subject)].curve];
  const bool atStart = squaredDistance(curve.a, failure.at) < squaredDistance(curve.b, failure.at);
  const Point hub = atStart ? curve.a : curve.b;
  int ends = 0;
  for (const Curve& other : curves) ends += (other.a == hub ? 1 : 0) + (other.b == hub ? 1 : 0);
  return ends < kMany ? "" : fmt::format("; {} curves meet at ({:.9g}, {:.9g})", ends, hub.x, hub.y);
}

}  // namespace

Result<MeshState> beginFile(const std::string& domainFile, const Settings& settings, Notices notices) {
  Result<Domain> domain = readDomain(domainFile);
  if (!domain.ok()) return domain.error();
  ProgressLine progress(notices);
  Result<MeshState> state =
      begin(std::make_shared<const Domain>(std::move(*domain)), settings, [&progress](double fraction) {
        progress.show(fmt::format("looking for the smallest edge length, {:.0f} %", 100.0 * fraction));
        return true;
      });
  progress.clear();
  if (state.ok() && state->minEdgeDerived && notices == Notices::shown)
    say("aiming at a smallest edge length of {:g}, derived from the geometry; --set min_edge_length=… chooses "
        "another\n",
        state->minEdge);
  if (state.ok() && notices == Notices::shown)
    for (const std::string& cut : requestsCut(*state->domain, state->minEdge)) say("note: {}\n", cut);
  return state;
}

Result<StageSeconds> carryOn(MeshState& state, Stage last, EventsFile* events, Notices notices) {
  using Clock = std::chrono::steady_clock;
  StageSeconds seconds{};
  std::vector<Event> slice;
  Journal journal{events != nullptr ? &slice : nullptr};
  ProgressLine progress(notices);
  for (bool more = true; more;) {
    const Stage stage = state.stage;
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < kSlice && more && state.stage == stage; ++i) more = advanceUntil(state, last, 1, journal);
    if (stage == Stage::density && state.stage != stage && !state.failed && notices == Notices::shown) {
      progress.clear();
      say("about {} triangles and {} of memory by the estimate of Table 1\n", roughCount(state.estimatedTriangles),
          bytesText(estimateOf(state).bytes));
    }
    seconds[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(Clock::now() - start).count();
    if (events != nullptr) {
      if (const Status written = events->append(slice); !written.ok()) return written.error();
      slice.clear();
    }
    progress.show(state);
  }
  return seconds;
}

Error failureOf(const MeshState& failed) {
  if (overLimit(failed)) return tooManyTriangles(failed);
  // Failures are rare and runs repeat exactly: a run without a listener learns the reason by running again with one.
  std::vector<Event> events;
  Journal journal{&events};
  Result<MeshState> again = begin(failed.domain, failed.settings, {}, *failed.method);
  if (!again.ok()) return again.error();
  advance(*again, Grain::all, journal);
  for (auto event = events.rbegin(); event != events.rend(); ++event) {
    if (event->kind != EventKind::failure) continue;
    return Error{.kind = ErrorKind::unmet,
                 .message = fmt::format("the method cannot go on in stage {}: {}{}", infoOf(event->stage).name,
                                        describe(event->refusal), hubAt(*again, *event)),
                 .hint = "look at the domain there; 'triscope figure' draws the stages before",
                 .file = failed.domain->file,
                 .at = event->at};
  }
  return Error{.kind = ErrorKind::internal,
               .message = "the method gave up without saying why",
               .hint = "please report it with the domain",
               .file = failed.domain->file};
}

}  // namespace triscope
