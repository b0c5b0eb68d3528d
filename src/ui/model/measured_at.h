// The measures at any decision of the run: exact where the window stands, elsewhere of the last sample before it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/run/run_record.h"
#include "ui/model/view.h"

namespace triscope {

/// What is known of the mesh after so many decisions; its own tick says of how many. Nothing before the first sample.
std::optional<QualitySample> measuredAt(const View& view, std::uint64_t tick);
/// " after decision 512" for a sample of another decision than the one asked about; empty where it is of that one.
std::string sampledBefore(const QualitySample& sample, std::uint64_t tick);

}  // namespace triscope
