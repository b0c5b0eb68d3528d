// How long a session takes to answer, without its thread and without a window: triscope_session_bench [PRESET
// [DOMAIN]], standard and the ring of a million triangles unless told otherwise. Milliseconds of processor time. The
// viewer here keeps what a window keeps of a run: the snapshot and the events.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

#include "core/domain/read.h"
#include "core/run/event_log.h"
#include "core/session/session_work.h"
#include "core/words/preset.h"
#include "process_cost.h"
#include "ring.h"

namespace triscope::bench {
namespace {

double processorTime() { return 1e3 * processorSeconds(); }

double residentMiB() {
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

struct Viewer {
  SessionWork work;
  SnapshotPtr now;
  EventLog events;
  std::size_t told = 0;  // snapshots

  Viewer() {
    work.tell = [this](Publication news) {
      if (!news.snapshot) return;
      now = std::move(news.snapshot);
      events.truncate(static_cast<std::size_t>(news.keepEvents));
      events.append(news.freshEvents);
      ++told;
    };
    work.interrupted = [] { return false; };
    work.waits = [](const CommandTest&) { return false; };
  }

  /// Milliseconds until a command has been carried out.
  double time(const Command& command) {
    const double start = processorTime();
    obey(work, command);
    while (isUnderWay(work)) carrySlice(work);
    return processorTime() - start;
  }
};

void say(const char* what, double ms) {
  std::printf("%-44s %8.1f ms, %5.0f MiB\n", what, ms, residentMiB());
  std::fflush(stdout);
}

void say(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  std::printf("%-44s %8.1f ms, worst %8.1f ms, %5.0f MiB\n", what, times[times.size() / 2], times.back(),
              residentMiB());
  std::fflush(stdout);
}

std::vector<double> repeated(Viewer& viewer, const Command& command, int times) {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(times));
  for (int k = 0; k < times; ++k) all.push_back(viewer.time(command));
  return all;
}

int run(const Settings& settings, const Command& opens) {
  Viewer viewer;
  viewer.time(command::Change{settings});
  say("first mesh", viewer.time(opens));
  if (viewer.now == nullptr) return 1;
  const std::uint64_t end = viewer.now->state.tick;
  std::printf("%zu triangles, %zu decisions, %zu snapshots, %zu keyframes of %.0f MiB\n", viewer.now->quality.triangles,
              static_cast<std::size_t>(end), viewer.told, viewer.work.driver.run.history.count(),
              static_cast<double>(viewer.work.driver.run.history.bytes()) / 1048576.0);
  say("a step back from the end, the first", viewer.time(command::StepBack{}));
  say("a step back, the next", repeated(viewer, command::StepBack{}, 10));
  say("a step", repeated(viewer, command::Advance{}, 10));
  std::vector<double> seeks;
  std::vector<double> back;
  for (int k = 0; k < 16; ++k) {
    seeks.push_back(viewer.time(command::Seek{end * static_cast<std::uint64_t>(7 * k % 16 + 1) / 17}));
    back.push_back(viewer.time(command::StepBack{}));
  }
  say("to another place", seeks);
  say("a step back right there", back);
  say("a step back by insertion", repeated(viewer, command::StepBack{Grain::insertion}, 10));
  const double start = processorTime();
  while (traceLags(viewer.work)) carryTrace(viewer.work);
  say("the measures along the run", processorTime() - start);
  std::printf("peak %.0f MiB\n", static_cast<double>(peakBytes()) / 1048576.0);
  return 0;
}

}  // namespace
}  // namespace triscope::bench

int main(int argc, char** argv) {
  using namespace triscope;
  constexpr double kVertices = 540'000.0;
  Settings settings;
  if (const Status known = applyPreset(settings, argc > 1 ? argv[1] : "standard"); !known.ok()) {
    std::fprintf(stderr, "%s\n", describe(known.error()).c_str());
    return 2;
  }
  if (argc > 2) return bench::run(settings, command::OpenFile{argv[2]});
  return bench::run(settings, command::OpenDomain{bench::ring(bench::minEdgeFor(kVertices))});
}
