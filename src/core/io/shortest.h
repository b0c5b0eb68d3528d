// A double in the fewest digits that read back the same, as fmt writes it with "{}" but faster: fmt finds the digits at
// once, and then takes twice as long to put them down.
#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace triscope {

/// Bytes to have free for a number: it takes 24 at most, and is copied in pieces of a fixed size.
inline constexpr std::size_t kLongestNumber = 48;

/// "00", "01", … "99".
inline constexpr auto kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t k = 0; k < 100; ++k) {
    pairs[2 * k] = static_cast<char>('0' + k / 10);
    pairs[2 * k + 1] = static_cast<char>('0' + k % 10);
  }
  return pairs;
}();

/// All eight digits of a number below 10^8.
inline void writeEight(char* out, std::uint32_t number) {
  const std::uint32_t high = number / 10000, low = number % 10000;
  std::memcpy(out, &kPairs[2 * (high / 100)], 2);
  std::memcpy(out + 2, &kPairs[2 * (high % 100)], 2);
  std::memcpy(out + 4, &kPairs[2 * (low / 100)], 2);
  std::memcpy(out + 6, &kPairs[2 * (low % 100)], 2);
}

/// Writes to `out` and returns the end of it.
inline char* writeShortest(char* out, double value) {
  constexpr int kLowest = -4, kHighest = 16;  // powers of ten of the first digit that are written without an exponent
  constexpr std::uint32_t kEight = 100000000;
  constexpr int kMostDigits = 17;
  if (value == 0.0 || !std::isfinite(value)) return fmt::format_to(out, FMT_COMPILE("{}"), value);
  const auto decimal = fmt::detail::dragonbox::to_decimal(std::fabs(value));
  // 17 digits with zeros before them, and room to copy more than there are.
  std::array<char, 2 * kMostDigits> padded{};
  const std::uint64_t upper = decimal.significand / kEight;
  padded[0] = static_cast<char>('0' + upper / kEight);
  writeEight(&padded[1], static_cast<std::uint32_t>(upper % kEight));
  writeEight(&padded[9], static_cast<std::uint32_t>(decimal.significand % kEight));
  const char* digits = padded.data();
  while (*digits == '0') ++digits;
  const auto count = static_cast<int>(padded.data() + kMostDigits - digits);
  const int before = count + decimal.exponent;  // digits before the point; 0 and less: zeros after it
  if (before <= kLowest || before > kHighest) return fmt::format_to(out, FMT_COMPILE("{}"), value);
  *out = '-';
  out += value < 0.0 ? 1 : 0;
  if (before <= 0) {
    std::memcpy(out, "0.0000", 6);
    std::memcpy(out + 2 - before, digits, kMostDigits);
    return out + 2 - before + count;
  }
  if (before >= count) {
    std::memset(out, '0', kMostDigits);
    std::memcpy(out, digits, static_cast<std::size_t>(count));
    return out + before;
  }
  std::memcpy(out, digits, kMostDigits);
  out[before] = '.';
  std::memcpy(out + before + 1, digits + before, kMostDigits);
  return out + count + 1;
}

/// For formats: print(out, FMT_COMPILE("{}"), Shortest{x}).
struct Shortest {
  double value;
};

}  // namespace triscope

template <>
struct fmt::formatter<triscope::Shortest> {
  template <class Context>
  constexpr auto parse(Context& context) {
    return context.begin();
  }
  template <class Context>
  auto format(const triscope::Shortest& number, Context& context) const {
    if constexpr (std::is_same_v<decltype(context.out()), char*>) {
      return triscope::writeShortest(context.out(), number.value);
    } else {
      char text[triscope::kLongestNumber];
      return std::copy(text, triscope::writeShortest(text, number.value), context.out());
    }
  }
};
