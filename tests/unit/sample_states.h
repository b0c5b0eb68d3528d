// States for the tests of the drawing layer: made by the method itself from a domain in a few lines.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/method/pipeline.h"

namespace triscope::sample {

/// A square with a square hole.
inline const char* const kFrame = R"({"name": "frame", "min_edge_length": 1,
  "outer": [[-8, -8], [8, -8], [8, 8], [-8, 8]], "holes": [[[-2, -2], [2, -2], [2, 2], [-2, 2]]]})";

inline MeshState start(const std::string& json) {
  Result<Domain> domain = parseDomain(json, "sample.json");
  EXPECT_TRUE(domain.ok()) << (domain.ok() ? "" : describe(domain.error()));
  Result<MeshState> state = begin(std::make_shared<const Domain>(*domain), Settings{});
  EXPECT_TRUE(state.ok());
  return *state;
}

/// The state at the end of `stage`.
inline MeshState after(const std::string& json, Stage stage) {
  MeshState state = start(json);
  Journal nobody;
  advanceUntil(state, stage, ~0ull, nobody);
  return state;
}

}  // namespace triscope::sample
