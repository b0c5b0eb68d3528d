// English texts as they begin a sentence.
#pragma once

#include <string>
#include <string_view>

namespace triscope {

/// The first letter in upper case.
std::string capitalised(std::string_view text);

}  // namespace triscope
