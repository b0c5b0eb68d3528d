// What a method is made of: a row for each stage, and lists of the stages that are run. Everybody who names a stage,
// or asks what it belongs to, reads the row.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/words/settings.h"
#include "core/words/stage.h"

namespace triscope {

struct Journal;
struct MeshState;

enum class Outcome : std::uint8_t {
  decided,   // a decision was made that inserted no point
  inserted,  // a decision was made that inserted a point
  worked,    // no decision yet, but the next one is nearer
  done,      // the stage has nothing left to do; nothing was changed
};

/// The parts of a method, in the order that they follow one another.
enum class StageGroup : std::uint8_t {
  density,       // comes before the first triangle
  boundary,      // joins the boundary's points, until nothing outside the domain is left
  fronts,        // the points off the boundary
  filling,       // step 1, once
  rounds,        // come again, all of them, until nothing is left to insert
  refinement,    // what steps 1-5 promise holds, and points are moved
  optimisation,  // so it is, and edges are edited too
  end,
};

struct StageInfo {
  Stage id{};
  std::uint8_t code = 0;  // in the hash of a state. It stays, whatever stages come between: a new one gets a new number
  StageGroup group{};
  std::string_view name{};    // "step 3"
  std::string_view key{};     // "step3": command line, files
  std::string_view does{};    // one line
  std::string_view rule{};    // the same in a word or two; of steps 1-5 the condition that makes them insert a point
  std::string_view figure{};  // of the paper, may be empty
  double shade = 0.0;         // in pictures: how much of its group's colour it has, from 0 to 1
  Outcome (*runOne)(MeshState&, Journal&) = nullptr;  // makes the next decision; none: the end
  bool (*wanted)(const Settings&) = nullptr;          // whether it is run at all; none: always
  bool (*callsForRound)(const MeshState&) = nullptr;  // when it is over: whether the rounds begin again; none: never
};

/// One entry per Stage, in order.
std::span<const StageInfo> stages();
inline const StageInfo& infoOf(Stage stage) { return stages()[static_cast<std::size_t>(stage)]; }

/// Stages in the order of Stage, from the first that is run to the last. All are carried on by the same pipeline.h.
struct Method {
  std::string_view name;
  std::span<const Stage> stages;
};
/// The one of the paper, with what is our own.
const Method& paperMethod();

/// Whether a stage makes the density: it comes before the first triangle.
inline bool makesDensity(Stage stage) { return infoOf(stage).group == StageGroup::density; }
/// Whether the mesh is that of the domain by then, nothing outside it being left.
inline bool isCarved(Stage stage) { return infoOf(stage).group > StageGroup::boundary; }
/// Whether a stage belongs to the rounds, each of which goes through all of them again.
inline bool inRounds(Stage stage) { return infoOf(stage).group == StageGroup::rounds; }
/// Whether the rounds are over by then, and with them what steps 1-5 promise.
inline bool isPastRounds(Stage stage) { return infoOf(stage).group > StageGroup::rounds; }
/// Whether a stage moves points, in passes over the mesh.
inline bool refinesMesh(Stage stage) { return infoOf(stage).group == StageGroup::refinement; }

/// Whether a stage optimises: it moves points in passes, and edits edges too.
inline bool optimisesMesh(Stage stage) { return infoOf(stage).group == StageGroup::optimisation; }

/// What several stages are called together on the command line: "fronts", "rounds". Empty where they have no name.
std::string_view groupKey(StageGroup group);

/// "round 3" in the rounds, "pass 3" in refinement; empty where nothing is counted.
std::string turnText(Stage stage, int turn);
/// The same behind a name: ", round 3".
std::string turnBehind(Stage stage, int turn);
/// The same with what it is a turn of: "Round 3 of steps 2 to 5", "Pass 3 of step 6".
std::string turnHeading(Stage stage, int turn);

/// First stage that the difference between two settings can matter to; `finished` when they are the same.
Stage firstAffected(const Settings& a, const Settings& b);

}  // namespace triscope
