// Running the method in tests.
#pragma once

#include <gtest/gtest.h>

#include "core/method/pipeline.h"
#include "support/domains.h"

namespace triscope::support {

inline MeshState start(const DomainPtr& domain, const Settings& settings = {}) {
  Result<MeshState> state = begin(domain, settings);
  if (!state) {
    ADD_FAILURE() << describe(state.error());
    return {};
  }
  return *state;
}

/// Steps 1 to 6: the run ends where the paper's does.
inline Settings withoutOptimiser() {
  Settings settings;
  settings.optimise = false;
  return settings;
}

/// Steps 1 to 5.
inline Settings withoutStep6() {
  Settings settings = withoutOptimiser();
  settings.laplacian = settings.reduceObtuse = settings.sharedEdge = settings.polish = false;
  return settings;
}

/// Carries on until `stage` is over, unheard.
inline void runPast(MeshState& state, Stage stage) {
  Journal nobody;
  while (advanceUntil(state, stage, 1u << 30, nobody)) {
  }
}

inline MeshState after(const DomainPtr& domain, Stage stage, const Settings& settings = {}) {
  MeshState state = start(domain, settings);
  runPast(state, stage);
  return state;
}

inline MeshState finished(const DomainPtr& domain, const Settings& settings = {}) {
  MeshState state = start(domain, settings);
  Journal nobody;
  while (advance(state, Grain::all, nobody)) {
  }
  return state;
}

}  // namespace triscope::support
