#include "timed_run.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/domain/read.h"
#include "process_cost.h"

namespace triscope::bench {
namespace {

// A counter of the whole process, open for good; -1 where there is none.
int missCounter() {
  perf_event_attr wanted{};
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.size = sizeof(wanted);
  wanted.config = PERF_COUNT_HW_CACHE_MISSES;
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  return static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, 0));
}

}  // namespace

std::optional<double> cacheMisses() {
  static const int counter = missCounter();
  std::uint64_t misses = 0;
  if (counter < 0 || read(counter, &misses, sizeof(misses)) != sizeof(misses)) return std::nullopt;
  return static_cast<double>(misses);
}

std::shared_ptr<const Domain> domainAt(const std::string& file) {
  Result<Domain> read = readDomain(file);
  if (!read.ok()) throw std::runtime_error(describe(read.error()));
  return std::make_shared<const Domain>(std::move(*read));
}

MeshState beginOrThrow(const std::shared_ptr<const Domain>& domain) {
  Settings settings;
  settings.optimise = false;
  Result<MeshState> state = begin(domain, settings);
  if (!state.ok()) throw std::runtime_error(describe(state.error()));
  return std::move(*state);
}

TimedRun runThrough(const std::shared_ptr<const Domain>& domain, Stage last, Journal& journal) {
  TimedRun run;
  const double start = processorSeconds();
  MeshState state = beginOrThrow(domain);
  double before = processorSeconds();
  std::optional<double> missed = cacheMisses();
  run.missesCounted = missed.has_value();
  while (state.stage <= last) {
    const auto stage = static_cast<std::size_t>(state.stage);
    advance(state, Grain::stage, journal);
    const double after = processorSeconds();
    run.seconds[stage] += after - before;
    before = after;
    if (!run.missesCounted) continue;
    const std::optional<double> now = cacheMisses();
    run.misses[stage] += *now - *missed;
    missed = now;
  }
  if (state.failed) throw std::runtime_error("the method could not go on");
  run.total = before - start;
  for (const Slot triangle : state.mesh.vertexTriangle) run.vertices += triangle.exists() ? 1u : 0u;
  run.triangles = state.mesh.liveCount();
  return run;
}

void countStages(benchmark::State& bench, const TimedRun& run) {
  for (const StageInfo& info : stages()) {
    if (info.id == Stage::finished) continue;
    const auto stage = static_cast<std::size_t>(info.id);
    bench.counters[std::string(info.key)] = run.seconds[stage];
    if (run.missesCounted) bench.counters[std::string(info.key) + "_misses"] = run.misses[stage];
  }
}

}  // namespace triscope::bench
