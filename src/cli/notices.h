// Whether a command says on stderr how far it is and what it found, or only what is wrong: --quiet.
#pragma once

#include <cstdint>

namespace triscope {

enum class Notices : std::uint8_t { shown, none };

}  // namespace triscope
