// Runs that are remembered from the first decision to the last, for tests that hold answers about a run against it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/method/state.h"
#include "core/run/history.h"
#include "core/words/event.h"
#include "support/domains.h"

namespace triscope::support {

struct Recorded {
  MeshState end;
  std::vector<Event> events;
  History history;
  std::vector<std::uint64_t> tickAt;  // per event: decisions made once it has happened
};

/// The whole run, with keyframes in as many bytes.
Recorded record(const DomainPtr& domain, std::size_t budget);

/// That of a sample, made once.
const Recorded& runOf(const std::string& sample);

}  // namespace triscope::support
