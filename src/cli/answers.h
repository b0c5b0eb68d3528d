// What `triscope debug` prints once it has stopped: plain text, or one JSON object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/debug_request.h"
#include "core/run/events.h"
#include "core/run/run.h"

namespace triscope {

/// Where the run stands, and why it stopped there.
struct Stop {
  const Run& run;
  Events events;                     // up to where it stands
  std::string condition;             // that was met; empty when none was
  std::optional<std::size_t> event;  // that met it
};

std::string answersAsText(const Stop& stop, const std::vector<Print>& prints);
std::string answersAsJson(const Stop& stop, const std::vector<Print>& prints);

}  // namespace triscope
