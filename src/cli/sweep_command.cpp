// triscope sweep: step 6 for every pair of ω and θ, as CSV.
#include <fmt/format.h>

#include <atomic>

#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/progress_line.h"
#include "core/base/output_set.h"
#include "core/study/parameter_sweep.h"

namespace triscope {

ExitCode runCommand(const SweepCommand& options) {
  const Result<std::vector<double>> omegas = rangeFrom("omega", options.omega);
  if (!omegas.ok()) return fail(omegas.error());
  const Result<std::vector<double>> thetas = rangeFrom("theta", options.theta);
  if (!thetas.ok()) return fail(thetas.error());
  if (const Status sensible = canSweep(options.settings); !sensible.ok()) return fail(sensible.error());
  Result<MeshState> state = beginFile(options.domain, options.settings, options.notices);
  if (!state.ok()) return fail(state.error());
  OutputSet files;
  if (!options.output.empty()) {
    if (const Result<AtomicFile*> file = files.open(options.output); !file.ok()) return fail(file.error());
  }
  if (const Result<StageSeconds> done = carryOn(*state, Stage::step5, nullptr, options.notices); !done.ok())
    return fail(done.error());
  if (state->failed) return fail(failureOf(*state));

  ProgressLine progress(options.notices);
  const std::size_t pairs = omegas->size() * thetas->size();
  std::size_t done = 0;
  const auto tell = [&](std::size_t, const SweepRow&) {
    progress.show(fmt::format("step 6 for {} of {} pairs", ++done, pairs));
  };
  const std::atomic<bool> never{false};  // a signal ends the program by itself
  const std::vector<SweepRow> rows = sweep(*state, *omegas, *thetas, options.threads, tell, never);
  progress.clear();

  const std::string csv = csvOf(rows);
  if (options.output.empty()) {
    answerText(csv);
    return ExitCode::ok;
  }
  if (const Status written = files.write(options.output, csv); !written.ok()) return fail(written.error());
  if (const Status written = files.commit(); !written.ok()) return fail(written.error());
  if (options.notices == Notices::shown) say("wrote {}\n", options.output);
  return ExitCode::ok;
}

}  // namespace triscope
