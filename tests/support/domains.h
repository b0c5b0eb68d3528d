// Where the tests get their domains from: samples, test data, places outside the project, and texts.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "core/domain/read.h"

namespace triscope::support {

using DomainPtr = std::shared_ptr<const Domain>;

inline std::filesystem::path samples() { return TRISCOPE_SOURCE_DIR "/assets/domains"; }
inline std::filesystem::path testData() { return TRISCOPE_SOURCE_DIR "/tests/data/domains"; }
/// Domains that may not be copied into the project: read in place where they are.
inline std::filesystem::path elsewhere() {
  const char* const folder = std::getenv("TRISCOPE_DOMAIN_CASES");
  return folder != nullptr ? folder : TRISCOPE_SOURCE_DIR "/../shared/domains";
}

/// Null, and a failed test, when the file is refused.
inline DomainPtr domainAt(const std::filesystem::path& file) {
  Result<Domain> domain = readDomain(file.string());
  if (!domain) {
    ADD_FAILURE() << describe(domain.error());
    return nullptr;
  }
  return std::make_shared<const Domain>(std::move(*domain));
}

inline DomainPtr domainFrom(const std::string& json) {
  Result<Domain> domain = parseDomain(json, "test.json");
  if (!domain) {
    ADD_FAILURE() << describe(domain.error()) << "\n" << json;
    return nullptr;
  }
  return std::make_shared<const Domain>(std::move(*domain));
}

/// A square with a square hole: the smallest domain that has every stage at work.
inline const char* const kFrame = R"({"name": "frame", "min_edge_length": 1,
  "outer": [[-8, -8], [8, -8], [8, 8], [-8, 8]], "holes": [[[-2, -2], [2, -2], [2, 2], [-2, 2]]]})";

/// The frame with an inner chain that bends and ends inside.
inline const char* const kCrackedFrame = R"({"name": "cracked frame", "min_edge_length": 0.5,
  "outer": [[0, 0], [8, 0], [8, 8], [0, 8]], "holes": [[[4, 4], [6, 4], [6, 6], [4, 6]]],
  "segments": [[[1, 1], [2, 5], [1.5, 7]]]})";

/// Curves of every kind, corners and a narrow place.
inline const char* const kRound = R"({"name": "round", "min_edge_length": 0.2,
  "outer": {"kind": "circle", "centre": [0, 0], "radius": 4},
  "holes": [{"kind": "circle", "centre": [0, 2.4], "radius": 1},
            {"kind": "spline", "points": [[-2, -1], [0, -2], [2, -1], [0, -0.5]], "corners": [0, 2]}]})";

/// A notch, holes close to it and a bent chain: small, but every rule and most refusals are met in it.
inline const char* const kNotched = R"({"name": "notched", "min_edge_length": 0.07,
  "outer": [[0, 0], [10, 0], [10, 6], [6, 6], [5.5, 1.2], [5, 6], [0, 6]],
  "holes": [[[1, 1], [3, 1], [3, 3], [1.05, 2]], [[7, 2], [8, 2], [7.5, 2.9]]],
  "segments": [[[3.5, 4], [4.4, 2], [4.6, 1]]]})";

}  // namespace triscope::support
