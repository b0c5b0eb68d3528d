// Two runs side by side: where they part, how their settings and their meshes differ, and which place in one stands
// for a place in the other.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/quality/quality.h"
#include "core/run/event_log.h"
#include "core/run/run_record.h"
#include "core/words/settings.h"

namespace triscope {

/// Number of the first event that differs, also where only one run has it; nothing for runs that are the same.
std::optional<std::size_t> firstDifference(const EventLog& a, const EventLog& b);

struct SettingDifference {
  const SettingInfo* setting = nullptr;
  double a = 0.0;
  double b = 0.0;
};
/// In the order of the table.
std::vector<SettingDifference> differences(const Settings& a, const Settings& b);
/// "ω = 0.05, smallest edge = auto": the values of one side, each after the setting's name and `is`; "" of none.
std::string differencesText(std::span<const SettingDifference> list, double SettingDifference::* side,
                            std::string_view is = "=");

/// A figure of both meshes. `better` says which is better: 'a', 'b', or ' ' when equal or a matter of taste.
struct FigurePair {
  std::string_view name;
  std::string_view unit;  // "", "deg"
  double a = 0.0;
  double b = 0.0;
  char better = ' ';
};
std::vector<FigurePair> figurePairs(const Quality& a, const Quality& b);

/// A place in a run.
struct RunPlace {
  Stage stage = Stage::constraints;
  std::uint64_t tick = 0;    // decisions made
  std::uint64_t events = 0;  // recorded up to there
};
struct Counterpart {
  std::uint64_t tick = 0;
  std::optional<Stage> begins;  // the place is where this stage begins for the first time; finished: the run's end
  friend bool operator==(const Counterpart&, const Counterpart&) = default;
};
/// What stands for `place` of the run `from` in the run `to`, which is known to its end: as long as no event has
/// differed (`first` is the number of the first that does), and right after it, the same number of decisions; later the
/// same stage and round, as far through it; or the end of the round before where `to` had fewer.
Counterpart counterpart(const RunPlace& place, const RunRecord& from, const RunRecord& to,
                        const std::optional<std::size_t>& first);

}  // namespace triscope
