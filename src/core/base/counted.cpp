#include "core/base/counted.h"

#include <fmt/format.h>

namespace triscope {

namespace {

constexpr std::string_view kThinSpace = "\u2009";

}  // namespace

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  if (text.size() <= 4) return text;
  for (std::size_t i = text.size() - 3;; i -= 3) {
    text.insert(i, kThinSpace);
    if (i <= 3) break;
  }
  return text;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", grouped(count), count == 1 ? one : many);
}

std::string ungrouped(std::string text) {
  for (std::size_t at = text.find(kThinSpace); at != std::string::npos; at = text.find(kThinSpace, at))
    text.erase(at, kThinSpace.size());
  return text;
}

}  // namespace triscope
