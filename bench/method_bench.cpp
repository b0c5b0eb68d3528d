// The whole method and each of its stages against the number of points.
#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <array>
#include <ctime>
#include <stdexcept>
#include <string>

#include "core/domain/read.h"
#include "core/history/event_log.h"
#include "core/history/history.h"
#include "core/pipeline.h"
#include "core/run_record.h"
#include "ring.h"

namespace triscope::bench {
namespace {

/// Seconds of processor time: unlike those on the wall, they do not count what other work takes.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Run {
  std::array<double, kStageCount> seconds{};  // per stage, all rounds together
  double total = 0.0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
};

MeshState beginOrThrow(const std::shared_ptr<const Domain>& domain, const Settings& settings) {
  Result<MeshState> state = begin(domain, settings);
  if (!state.ok()) throw std::runtime_error(describe(state.error()));
  return std::move(*state);
}

/// Steps 1-5 and the repair after them to their end, each stage timed.
Run runRounds(const std::shared_ptr<const Domain>& domain, Journal& journal) {
  Run run;
  const double start = processorSeconds();
  MeshState state = beginOrThrow(domain, Settings{});
  double before = processorSeconds();
  while (state.stage < Stage::refine) {
    const Stage stage = state.stage;
    advance(state, Grain::stage, journal);
    const double after = processorSeconds();
    run.seconds[static_cast<std::size_t>(stage)] += after - before;
    before = after;
  }
  if (state.failed) throw std::runtime_error("the method could not go on");
  run.total = before - start;
  for (const std::int32_t triangle : state.mesh.vertexTriangle) run.vertices += triangle >= 0 ? 1 : 0;
  run.triangles = state.mesh.liveCount();
  return run;
}

/// Repeats a run and reports the fastest, as the one least disturbed by other work: its seconds, and its size.
template <class MakeRun>
Run fastest(benchmark::State& bench, MakeRun makeRun) {
  Run best;
  for (auto _ : bench) {
    const Run run = makeRun();
    bench.SetIterationTime(run.total);
    if (best.triangles == 0 || run.total < best.total) best = run;
  }
  bench.counters["seconds"] = best.total;
  bench.counters["vertices"] = static_cast<double>(best.vertices);
  bench.counters["triangles"] = static_cast<double>(best.triangles);
  return best;
}

/// Argument: vertices wanted. Counters: the seconds of each stage, by its key.
void ringStages(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(static_cast<double>(bench.range(0))));
  Journal nobody;
  const Run best = fastest(bench, [&] { return runRounds(domain, nobody); });
  for (const StageInfo& info : stages())
    if (info.id < Stage::refine)
      bench.counters[std::string(info.key)] = best.seconds[static_cast<std::size_t>(info.id)];
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
    ->MinTime(4.0)
    ->Unit(benchmark::kMillisecond);

/// Argument: 0 without a listener, 1 with a journal that keeps every event.
void ringJournal(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(15000));
  std::vector<Event> events;
  Journal journal;
  if (bench.range(0) != 0) journal.events = &events;
  fastest(bench, [&] {
    events = {};
    return runRounds(domain, journal);
  });
  bench.counters["events"] = static_cast<double>(events.size());
}
BENCHMARK(ringJournal)->Arg(0)->Arg(1)->UseManualTime()->MinTime(3.0)->Unit(benchmark::kMillisecond);

/// Reading the file, and the method without step 6.
void threeElementAirfoil(benchmark::State& bench) {
  Journal nobody;
  fastest(bench, [&] {
    const double start = processorSeconds();
    Result<Domain> read = readDomain(TRISCOPE_SOURCE_DIR "/assets/domains/three_element_airfoil.json");
    if (!read.ok()) throw std::runtime_error(describe(read.error()));
    const double reading = processorSeconds() - start;
    Run run = runRounds(std::make_shared<const Domain>(std::move(*read)), nobody);
    run.total += reading;
    return run;
  });
}
BENCHMARK(threeElementAirfoil)->UseManualTime()->MinTime(3.0)->Unit(benchmark::kMillisecond);

/// What the window adds to a run, all stages: argument 0 nothing, 1 every event, 2 the recorder and keyframes as well,
/// one decision at a time.
void airfoilHistory(benchmark::State& bench) {
  Result<Domain> read = readDomain(TRISCOPE_SOURCE_DIR "/assets/domains/three_element_airfoil.json");
  if (!read.ok()) throw std::runtime_error(describe(read.error()));
  const auto domain = std::make_shared<const Domain>(std::move(*read));
  std::vector<Event> all;
  EventLog log;
  std::vector<Event> beat;
  std::size_t events = 0, eventBytes = 0, keyframes = 0, keyframeBytes = 0, inserted = 0;
  fastest(bench, [&] {
    all = {};
    log = {};
    Run run;
    const double start = processorSeconds();
    MeshState state = beginOrThrow(domain, Settings{});
    if (bench.range(0) < 2) {
      Journal journal;
      if (bench.range(0) == 1) journal.events = &all;
      advance(state, Grain::all, journal);
      events = all.size();
      eventBytes = all.size() * sizeof(Event);
    } else {
      Journal journal{&beat};
      RunRecorder recorder;
      History history;
      history.restart(state);
      while (state.stage != Stage::finished) {
        beat.clear();
        const std::uint64_t tick = state.tick;
        const std::size_t points = state.mesh.points.size();
        advanceUntil(state, state.stage, 1, journal);
        log.append(beat);
        recorder.follow(state, {tick, points, beat, log.size()});
        if (state.tick != tick) history.offer(state, log.size());
      }
      events = log.size();
      eventBytes = log.bytes() + recorder.bytes();
      keyframes = history.count();
      keyframeBytes = history.bytes();
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
BENCHMARK(airfoilHistory)->Arg(0)->Arg(1)->Arg(2)->UseManualTime()->MinTime(3.0)->Unit(benchmark::kMillisecond);

std::int64_t peakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

/// Peak memory of one run; only the first run of a process tells, so ask for this one alone.
void ringMemory(benchmark::State& bench) {
  const auto domain = ring(minEdgeFor(static_cast<double>(bench.range(0))));
  Journal nobody;
  const std::int64_t before = peakBytes();
  const Run run = fastest(bench, [&] { return runRounds(domain, nobody); });
  bench.counters["bytes_per_triangle"] = static_cast<double>(peakBytes() - before) / static_cast<double>(run.triangles);
}
BENCHMARK(ringMemory)->Arg(500000)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace triscope::bench
