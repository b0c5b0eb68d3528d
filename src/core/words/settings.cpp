#include "core/words/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/number.h"
#include "core/base/shown_text.h"

namespace triscope {
namespace {

constexpr double kLongest = 1e300;      // any finite length
constexpr double kMostTriangles = 5e8;  // half-edges and ids are counted in 32 bits

constexpr std::array kOnOff{NamedValue{"on", 1.0}, NamedValue{"off", 0.0}};

constexpr std::array kSizes{NamedValue{"ranks", 0.0}, NamedValue{"continuous", 1.0}};
constexpr std::array kPlacements{NamedValue{"circumcentre", 0.0}, NamedValue{"off-centre", 1.0},
                                 NamedValue{"frontal", 2.0},      NamedValue{"size-optimal", 3.0},
                                 NamedValue{"tiling", 4.0},       NamedValue{"spokes", 5.0}};
constexpr std::array kDials{NamedValue{"easy", 0.0}, NamedValue{"default", 1.0}, NamedValue{"acute", 2.0}};

/// In the order of Dial.
constexpr std::array kMarks{Aims{43.0, 86.0, 1.55, 1.46}, Aims{44.0, 80.0, 1.40, 1.42}, Aims{44.5, 74.0, 1.25, 1.375}};
static_assert(kMarks.size() == kDials.size());

constexpr std::array kTable{
    SettingInfo{"min_edge_length", "Δx", "smallest edge", "length", memberOf<&Settings::minEdge>(), 0.0, kLongest, 0.0,
                0.0, Stage::constraints,
                "No edge is meant to be shorter; 0 takes the domain file's, or derives it from the geometry."},
    SettingInfo{"curvature_turn", "", "turn of one edge on a curve", "deg", memberOf<&Settings::curvatureTurn>(), 1.0,
                120.0, 0.0, 0.0, Stage::constraints,
                "An edge on a curved boundary may span at most this much turning."},
    SettingInfo{
        "corner_turn", "", "turn that makes a corner extreme", "deg", memberOf<&Settings::cornerTurn>(), 0.0, 180.0,
        0.0, 0.0, Stage::constraints,
        "Where the boundary turns into the domain by more than this at a kept point, density has an extreme point."},
    SettingInfo{"gap_fraction", "", "edge length across a gap", "gap width", memberOf<&Settings::gapFraction>(), 0.01,
                10.0, 0.0, 0.0, Stage::constraints,
                "Where two boundary pieces face each other, edges are this fraction of the distance between them."},
    SettingInfo{"max_rank", "i", "coarsest density rank", "rank", memberOf<&Settings::maxRank>(), 1.0, 96.0, 0.0, 0.0,
                Stage::constraints, "No cell is given a density rank above this, so no edge grows beyond its length."},
    SettingInfo{"max_triangles", "", "most triangles", "triangles", memberOf<&Settings::maxTriangles>(), 1.0,
                kMostTriangles, 0.0, 0.0, Stage::quadtree,
                "The run stops before it makes a mesh that Table 1 estimates to have more triangles than this."},
    SettingInfo{"max_rounds", "", "budget of rounds", "rounds", memberOf<&Settings::maxRounds>(), 1.0, 10000.0, 0.0,
                0.0, Stage::step2, "Steps 2 to 5 stop after this many rounds even if the last one inserted a point."},
    SettingInfo{"step4_area_ratio", "", "step 4: area ratio it acts on", "ratio", memberOf<&Settings::step4AreaRatio>(),
                0.0, 3.0, 0.0, 0.0, Stage::step1,
                "Step 4 leaves a pair alone whose area ratio is below this; 0 takes every pair, as in the paper."},
    SettingInfo{
        "omega", "ω", "Laplacian filter", "", memberOf<&Settings::omega>(), 0.0, 1.0, 0.05, 0.25, Stage::refine,
        "Part of the way toward the mean of its neighbours that the Laplacian filter moves a vertex, 24 times over."},
    SettingInfo{"theta", "θ", "turn of an obtuse angle's sides", "deg", memberOf<&Settings::theta>(), 0.0, 30.0, 5.0,
                10.0, Stage::refine, "Both sides of an obtuse angle are rotated toward each other by this angle."},
    SettingInfo{"laplacian", "", "step 6: Laplacian filter", "on/off", memberOf<&Settings::laplacian>(), 0.0, 1.0, 0.0,
                0.0, Stage::refine, "Step 6 moves vertices toward the mean of their neighbours.", kOnOff},
    SettingInfo{"reduce_obtuse", "", "step 6: reduce obtuse angles", "on/off", memberOf<&Settings::reduceObtuse>(), 0.0,
                1.0, 0.0, 0.0, Stage::refine, "Step 6 closes obtuse angles by rotating their sides.", kOnOff},
    SettingInfo{"shared_edge", "", "step 6: move shared edges", "on/off", memberOf<&Settings::sharedEdge>(), 0.0, 1.0,
                0.0, 0.0, Stage::refine,
                "Step 6 moves the edge between two unequal triangles by a tenth of the height "
                "into the larger one.",
                kOnOff},
    SettingInfo{"polish", "", "step 6: polish the worst", "on/off", memberOf<&Settings::polish>(), 0.0, 1.0, 0.0, 0.0,
                Stage::refine,
                "Step 6 ends by trying places around the vertices of the worst and the obtuse triangles.", kOnOff},
    SettingInfo{"refine_passes", "", "budget of passes of step 6", "passes", memberOf<&Settings::refinePasses>(), 0.0,
                10000.0, 0.0, 0.0, Stage::refine,
                "Step 6 stops after this many passes even if the last one moved a vertex."},
    SettingInfo{
        "size", "", "edge length between cells", "", memberOf<&Settings::size>(), 0.0, 1.0, 0.0, 0.0, Stage::density,
        "Edge lengths jump by 26 % from a density rank to the next, as in the paper, or change continuously.", kSizes},
    SettingInfo{
        "placement", "", "where points go", "", memberOf<&Settings::placement>(), 0.0, 5.0, 0.0, 0.0, Stage::front1,
        "Points go to circumcentres or off-centres by steps 1 to 5, or row by row by an advancing front.", kPlacements},
    SettingInfo{"optimise", "", "optimise", "on/off", memberOf<&Settings::optimise>(), 0.0, 1.0, 0.0, 0.0,
                Stage::optimise, "The mesh is optimised at the end: by moves, flips, merged and split edges.", kOnOff},
    SettingInfo{"dial", "", "what to optimise for", "", memberOf<&Settings::dial>(), 0.0, 2.0, 0.0, 0.0,
                Stage::optimise, "How far the optimiser goes: it sets the four numbers below where they are 0.",
                kDials},
    SettingInfo{"lowest_angle",
                "",
                "lowest angle to aim at",
                "deg",
                memberOf<&Settings::lowestAngle>(),
                0.0,
                55.0,
                0.0,
                0.0,
                Stage::optimise,
                "The optimiser aims at no angle below this; 0 takes what the dial says.",
                {},
                [](const Settings& settings) { return aimsOf(settings).lowestAngle; }},
    SettingInfo{"highest_angle",
                "",
                "highest angle to aim at",
                "deg",
                memberOf<&Settings::highestAngle>(),
                0.0,
                120.0,
                0.0,
                0.0,
                Stage::optimise,
                "The optimiser aims at no angle above this; 0 takes what the dial says.",
                {},
                [](const Settings& settings) { return aimsOf(settings).highestAngle; }},
    SettingInfo{"area_ratio",
                "",
                "area ratio to aim at",
                "ratio",
                memberOf<&Settings::areaRatio>(),
                0.0,
                10.0,
                0.0,
                0.0,
                Stage::optimise,
                "The optimiser aims at no neighbours with a larger ratio of areas; 0 takes what the dial says.",
                {},
                [](const Settings& settings) { return aimsOf(settings).areaRatio; }},
    SettingInfo{"edge_ratio",
                "",
                "edge ratio to aim at",
                "ratio",
                memberOf<&Settings::edgeRatio>(),
                0.0,
                10.0,
                0.0,
                0.0,
                Stage::optimise,
                "The optimiser aims at no triangle with a larger ratio of edges; 0 takes what the dial says.",
                {},
                [](const Settings& settings) { return aimsOf(settings).edgeRatio; }},
};

std::string keys() {
  std::string list;
  for (const SettingInfo& info : kTable) {
    if (!list.empty()) list += ", ";
    list += info.key;
  }
  return list;
}

Error refused(const SettingInfo& info, std::string message) {
  return Error{
      .kind = ErrorKind::usage,
      .message = std::move(message),
      .hint = fmt::format("give {} (default {})", rangeText(info), valueText(info, settingValue(Settings{}, info)))};
}

std::optional<double> parseNumber(std::string_view text) {
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), last, value);
  if (failure != std::errc{} || stop != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A switch also goes by words that other programs have for it.
std::optional<double> parseName(const SettingInfo& info, std::string_view text) {
  for (const NamedValue& named : info.names)
    if (text == named.name) return named.value;
  if (info.member.kind != SettingKind::on_off) return std::nullopt;
  for (const std::string_view word : {"1", "true", "yes"})
    if (text == word) return 1.0;
  for (const std::string_view word : {"0", "false", "no"})
    if (text == word) return 0.0;
  return std::nullopt;
}

std::string_view nounOf(SettingKind kind) {
  return kind == SettingKind::on_off ? "switch" : kind == SettingKind::named ? "value" : "number";
}

}  // namespace

std::span<const SettingInfo> settingTable() { return kTable; }

const SettingInfo* findSetting(std::string_view key) {
  for (const SettingInfo& info : kTable)
    if (info.key == key) return &info;
  return nullptr;
}

Aims aimsOf(const Settings& settings) {
  Aims aims = kMarks[static_cast<std::size_t>(settings.dial)];
  if (settings.lowestAngle > 0.0) aims.lowestAngle = settings.lowestAngle;
  if (settings.highestAngle > 0.0) aims.highestAngle = settings.highestAngle;
  if (settings.areaRatio > 0.0) aims.areaRatio = settings.areaRatio;
  if (settings.edgeRatio > 0.0) aims.edgeRatio = settings.edgeRatio;
  return aims;
}

bool refines(const Settings& settings) {
  return settings.laplacian || settings.reduceObtuse || settings.sharedEdge || settings.polish;
}

double settingValue(const Settings& settings, const SettingInfo& info) { return info.member.read(settings); }

std::string_view valueName(const SettingInfo& info, double value) {
  for (const NamedValue& named : info.names)
    if (named.value == value) return named.name;
  return {};
}

bool outsidePaper(const SettingInfo& info, double value) {
  return info.paperLow < info.paperHigh && (value < info.paperLow || value > info.paperHigh);
}

std::string_view settingName(const SettingInfo& info) { return info.symbol.empty() ? info.label : info.symbol; }

std::string valueText(const SettingInfo& info, double value) {
  return isNamed(info) ? std::string(valueName(info, value)) : fmt::format("{}", value);
}

std::string settingText(const SettingInfo& info, double value) {
  if (isNamed(info)) return std::string(valueName(info, value));
  if (value == 0.0 && (info.unit == "length" || info.inForce != nullptr)) return "auto";
  return compact(value, 4) + (info.unit == "deg" ? "°" : "");
}

std::string rangeText(const SettingInfo& info) {
  std::string text;
  for (std::size_t k = 0; k < info.names.size(); ++k) {
    if (k > 0) text += k + 1 == info.names.size() ? " or " : ", ";
    text += info.names[k].name;
  }
  if (isNamed(info)) return text;
  if (info.highest >= kLongest) return fmt::format("at least {:g}", info.lowest);
  return fmt::format("from {:.9g} to {:.9g}", info.lowest, info.highest);
}

Status setSetting(Settings& settings, std::string_view key, std::string_view value) {
  if (const SettingInfo* const info = findSetting(key)) return setSetting(settings, *info, value);
  return Error{.kind = ErrorKind::usage,
               .message = fmt::format("there is no setting '{}'", shown(key)),
               .hint = fmt::format("the settings are {}", keys())};
}

Status setSetting(Settings& settings, const SettingInfo& info, std::string_view value) {
  const std::optional<double> number = isNamed(info) ? parseName(info, value) : parseNumber(value);
  if (number) return setSetting(settings, info, *number);
  return refused(info,
                 fmt::format("'{}' is no {} for the setting '{}'", shown(value), nounOf(info.member.kind), info.key));
}

Status setSetting(Settings& settings, const SettingInfo& info, double value) {
  const bool inRange =
      isNamed(info) ? !valueName(info, value).empty() : value >= info.lowest && value <= info.highest;  // NaN is not
  if (!inRange) return refused(info, fmt::format("{:g} is out of range for the setting '{}'", value, info.key));
  if (info.member.kind != SettingKind::real && value != std::floor(value))
    return refused(info, fmt::format("the setting '{}' takes whole numbers, not {:g}", info.key, value));
  info.member.write(settings, value);
  return success();
}

}  // namespace triscope
