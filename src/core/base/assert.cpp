#include "core/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace triscope {

void invariantBroken(const char* file, int line, const char* condition, std::string_view sentence) noexcept {
  // By stdio alone: memory may be what is broken.
  std::fprintf(stderr, "%s:%d: a broken invariant, %s: %.*s\nThis is a defect of the program: please report it.\n",
               file, line, condition, static_cast<int>(sentence.size()), sentence.data());
  std::fflush(stderr);
  std::abort();
}

}  // namespace triscope
