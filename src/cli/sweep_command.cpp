// triscope sweep: step 6 for every pair of ω and θ, as CSV.
#include <fmt/format.h>

#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "core/debug/parameter_sweep.h"
#include "core/io/atomic_file.h"

namespace triscope {

ExitCode runCommand(const SweepCommand& options) {
  const Result<std::vector<double>> omegas = rangeFrom("omega", options.omega);
  if (!omegas.ok()) return fail(omegas.error());
  const Result<std::vector<double>> thetas = rangeFrom("theta", options.theta);
  if (!thetas.ok()) return fail(thetas.error());
  watchForInterrupt();
  Result<MeshState> state = beginFile(options.domain, options.settings, options.quiet);
  if (!state.ok()) return fail(state.error());
  std::optional<AtomicFile> file;
  if (!options.output.empty()) {
    Result<AtomicFile> created = AtomicFile::create(options.output);
    if (!created.ok()) return fail(created.error());
    file = std::move(*created);
  }
  if (const Result<StageSeconds> done = carryOn(*state, Stage::step5, nullptr, options.quiet); !done.ok())
    return fail(done.error());
  if (state->failed) return fail(failureOf(*state));

  ProgressLine progress(!options.quiet);
  const std::size_t pairs = omegas->size() * thetas->size();
  std::size_t done = 0;
  const auto tell = [&](std::size_t, const SweepRow&) {
    progress.show(fmt::format("step 6 for {} of {} pairs", ++done, pairs));
  };
  const std::vector<SweepRow> rows = sweep(*state, *omegas, *thetas, options.threads, tell, interruptFlag());
  progress.clear();
  if (interrupted())
    return fail({.code = ExitCode::cancelled, .message = "stopped by Ctrl+C", .hint = "nothing was written"});

  const std::string csv = csvOf(rows);
  if (!file) {
    std::fwrite(csv.data(), 1, csv.size(), stdout);
    return ExitCode::ok;
  }
  if (const Status written = file->write(csv); !written.ok()) return fail(written.error());
  if (const Status written = file->commit(); !written.ok()) return fail(written.error());
  if (!options.quiet) fmt::print(stderr, "wrote {}\n", options.output);
  return ExitCode::ok;
}

}  // namespace triscope
