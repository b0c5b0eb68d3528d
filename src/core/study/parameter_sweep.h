// Step 6 for every pair of ω and θ: steps 1-5 run once, every pair is carried on from a copy of their state.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/method/state.h"
#include "core/quality/quality.h"

namespace triscope {

/// Values of a parameter, evenly spaced and both ends among them; just `from` when there is one.
struct SweepRange {
  double from = 0.0;
  double to = 0.0;
  int count = 1;
  friend bool operator==(const SweepRange&, const SweepRange&) = default;
};
std::vector<double> valuesOf(const SweepRange& range);

struct SweepRow {
  double omega = 0.0;
  double theta = 0.0;  // degrees
  Quality quality;
  std::uint64_t moved = 0;    // vertices moved by step 6
  std::uint64_t refused = 0;  // moves refused
};

/// "0.05:0.25:5" as 0.05, 0.10, …, 0.25; a single number as itself. Errors (usage) name `key`, a setting, whose range
/// holds for every value.
Result<std::vector<double>> rangeFrom(std::string_view key, std::string_view text);

/// An error (usage) where nothing of step 6 is on, as with the preset best: ω and θ would change nothing.
Status canSweep(const Settings& settings);

/// Whether a run that is carried on from this state with these settings is a whole run with them: step 6 has not begun,
/// and no setting differs that could have mattered to what has been done.
bool precedesRefinement(const MeshState& state, const Settings& settings);

/// One row for each pair, ω by ω, in the order given whatever the number of threads (0: one for each core). `start` is
/// a state that steps 1-5 are over in and step 6 has not begun. `done` is called with each row and its number as soon
/// as it is there, in any order, from this thread. Empty when `cancel` became true, which is looked at every few
/// decisions. What a thread throws, such as std::bad_alloc, is thrown here.
std::vector<SweepRow> sweep(const MeshState& start, const std::vector<double>& omegas,
                            const std::vector<double>& thetas, unsigned threads,
                            const std::function<void(std::size_t, const SweepRow&)>& done,
                            const std::atomic<bool>& cancel);

/// As CSV, with a line of column names.
std::string csvOf(const std::vector<SweepRow>& rows);

}  // namespace triscope
