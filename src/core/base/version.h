// Which program and which method made a file. What is written says so, and its readers are told where that differs.
#pragma once

#include <string>

namespace triscope {

/// Of the method: raised whenever some input gives another mesh, or is meshed by other decisions, than before.
inline constexpr int kMethodVersion = 3;

struct MadeBy {
  std::string program;  // "0.1.0"; empty: not said
  int method = 0;       // 0: not said
};

/// The program's own, which CMakeLists.txt gives.
MadeBy thisVersion();

/// "saved by triscope 0.1.0 with version 1 of the method; …", of what another version saved; empty of what this did.
std::string versionNote(const MadeBy& file);

}  // namespace triscope
