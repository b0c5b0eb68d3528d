// triscope mesh: runs the method without a window and writes what was asked for.
#include <numeric>
#include <optional>

#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/outputs.h"
#include "core/base/output_set.h"
#include "core/explain/aim_text.h"
#include "core/explain/bound_text.h"
#include "core/explain/undercut_text.h"
#include "core/io/report.h"
#include "core/method/triangle_limit.h"
#include "core/quality/bound_figure.h"
#include "core/quality/quality.h"

namespace triscope {
namespace {

void warnOfUnusualSettings(const Settings& settings) {
  for (const SettingInfo& info : settingTable()) {
    const double value = settingValue(settings, info);
    if (outsidePaper(info, value))
      say("note: {} = {:g} is outside the paper's {:g} to {:g}\n", info.key, value, info.paperLow, info.paperHigh);
  }
}

void summarise(const MeshState& state, const Quality& quality, double seconds) {
  say("{} triangles, {} vertices in {:.2f} s", quality.triangles, quality.vertices, seconds);
  if (isCarved(state.stage))
    say(": aspect {}, area ratio {}, edge ratio {}, angles {} to {} degrees, {} obtuse",
        besideBound(quality.aspectMax, Bounds::aspect, 2), besideBound(quality.areaRatioMax, Bounds::areaRatio, 2),
        besideBound(quality.edgeRatioMax, Bounds::edgeRatio, 2), besideBound(quality.minAngle, Bounds::minAngle, 1),
        besideBound(quality.maxAngle, Bounds::maxAngle, 1), quality.obtuse);
  say("\n");
  if (!isPastRounds(state.stage)) return;
  for (const WorstMeasure& worst : worstOf(quality))
    if (!worst.met()) say("note: {}\n", unmetText(state.mesh, quality, worst));
  if (const std::vector<std::string> aims = unmetAimTexts(state, quality); !aims.empty())
    say("note: short of what the dial asks for: {}\n", fmt::join(aims, "; "));
  if (const std::string obtuse = obtuseText(state, quality); !obtuse.empty()) say("note: {}\n", obtuse);
  if (const std::string undercut = undercutText(state, quality); !undercut.empty()) say("note: {}\n", undercut);
}

/// Everything that was asked for. Where the method cannot go on only the report and the events are written: they say
/// why.
Status writeAll(const MeshCommand& options, const MeshState& state, const Quality& quality, const StageSeconds& seconds,
                std::optional<EventsFile>& events, OutputSet& files) {
  if (state.failed) {
    for (const std::string& path : options.outputs)
      for (const std::string& name : filesOf(path)) files.leaveOut(name);
  } else if (Status written = writeOutputs(options.outputs, state, options.until, {.msh2 = options.msh2}, files);
             !written.ok()) {
    return written;
  }
  if (!options.report.empty()) {
    const std::string report = reportOf(state, quality, seconds);
    if (Status written = files.write(options.report, report); !written.ok()) return written;
  }
  if (events) {
    if (Status written = events->finish(); !written.ok()) return written;
  }
  return files.commit();
}

}  // namespace

ExitCode runCommand(const MeshCommand& options) {
  if (const Status known = checkOutputs(options.outputs, options.until); !known.ok()) return fail(known.error());
  if (options.notices == Notices::shown) warnOfUnusualSettings(options.settings);
  Result<MeshState> state = beginFile(options.domain, options.settings, options.notices);
  if (!state.ok()) return fail(state.error());
  std::vector<std::string> paths = options.outputs;
  if (!options.report.empty()) paths.push_back(options.report);
  OutputSet files;
  if (const Status open = openOutputs(paths, files); !open.ok()) return fail(open.error());
  std::optional<EventsFile> events;
  if (!options.events.empty()) {
    Result<EventsFile> file = EventsFile::create(options.events, files);
    if (!file.ok()) return fail(file.error());
    events = std::move(*file);
    paths.push_back(options.events);
  }

  const Result<StageSeconds> seconds = carryOn(*state, options.until, events ? &*events : nullptr, options.notices);
  if (!seconds.ok()) return fail(seconds.error());
  if (overLimit(*state)) return fail(failureOf(*state));  // a refusal: nothing is written
  const Quality quality = measure(state->mesh);
  if (const Status written = writeAll(options, *state, quality, *seconds, events, files); !written.ok())
    return fail(written.error());
  if (state->failed) return fail(failureOf(*state));
  if (options.notices == Notices::shown) {
    summarise(*state, quality, std::accumulate(seconds->begin(), seconds->end(), 0.0));
    for (const std::string& path : paths) say("wrote {}\n", path);
  }
  return ExitCode::ok;
}

}  // namespace triscope
