// Where a run is to be carried on to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/run/run.h"

namespace triscope {

struct Goal {
  enum class Kind : std::uint8_t {
    none,        // nowhere: where the run is
    tick,        // so many decisions
    event,       // right after the decision that an event belongs to
    entry,       // where a stage begins, before its first decision
    insertion,   // the next point
    stage,       // out of the stage
    round,       // out of the round, or the stage where there is none
    breakpoint,  // the next decision that meets one that stops
    end,
  };
  Kind kind = Kind::none;
  std::uint64_t tick = 0;            // tick; entry: decisions before it, kUnknown when they are not known
  std::uint64_t event = 0;           // event: its number, from 0
  Stage stage = Stage::constraints;  // entry: that one; stage, round: where the step began
  std::uint16_t round = 0;           // likewise
  std::size_t vertices = 0;          // insertion: how many there were
};

inline constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

/// Whether the run stands where the goal is. One for which a breakpoint is to be met never does by itself.
bool arrived(const Run& run, const Goal& goal);

}  // namespace triscope
