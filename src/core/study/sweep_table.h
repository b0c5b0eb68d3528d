// A sweep over ω and θ as a table that people choose from: which pair is best, and whether it still holds.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/study/parameter_sweep.h"

namespace triscope {

/// What the finished meshes of a sweep can be judged by.
enum class SweepFigure : std::uint8_t { obtuse, aspect, area_ratio, edge_ratio, min_angle, max_angle };
inline constexpr int kSweepFigureCount = static_cast<int>(SweepFigure::max_angle) + 1;

struct SweepFigureInfo {
  std::string_view name;
  std::string_view unit;  // "", "deg"
  bool largeIsBetter;     // else the smaller value is the better one
  double (*value)(const Quality&);
};
const SweepFigureInfo& infoOf(SweepFigure figure);

/// The pairs of a sweep as cells, ω by ω: that of omegas[i] and thetas[j] is cell i · thetas.size() + j.
struct SweepTable {
  std::shared_ptr<const Domain> domain;
  Settings settings;  // of every run, ω and θ apart
  std::vector<double> omegas;
  std::vector<double> thetas;                  // degrees
  std::vector<std::optional<SweepRow>> cells;  // nothing: not run yet
};

/// A table with no cell run yet.
SweepTable tableOf(std::shared_ptr<const Domain> domain, const Settings& settings, std::vector<double> omegas,
                   std::vector<double> thetas);
/// Whether runs on this domain with these settings, ω and θ apart, are what the table is about.
bool holdsFor(const SweepTable& table, const std::shared_ptr<const Domain>& domain, const Settings& settings);
/// Those of its cells that have been run, as `triscope sweep` has them.
std::vector<SweepRow> rowsOf(const SweepTable& table);
/// The cell with the best figure; of equal ones that with fewer obtuse triangles, then the smaller worst aspect ratio,
/// then the first. Nothing while no cell has been run.
std::optional<std::size_t> bestOf(const SweepTable& table, SweepFigure figure);
/// The least and the largest value of a figure among the cells that have been run; nothing while none has.
struct SweepSpan {
  double low;
  double high;
};
std::optional<SweepSpan> spanOf(const SweepTable& table, SweepFigure figure);

/// Where a value lies among ascending ones: 1.5 is halfway from the second to the third. Nothing outside of them.
std::optional<double> placeAmong(const std::vector<double>& values, double value);

/// The most values of one parameter in a table.
inline constexpr int kMostSweepValues = 40;
/// A range that one of its ends was just changed in, with both within the setting's own range, not crossed (the end
/// that stayed gives way), and 1 to kMostSweepValues values.
SweepRange kept(SweepRange range, const SweepRange& before, const SettingInfo& setting);

}  // namespace triscope
