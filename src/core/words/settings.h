// Every parameter of a run, and the one table that the window, the command line and the docs print.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/result.h"
#include "core/words/stage.h"

namespace triscope {

/// What the edge length wanted at a point is: that of its cell's density rank, or one made continuous.
enum class SizeField : std::uint8_t { ranks, continuous };

/// Where points go, once the boundary is triangulated. The first two belong to steps 1-5, which go on until their rules
/// hold; the others are those of an advancing front, which fills the domain row by row.
enum class Placement : std::uint8_t { circumcentre, off_centre, rebay, size_optimal, tiling, spokes };
inline bool placesByFront(Placement placement) { return placement >= Placement::rebay; }

/// How far the optimiser goes.
enum class Dial : std::uint8_t { easy, standard, acute };

struct Settings {
  double minEdge = 0.0;         // Δx; 0: the domain file's, or derived
  double curvatureTurn = 30.0;  // degrees of turning that one edge may span on a curve
  double cornerTurn = 60.0;     // degrees: a boundary that turns more at a kept point has an extreme point there
  double gapFraction = 0.3;     // edge length across a gap, as a fraction of its width
  int maxRank = 64;             // coarsest density rank allowed
  int maxTriangles = 20000000;  // the method stops before it makes a mesh of more
  int maxRounds = 60;           // budget of rounds of steps 2-5
  double step4AreaRatio = 1.8;  // step 4 leaves pairs below this area ratio alone; 0: none, as in the paper
  double omega = 0.15;          // ω, Laplacian filter
  double theta = 7.5;           // θ, degrees
  bool laplacian = true;        // step 6, part 1
  bool reduceObtuse = true;     // step 6, part 2
  bool sharedEdge = true;       // step 6, part 3
  bool polish = true;           // step 6, part 4, our own
  int refinePasses = 30;        // budget of passes of step 6
  SizeField size = SizeField::ranks;
  Placement placement = Placement::circumcentre;
  bool optimise = true;        // after step 6, our own
  Dial dial = Dial::standard;  // what the optimiser aims at; each of the next four in its place where it is not 0
  double lowestAngle = 0.0;    // degrees
  double highestAngle = 0.0;   // degrees
  double areaRatio = 0.0;
  double edgeRatio = 0.0;
  friend bool operator==(const Settings&, const Settings&) = default;
};

enum class SettingKind : std::uint8_t { real, whole, on_off, named };

/// How a member of Settings is read and written as a number: a switch is 0 or 1, a named value its number in the enum.
struct SettingMember {
  SettingKind kind;
  double (*read)(const Settings&);
  void (*write)(Settings&, double);
};

/// That of a double, an int, a bool or an enum.
template <auto member>
constexpr SettingMember memberOf() {
  using Value = std::remove_cvref_t<decltype(std::declval<Settings&>().*member)>;
  return {std::is_enum_v<Value>         ? SettingKind::named
          : std::is_same_v<Value, bool> ? SettingKind::on_off
          : std::is_same_v<Value, int>  ? SettingKind::whole
                                        : SettingKind::real,
          [](const Settings& settings) { return static_cast<double>(settings.*member); },
          [](Settings& settings, double value) {
            if constexpr (std::is_same_v<Value, bool>)
              settings.*member = value != 0.0;
            else if constexpr (std::is_enum_v<Value>)
              settings.*member = static_cast<Value>(static_cast<int>(value));
            else
              settings.*member = static_cast<Value>(value);
          }};
}

/// A value that people call by its name.
struct NamedValue {
  std::string_view name;
  double value;
};

struct SettingInfo {
  std::string_view key;     // as in --set key=value and in files
  std::string_view symbol;  // the paper's, UTF-8, may be empty
  std::string_view label;   // for people
  std::string_view unit;    // "", "deg", "length"
  SettingMember member;
  double lowest;  // outside [lowest, highest] is an error
  double highest;
  double paperLow;  // outside [paperLow, paperHigh] is a warning; equal: the paper gives no range
  double paperHigh;
  Stage firstStage;                              // a change cannot matter before this stage
  std::string_view help;                         // one sentence
  std::span<const NamedValue> names{};           // all that there are of a switch or a named value, as they are offered
  double (*inForce)(const Settings&) = nullptr;  // of a number that may be 0: what another setting then makes it
};

std::span<const SettingInfo> settingTable();
const SettingInfo* findSetting(std::string_view key);
/// What the optimiser aims at: no angle beyond these, no pair with a larger area ratio, no triangle with a larger edge
/// ratio.
struct Aims {
  double lowestAngle;   // degrees
  double highestAngle;  // degrees
  double areaRatio;
  double edgeRatio;
};
/// Those of the dial, but for those that are given.
Aims aimsOf(const Settings& settings);

/// Whether step 6 has anything to do.
bool refines(const Settings& settings);
double settingValue(const Settings& settings, const SettingInfo& info);
/// Whether the paper gives a range for it that the value is not in.
bool outsidePaper(const SettingInfo& info, double value);
/// What people know it by: the paper's symbol, or its label where the paper has none.
std::string_view settingName(const SettingInfo& info);
/// The name of a value, where values have names.
std::string_view valueName(const SettingInfo& info, double value);
/// Whether its values have names, and are chosen from a list.
inline bool isNamed(const SettingInfo& info) { return !info.names.empty(); }
/// A value as the command line takes it: "0.15", "on".
std::string valueText(const SettingInfo& info, double value);
/// A value as people read it: "0.15", "7.5°", "on", "auto" for a Δx that is not given.
std::string settingText(const SettingInfo& info, double value);
/// What may be given: "from 0.05 to 1", "at least 0", "on or off".
std::string rangeText(const SettingInfo& info);
/// Sets one value given as text ("0.15", "true", "off"). Errors name the key, what may be given and the default.
Status setSetting(Settings& settings, std::string_view key, std::string_view value);
Status setSetting(Settings& settings, const SettingInfo& info, std::string_view value);
/// Sets one value given as a number (bools: 0 or 1); refuses what is out of range.
Status setSetting(Settings& settings, const SettingInfo& info, double value);

}  // namespace triscope
