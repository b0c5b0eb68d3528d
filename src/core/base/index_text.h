// The number of a thing in a text that {fmt} makes: that of none is written as -1, or as the largest number there is.
#pragma once

#include <fmt/format.h>

#include "core/base/index.h"

template <class Kind, class Word>
struct fmt::formatter<triscope::Index<Kind, Word>> : fmt::formatter<Word> {
  template <class Context>
  auto format(triscope::Index<Kind, Word> index, Context& context) const {
    return fmt::formatter<Word>::format(index.n, context);
  }
};
