// The whole method and each of its stages against the number of points.
#include "core/domain/read.h"
#include "core/run/driver.h"
#include "core/run/event_log.h"
#include "process_cost.h"
#include "ring.h"
#include "timed_run.h"

namespace triscope::bench {
namespace {

/// Argument: vertices wanted. Counters: the seconds of each stage, by its key.
void ringStages(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(static_cast<double>(bench.range(0))));
  Journal nobody;
  countStages(bench, fastest(bench, [&] { return runThrough(domain, Stage::refine, nobody); }));
}
BENCHMARK(ringStages)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000)
    ->Arg(15000)
    ->Arg(30000)
    ->Arg(100000)
    ->Arg(300000)
    ->Arg(540000)
    ->Arg(1000000)
    ->UseManualTime()
    ->MinTime(1.0)
    ->Unit(benchmark::kMillisecond);

/// Argument: 0 without a listener, 1 with a journal that keeps every event.
void ringJournal(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(15000));
  std::vector<Event> events;
  Journal journal;
  if (bench.range(0) != 0) journal.events = &events;
  fastest(bench, [&] {
    events = {};
    return runThrough(domain, Stage::repair, journal);
  });
  bench.counters["events"] = static_cast<double>(events.size());
}
BENCHMARK(ringJournal)->Arg(0)->Arg(1)->UseManualTime()->MinTime(1.0)->Unit(benchmark::kMillisecond);

/// Reading the file, and the method without step 6.
void threeElementAirfoil(benchmark::State& bench) {
  Journal nobody;
  fastest(bench, [&] {
    const double start = processorSeconds();
    Result<Domain> read = readDomain(TRISCOPE_SOURCE_DIR "/assets/domains/three_element_airfoil.json");
    if (!read.ok()) throw std::runtime_error(describe(read.error()));
    const double reading = processorSeconds() - start;
    TimedRun run = runThrough(std::make_shared<const Domain>(std::move(*read)), Stage::repair, nobody);
    run.total += reading;
    return run;
  });
}
BENCHMARK(threeElementAirfoil)->UseManualTime()->MinTime(1.0)->Unit(benchmark::kMillisecond);

/// What the window adds to a run, all stages: argument 0 nothing, 1 every event, 2 the recorder and keyframes as well,
/// one decision at a time.
void airfoilHistory(benchmark::State& bench) {
  constexpr std::uint64_t kBeatsPerSlice = 4096;
  const auto domain = domainAt(TRISCOPE_SOURCE_DIR "/assets/domains/three_element_airfoil.json");
  std::vector<Event> all;
  EventLog log;
  std::vector<Event> fresh;
  std::size_t events = 0, eventBytes = 0, keyframes = 0, keyframeBytes = 0, inserted = 0;
  fastest(bench, [&] {
    all = {};
    log = {};
    TimedRun run;
    const double start = processorSeconds();
    MeshState state = beginOrThrow(domain);
    if (bench.range(0) < 2) {
      Journal journal;
      if (bench.range(0) == 1) journal.events = &all;
      advance(state, Grain::all, journal);
      events = all.size();
      eventBytes = all.size() * sizeof(Event);
    } else {
      Driver driver;
      driver.run = runFrom(std::move(state));
      headFor(driver, {.kind = Goal::Kind::end});
      while (!isThere(driver)) {
        fresh.clear();
        carryOn(driver, kBeatsPerSlice, {}, fresh);
        log.append(fresh);
      }
      events = log.size();
      eventBytes = log.bytes() + driver.run.recorder.bytes();
      keyframes = driver.run.history.count();
      keyframeBytes = driver.run.history.bytes();
      state = std::move(driver.run.state);
    }
    run.total = processorSeconds() - start;
    run.triangles = state.mesh.liveCount();
    inserted = state.mesh.points.size();
    return run;
  });
  bench.counters["events"] = static_cast<double>(events);
  bench.counters["event_bytes"] = static_cast<double>(eventBytes);
  bench.counters["inserted"] = static_cast<double>(inserted);
  bench.counters["keyframes"] = static_cast<double>(keyframes);
  bench.counters["keyframe_bytes"] = static_cast<double>(keyframeBytes);
}
BENCHMARK(airfoilHistory)->Arg(0)->Arg(1)->Arg(2)->UseManualTime()->MinTime(1.0)->Unit(benchmark::kMillisecond);

/// Peak memory of one run; only the first run of a process tells, so ask for this one alone.
void ringMemory(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(static_cast<double>(bench.range(0))));
  Journal nobody;
  const std::int64_t before = peakBytes();
  const TimedRun run = fastest(bench, [&] { return runThrough(domain, Stage::repair, nobody); });
  bench.counters["bytes_per_triangle"] = static_cast<double>(peakBytes() - before) / static_cast<double>(run.triangles);
}
BENCHMARK(ringMemory)->Arg(500000)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

/// A domain of the tests through all stages. Counters as in ringStages.
void realDomain(benchmark::State& bench, const char* name) {
  const auto domain = domainAt(std::string(TRISCOPE_SOURCE_DIR "/tests/data/domains/") + name + ".json");
  Journal nobody;
  countStages(bench, fastest(bench, [&] { return runThrough(domain, Stage::refine, nobody); }));
}
BENCHMARK_CAPTURE(realDomain, koch5, "koch5")->UseManualTime()->MinTime(1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(realDomain, perforated_plate, "perforated_plate")
    ->UseManualTime()
    ->MinTime(1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(realDomain, great_britain, "great_britain")
    ->UseManualTime()
    ->MinTime(1.0)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace triscope::bench
