// Every parameter of a run, and the one table that the window, the command line and the docs print.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/result.h"
#include "core/words/stage.h"

namespace triscope {

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
  friend bool operator==(const Settings&, const Settings&) = default;
};

using SettingMember = std::variant<double Settings::*, int Settings::*, bool Settings::*>;

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
  Stage firstStage;       // a change cannot matter before this stage
  std::string_view help;  // one sentence
};

std::span<const SettingInfo> settingTable();
const SettingInfo* findSetting(std::string_view key);
/// Whether step 6 has anything to do.
bool refines(const Settings& settings);
double settingValue(const Settings& settings, const SettingInfo& info);
/// Whether the paper gives a range for it that the value is not in.
bool outsidePaper(const SettingInfo& info, double value);
/// What people know it by: the paper's symbol, or its label where the paper has none.
std::string_view settingName(const SettingInfo& info);
/// A value as people read it: "0.15", "7.5°", "on", "auto" for a Δx that is not given.
std::string settingText(const SettingInfo& info, double value);
/// Sets one value given as text ("0.15", "true", "off"). Errors name the key, the range and the default.
Status setSetting(Settings& settings, std::string_view key, std::string_view value);
/// Sets one value given as a number (bools: 0 or 1); refuses what is out of range.
Status setSetting(Settings& settings, const SettingInfo& info, double value);

}  // namespace triscope
