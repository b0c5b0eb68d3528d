// Which file a name stands for, so that nothing is written over what a command reads or writes under another name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace triscope {

/// Where writing to `path` ends up: symbolic links are followed, also one that leads to nothing yet.
std::filesystem::path targetOf(const std::string& path);

/// The descriptor of this program that a name such as /dev/stdout or /dev/fd/3 stands for, also by way of links.
std::optional<int> descriptorNamed(const std::string& path);

/// Whether both names stand for one regular file, there already or yet to be made. A pipe or a terminal is not
/// overwritten by what is written to it, so that two names of one are not the same.
bool sameFile(const std::string& a, const std::string& b);

struct NamedFile {
  std::string what;  // as the message names it: "the domain", "--report"
  std::string path;  // empty: none
};

/// Refuses (usage) an output that is an input or another output. The first that is wrong is named. What is written to
/// open descriptors follows each other, and overwrites nothing.
Status checkOverwrites(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace triscope
