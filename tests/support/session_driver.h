// A session driven from a test: each command is waited for.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "core/domain/read.h"
#include "core/method/pipeline.h"
#include "core/session/session.h"

namespace triscope {

inline constexpr auto kForever = std::chrono::seconds(60);

/// A square of side 8 with a square hole of side 2.
inline std::shared_ptr<const Domain> square(double minEdge) {
  Result<Domain> domain = parseDomain(
      R"({"name": "square", "outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[3,3],[5,3],[5,5],[3,5]]]})", "square.json");
  EXPECT_TRUE(domain.ok());
  domain->minEdgeLength = minEdge;
  return std::make_shared<const Domain>(std::move(*domain));
}

/// The end of a run that nothing interrupts.
inline MeshState straightRun(std::shared_ptr<const Domain> domain, const Settings& settings,
                             std::vector<Event>* events) {
  MeshState state = *begin(std::move(domain), settings);
  Journal journal{events};
  advance(state, Grain::all, journal);
  return state;
}

/// Carries out a command and waits for it to be over.
inline const Snapshot& doNow(Session& session, const Command& command) {
  session.apply(command);
  EXPECT_TRUE(session.settle(kForever));
  return *session.current();
}

/// Waits until the measures along the run are there too.
inline const RunRecord& measured(Session& session) {
  while (session.record().samples.empty() || session.record().samples.back().tick < session.record().ticks)
    session.settle(std::chrono::milliseconds(5));
  return session.record();
}

}  // namespace triscope
