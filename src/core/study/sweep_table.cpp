#include "core/study/sweep_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace triscope {
namespace {

constexpr double kSame = 1e-9;  // of the distance between two values: closer is the same value

constexpr std::array<SweepFigureInfo, kSweepFigureCount> kFigures{{
    {"obtuse triangles", "", false, [](const Quality& q) { return static_cast<double>(q.obtuse); }},
    {"worst aspect ratio", "", false, [](const Quality& q) { return q.aspectMax; }},
    {"worst area ratio", "", false, [](const Quality& q) { return q.areaRatioMax; }},
    {"worst edge ratio", "", false, [](const Quality& q) { return q.edgeRatioMax; }},
    {"smallest angle", "deg", true, [](const Quality& q) { return q.minAngle; }},
    {"largest angle", "deg", false, [](const Quality& q) { return q.maxAngle; }},
}};

/// Less is better.
auto rankOf(const Quality& quality, SweepFigure figure) {
  const SweepFigureInfo& info = infoOf(figure);
  const double value = info.value(quality);
  return std::tuple(info.largeIsBetter ? -value : value, quality.obtuse, quality.aspectMax);
}

}  // namespace

const SweepFigureInfo& infoOf(SweepFigure figure) { return kFigures[static_cast<std::size_t>(figure)]; }

SweepTable tableOf(std::shared_ptr<const Domain> domain, const Settings& settings, std::vector<double> omegas,
                   std::vector<double> thetas) {
  SweepTable table{std::move(domain), settings, std::move(omegas), std::move(thetas), {}};
  table.cells.resize(table.omegas.size() * table.thetas.size());
  return table;
}

bool holdsFor(const SweepTable& table, const std::shared_ptr<const Domain>& domain, const Settings& settings) {
  Settings swept = settings;
  swept.omega = table.settings.omega;
  swept.theta = table.settings.theta;
  if (swept != table.settings || domain == nullptr) return false;
  // Read again, a file that has not changed is another object.
  return domain == table.domain || (!domain->text.empty() && domain->text == table.domain->text);
}

std::vector<SweepRow> rowsOf(const SweepTable& table) {
  std::vector<SweepRow> rows;
  for (const std::optional<SweepRow>& cell : table.cells)
    if (cell) rows.push_back(*cell);
  return rows;
}

std::optional<std::size_t> bestOf(const SweepTable& table, SweepFigure figure) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < table.cells.size(); ++k) {
    if (!table.cells[k]) continue;
    if (!best || rankOf(table.cells[k]->quality, figure) < rankOf(table.cells[*best]->quality, figure)) best = k;
  }
  return best;
}

std::optional<SweepSpan> spanOf(const SweepTable& table, SweepFigure figure) {
  std::optional<SweepSpan> span;
  for (const std::optional<SweepRow>& cell : table.cells) {
    if (!cell) continue;
    const double value = infoOf(figure).value(cell->quality);
    if (!span) span = SweepSpan{value, value};
    span->low = std::min(span->low, value);
    span->high = std::max(span->high, value);
  }
  return span;
}

std::optional<double> placeAmong(const std::vector<double>& values, double value) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::fabs(values[k] - value) <= kSame * std::max(1.0, std::fabs(value))) return static_cast<double>(k);
  const auto above = std::upper_bound(values.begin(), values.end(), value);
  if (above == values.begin() || above == values.end()) return std::nullopt;
  const double low = *(above - 1);
  return static_cast<double>(above - 1 - values.begin()) + (value - low) / (*above - low);
}

SweepRange kept(SweepRange range, const SweepRange& before, const SettingInfo& setting) {
  range.from = std::clamp(range.from, setting.lowest, setting.highest);
  range.to = std::clamp(range.to, setting.lowest, setting.highest);
  range.count = std::clamp(range.count, 1, kMostSweepValues);
  if (range.from > range.to && range.from != before.from) range.to = range.from;
  range.from = std::min(range.from, range.to);
  return range;
}

}  // namespace triscope
