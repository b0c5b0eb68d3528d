#include "core/study/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace triscope {
namespace {

/// Order in which a run comes to its stages: steps 2 to 5 and their repair once a round.
auto placeInRun(const StageEntry& entry) {
  const bool again = inRounds(entry.stage);
  const int part = entry.stage < Stage::step2 ? 0 : again ? 1 : 2;
  return std::tuple(part, again ? entry.round : std::uint16_t{0}, entry.stage);
}

std::uint64_t endOf(const RunRecord& run, const StageEntry* entry) {
  const bool last = entry + 1 == run.stages.data() + run.stages.size();
  return last ? run.ticks : entry[1].tick;
}

/// The entry that a place lies in: where a stage that made no decision ends another begins at the same tick.
const StageEntry* entryOf(const RunRecord& run, const RunPlace& place) {
  const StageEntry* const last = entryAt(run, place.tick);
  for (const StageEntry* entry = last; entry != nullptr && entry >= run.stages.data(); --entry) {
    if (endOf(run, entry) < place.tick) break;
    if (entry->stage == place.stage) return entry;
  }
  return last;
}

}  // namespace

std::optional<std::size_t> firstDifference(const EventLog& a, const EventLog& b) {
  const std::size_t alike = commonLength(a, b);
  if (alike == a.size() && alike == b.size()) return std::nullopt;
  return alike;
}

std::vector<SettingDifference> differences(const Settings& a, const Settings& b) {
  std::vector<SettingDifference> list;
  for (const SettingInfo& info : settingTable()) {
    const double x = settingValue(a, info);
    const double y = settingValue(b, info);
    if (x != y) list.push_back({&info, x, y});
  }
  return list;
}

std::string differencesText(std::span<const SettingDifference> list, double SettingDifference::* side,
                            std::string_view is) {
  std::string text;
  for (const SettingDifference& d : list)
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", settingName(*d.setting), is,
                        settingText(*d.setting, d.*side));
  return text;
}

std::vector<FigurePair> figurePairs(const Quality& a, const Quality& b) {
  enum class Wish : std::uint8_t { none, small, large };
  struct Figure {
    std::string_view name;
    std::string_view unit;
    Wish wish;
    double (*value)(const Quality&);
  };
  constexpr std::array<Figure, 9> kFigures{{
      {"vertices", "", Wish::none, [](const Quality& q) { return static_cast<double>(q.vertices); }},
      {"triangles", "", Wish::none, [](const Quality& q) { return static_cast<double>(q.triangles); }},
      {"obtuse triangles", "", Wish::small, [](const Quality& q) { return static_cast<double>(q.obtuse); }},
      {"worst aspect ratio", "", Wish::small, [](const Quality& q) { return q.aspectMax; }},
      {"mean aspect ratio", "", Wish::small, [](const Quality& q) { return q.aspectMean; }},
      {"worst area ratio", "", Wish::small, [](const Quality& q) { return q.areaRatioMax; }},
      {"worst edge ratio", "", Wish::small, [](const Quality& q) { return q.edgeRatioMax; }},
      {"smallest angle", "deg", Wish::large, [](const Quality& q) { return q.minAngle; }},
      {"largest angle", "deg", Wish::small, [](const Quality& q) { return q.maxAngle; }},
  }};
  std::vector<FigurePair> list;
  for (const Figure& figure : kFigures) {
    const double x = figure.value(a);
    const double y = figure.value(b);
    // What differs less than anybody sees is not better.
    const bool judged = figure.wish != Wish::none && std::fabs(x - y) > 1e-4 * std::max(std::fabs(x), std::fabs(y));
    list.push_back({figure.name, figure.unit, x, y,
                    !judged                                   ? ' '
                    : (x < y) == (figure.wish == Wish::small) ? 'a'
                                                              : 'b'});
  }
  return list;
}

Counterpart counterpart(const RunPlace& place, const RunRecord& from, const RunRecord& to,
                        const std::optional<std::size_t>& first) {
  const StageEntry* const here = entryOf(from, place);
  if (here == nullptr || to.stages.empty()) return {std::min(place.tick, to.ticks), {}};
  const bool begins = place.tick == here->tick && place.stage == here->stage && here == firstEntry(from, here->stage);
  const std::optional<Stage> stage = begins ? std::optional(here->stage) : std::nullopt;
  if (place.stage == Stage::finished) return {to.ticks, Stage::finished};
  if (!first || place.events <= *first + 1) return {std::min(place.tick, to.ticks), stage};
  const auto after =
      std::upper_bound(to.stages.begin(), to.stages.end(), placeInRun(*here),
                       [](const auto& wanted, const StageEntry& entry) { return wanted < placeInRun(entry); });
  if (after == to.stages.begin()) return {0, {}};
  const StageEntry* const there = &*(after - 1);
  const std::uint64_t end = endOf(to, there);
  if (placeInRun(*there) != placeInRun(*here)) return {end, {}};
  // As far through the stage; what both runs did alike at its beginning counts one for one.
  const bool parts = *first > here->event && *first > there->event;
  const std::uint64_t length = endOf(from, here) - here->tick;
  const std::uint64_t alike = parts ? std::min<std::uint64_t>(*first - here->event, length) : 0;
  const std::uint64_t done = place.tick - here->tick;
  const bool open = !from.complete && here == &from.stages.back();  // how long it will be is not known
  if (done <= alike || open) return {std::min(there->tick + done, end), stage};
  const std::uint64_t rest = end - std::min(end, there->tick + alike);
  const double part = static_cast<double>(done - alike) / static_cast<double>(length - alike);
  return {end - rest + static_cast<std::uint64_t>(std::llround(part * static_cast<double>(rest))), stage};
}

}  // namespace triscope
