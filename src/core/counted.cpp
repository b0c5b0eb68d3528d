#include "core/counted.h"

#include <fmt/format.h>

namespace triscope {

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  if (text.size() <= 4) return text;
  for (std::size_t i = text.size() - 3;; i -= 3) {
    text.insert(i, "\u2009");
    if (i <= 3) break;
  }
  return text;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", grouped(count), count == 1 ? one : many);
}

}  // namespace triscope
