#include "core/study/parameter_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <iterator>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "core/base/json_text.h"
#include "core/method/pipeline.h"
#include "core/run/history.h"

namespace triscope {
namespace {

constexpr double kMostValues = 1000.0;

bool readNumber(std::string_view text, double& value) {
  const char* const last = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), last, value);
  return failure == std::errc{} && stop == last && std::isfinite(value);
}

/// The number that a person would type for it, so that a row can be run again: 0.15, not 0.15000000000000002.
double asTyped(double value) {
  readNumber(fmt::format("{:.12g}", value), value);
  return value;
}

Error noRange(std::string_view key, std::string_view text) {
  return {.kind = ErrorKind::usage,
          .message = fmt::format("'{}' is no range for {}", text, key),
          .hint = fmt::format("give FROM:TO:COUNT with COUNT from 1 to {}, such as 0.05:0.25:5, or one number",
                              kMostValues)};
}

/// Nothing when it was cancelled.
std::optional<SweepRow> carryOut(MeshState state, double omega, double theta, const std::atomic<bool>& cancel) {
  state.settings.omega = omega;
  state.settings.theta = theta;
  if (!advanceUntil(state, Stage::refine, cancel)) return std::nullopt;
  const StageCounts& counts = state.counts[Stage::refine];
  return SweepRow{omega, theta, measure(state.mesh), counts.moved, counts.refused};
}

}  // namespace

std::vector<double> valuesOf(const SweepRange& range) {
  if (range.count <= 1) return {range.from};
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(range.count));
  const double last = range.count - 1;
  for (int k = 0; k < range.count; ++k) values.push_back(asTyped(((last - k) * range.from + k * range.to) / last));
  return values;
}

Result<std::vector<double>> rangeFrom(std::string_view key, std::string_view text) {
  double from = 0.0;
  double to = 0.0;
  double count = 1.0;
  const std::size_t first = text.find(':');
  if (first == std::string_view::npos) {
    if (!readNumber(text, from)) return noRange(key, text);
    to = from;
  } else {
    const std::size_t second = text.find(':', first + 1);
    if (second == std::string_view::npos || !readNumber(text.substr(0, first), from) ||
        !readNumber(text.substr(first + 1, second - first - 1), to) || !readNumber(text.substr(second + 1), count))
      return noRange(key, text);
  }
  if (count < 1.0 || count > kMostValues || count != std::floor(count)) return noRange(key, text);
  const SettingInfo* const info = findSetting(key);
  std::vector<double> values = valuesOf({from, to, static_cast<int>(count)});
  for (const double value : values) {
    Settings settings;
    if (const Status status = setSetting(settings, *info, value); !status.ok()) return status.error();
  }
  return values;
}

Status canSweep(const Settings& settings) {
  if (infoOf(Stage::refine).wanted(settings)) return success();
  return Error{.kind = ErrorKind::usage,
               .message = "all of step 6 is off, so omega and theta change nothing",
               .hint = "turn laplacian or reduce_obtuse on"};
}

bool precedesRefinement(const MeshState& state, const Settings& settings) {
  return !hasComeTo(state, Stage::refine) && firstAffected(state.settings, settings) >= Stage::refine;
}

std::vector<SweepRow> sweep(const MeshState& start, const std::vector<double>& omegas,
                            const std::vector<double>& thetas, unsigned threads,
                            const std::function<void(std::size_t, const SweepRow&)>& done,
                            const std::atomic<bool>& cancel) {
  std::vector<SweepRow> rows(omegas.size() * thetas.size());
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min<std::size_t>(threads, rows.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::size_t> finished;  // rows, in the order they came; under the mutex, as is the next
  std::size_t working = workers;
  std::exception_ptr failure;  // under the mutex too: an exception must not leave a thread
  const auto runPairs = [&] {
    for (std::size_t k = next++; k < rows.size(); k = next++) {
      const std::optional<SweepRow> row = carryOut(start, omegas[k / thetas.size()], thetas[k % thetas.size()], cancel);
      if (!row) break;
      rows[k] = *row;
      const std::lock_guard lock(mutex);
      finished.push_back(k);
      changed.notify_one();
    }
  };
  const auto work = [&] {
    std::exception_ptr thrown;
    try {
      runPairs();
    } catch (...) {
      thrown = std::current_exception();
      next = rows.size();  // the others end too
    }
    const std::lock_guard lock(mutex);
    if (thrown) failure = thrown;
    --working;
    changed.notify_one();
  };
  std::vector<std::thread> pool;
  pool.reserve(workers);
  for (std::size_t k = 0; k < workers; ++k) {
    try {
      pool.emplace_back(work);
    } catch (const std::system_error&) {  // no more threads to be had: as many as there are do the work
      const std::lock_guard lock(mutex);
      working -= workers - k;
      break;
    }
  }
  if (pool.empty()) {
    working = 1;
    work();
  }
  for (std::size_t told = 0;; ++told) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return finished.size() > told || working == 0; });
    if (finished.size() == told) break;
    const std::size_t row = finished[told];
    lock.unlock();
    if (done) done(row, rows[row]);
  }
  for (std::thread& thread : pool) thread.join();
  if (failure) std::rethrow_exception(failure);
  if (cancel) rows.clear();
  return rows;
}

std::string csvOf(const std::vector<SweepRow>& rows) {
  std::string text =
      "omega,theta_deg,triangles,vertices,aspect_ratio_max,aspect_ratio_mean,area_ratio_max,edge_ratio_max,"
      "min_angle_deg,max_angle_deg,obtuse,bounds_met,moved,refused\n";
  for (const SweepRow& row : rows) {
    const Quality& q = row.quality;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", jsonNumber(row.omega),
                   jsonNumber(row.theta), q.triangles, q.vertices, jsonNumber(q.aspectMax), jsonNumber(q.aspectMean),
                   jsonNumber(q.areaRatioMax), jsonNumber(q.edgeRatioMax), jsonNumber(q.minAngle),
                   jsonNumber(q.maxAngle), q.obtuse, q.withinBounds() ? 1 : 0, row.moved, row.refused);
  }
  return text;
}

}  // namespace triscope
