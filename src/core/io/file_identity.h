// Which file a name stands for.
#pragma once

#include <filesystem>
#include <string>

namespace triscope {

/// Where writing to `path` ends up: symbolic links are followed, also one that leads to nothing yet.
std::filesystem::path targetOf(const std::string& path);

}  // namespace triscope
