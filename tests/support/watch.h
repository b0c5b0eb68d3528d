// Steps through a run one decision at a time, and shows each with the state before and after it.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "core/method/pipeline.h"

namespace triscope::support {

inline bool aboutAStage(const Event& event) {
  return event.kind == EventKind::stage_begun || event.kind == EventKind::stage_finished;
}

/// Calls look(before, after, events) for every decision until `last` is over; the events are those of the decision
/// alone. Stops at the first fatal failure.
template <class Look>
void eachDecision(MeshState& state, Stage last, Look look) {
  std::vector<Event> events;
  Journal journal{&events};
  MeshState before = state;
  while (state.stage <= last) {
    events.clear();
    const std::uint64_t tick = state.tick;
    if (!advance(state, Grain::decision, journal) || state.tick == tick) return;
    std::erase_if(events, aboutAStage);
    look(std::as_const(before), std::as_const(state), std::span<const Event>(events));
    if (testing::Test::HasFatalFailure()) return;
    before = state;
  }
}

}  // namespace triscope::support
