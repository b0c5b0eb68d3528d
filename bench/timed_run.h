// A run of the method with the seconds, and where the machine counts them the cache misses, of each stage.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/method/pipeline.h"

namespace triscope::bench {

/// Misses of the last-level cache by this process so far; none where the machine or its settings do not count them.
std::optional<double> cacheMisses();

struct TimedRun {
  std::array<double, kStageCount> seconds{};  // per stage, all rounds together
  std::array<double, kStageCount> misses{};   // of the last-level cache
  bool missesCounted = false;
  double total = 0.0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

std::shared_ptr<const Domain> domainAt(const std::string& file);
MeshState beginOrThrow(const std::shared_ptr<const Domain>& domain);

/// The method until `last` is over for good, each stage timed.
TimedRun runThrough(const std::shared_ptr<const Domain>& domain, Stage last, Journal& journal);

/// Counters: the seconds of each stage by its key, and its misses by "key_misses" where they are counted.
void countStages(benchmark::State& bench, const TimedRun& run);

/// Repeats a run and reports the fastest, as the one least disturbed by other work: its seconds, and its size.
template <class MakeRun>
TimedRun fastest(benchmark::State& bench, MakeRun makeRun) {
  TimedRun best;
  for (auto _ : bench) {
    const TimedRun run = makeRun();
    bench.SetIterationTime(run.total);
    if (best.triangles == 0 || run.total < best.total) best = run;
  }
  bench.counters["seconds"] = best.total;
  bench.counters["vertices"] = static_cast<double>(best.vertices);
  bench.counters["triangles"] = static_cast<double>(best.triangles);
  return best;
}

}  // namespace triscope::bench
