// What the window knows of sweeps over ω and θ: what is asked for, and what has come of it.
#pragma once

#include <cstddef>
#include <optional>

#include "core/study/sweep_table.h"

namespace triscope {

/// Chosen by the user.
struct SweepChoice {
  SweepRange omega{0.05, 0.25, 5};
  SweepRange theta{5.0, 10.0, 6};  // degrees
  SweepFigure figure = SweepFigure::obtuse;
  friend bool operator==(const SweepChoice&, const SweepChoice&) = default;
};

/// Of one of the two ranges; one value where both ends are the same.
std::vector<double> sweptValues(SweepRange range);

struct SweepUi {
  SweepChoice choice;
  std::optional<SweepTable> table;    // of the last sweep that came to its end
  std::optional<SweepTable> making;   // of the one under way
  std::size_t done = 0;               // cells of it
  bool preparing = false;             // steps 1-5 are run for it first
  double seconds = 0.0;               // that the last one took
  std::optional<std::size_t> chosen;  // cell that the keys move; nothing: they are not the map's
  /// The one to show.
  [[nodiscard]] const std::optional<SweepTable>& shown() const { return making ? making : table; }
};

/// The cell of a pair, or the nearest one.
std::size_t nearestCell(const SweepTable& table, const Settings& settings);

}  // namespace triscope
