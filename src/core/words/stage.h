// The stages of the method in the order they run. The table with what each does is in pipeline.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace triscope {

enum class Stage : std::uint8_t {
  constraints,    // Figure 1 (a)
  quadtree,       // Figure 1 (b)
  density,        // Figure 1 (c, d)
  boundary,       // Figure 4 (a)
  triangulation,  // Figure 4 (b), initial Bowyer-Watson
  recovery,       // every boundary edge made present
  carve,          // Figure 4 (b), triangles outside removed
  front1,         // Figure 4 (c)
  front2,         // Figure 4 (c)
  step1,          // Figure 4 (d)
  step2,          // a round is steps 2, 3, 4, 5
  step3,
  step4,
  step5,   // Figure 4 (e) once a round inserts nothing
  repair,  // our own: mends what the steps had to refuse
  refine,  // step 6, Figure 4 (f)
  finished,
};

/// Whether a stage belongs to the rounds, each of which goes through all of them again.
constexpr bool inRounds(Stage stage) { return stage >= Stage::step2 && stage <= Stage::repair; }

/// Whether a stage makes the density: it comes before the first triangle.
constexpr bool makesDensity(Stage stage) { return stage <= Stage::density; }
/// Whether the mesh is that of the domain by then, nothing outside it being left.
constexpr bool isCarved(Stage stage) { return stage > Stage::carve; }
/// Whether the rounds are over by then, and with them what steps 1-5 promise.
constexpr bool isPastRounds(Stage stage) { return stage > Stage::repair; }

inline constexpr int kStageCount = static_cast<int>(Stage::finished) + 1;

/// What a stage is called in the hash of a state. It stays, whatever stages come between: a new one gets a new number.
constexpr std::uint8_t codeOf(Stage stage) {
  constexpr std::array<std::uint8_t, kStageCount> kCodes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  return kCodes[static_cast<std::size_t>(stage)];
}

}  // namespace triscope
