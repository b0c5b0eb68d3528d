// What the exit codes of the program mean, for --help; README.md has the same table with more words.
#pragma once

#include <string>

namespace triscope {

/// One a line, under a heading.
std::string exitCodesHelp();

}  // namespace triscope
