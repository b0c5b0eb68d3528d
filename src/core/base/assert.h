// Invariants of our own code, held while it runs. What comes from outside is checked elsewhere, and is an Error.
//
// A broken invariant ends the program at once and says which: to go on would write a mesh that is wrong in silence.
// The checks that are always on cost less than 1 % of a run; none belongs in an innermost loop.
#pragma once

#include <string_view>

namespace triscope {

/// Prints "FILE:LINE: a broken invariant, CONDITION: SENTENCE" to stderr and ends the program with SIGABRT.
[[noreturn, gnu::cold]] void invariantBroken(const char* file, int line, const char* condition,
                                             std::string_view sentence) noexcept;

#ifdef TRISCOPE_HEAVY_CHECKS
inline constexpr bool kHeavyChecks = true;
#else
inline constexpr bool kHeavyChecks = false;
#endif

}  // namespace triscope

/// Always on. The sentence says what must hold, and may be an expression: it is worked out only where it does not.
#define TRISCOPE_CHECK(condition, sentence)                                       \
  do {                                                                            \
    if (!(condition)) [[unlikely]]                                                \
      ::triscope::invariantBroken(__FILE_NAME__, __LINE__, #condition, sentence); \
  } while (false)

/// For what takes long, such as looking at a whole mesh: only in builds with TRISCOPE_HEAVY_CHECKS.
#define TRISCOPE_DCHECK(condition, sentence)                                     \
  do {                                                                           \
    if constexpr (::triscope::kHeavyChecks) TRISCOPE_CHECK(condition, sentence); \
  } while (false)
