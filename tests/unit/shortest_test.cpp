// Doubles as text: the same as fmt writes, for every kind of double.
#include "core/io/shortest.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "core/io/append_text.h"

namespace triscope {
namespace {

std::string shortest(double value) {
  std::array<char, kLongestNumber> text{};
  return {text.data(), writeShortest(text.data(), value)};
}

TEST(Shortest, IsWhatFmtWrites) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             0.1,
                             0.1 + 0.2,
                             1e-4,
                             9.999e-5,
                             1e15,
                             1e16,
                             9007199254740993.0,
                             123456789012345678.0,
                             -1.2345678901234567e-308,
                             5e-324,
                             Limits::max(),
                             Limits::min(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN(),
                             1.0 / 3.0,
                             -2.0 / 3.0,
                             1e-5 / 3.0,
                             1e-4 / 3.0,
                             1e-3 / 3.0})
    EXPECT_EQ(shortest(value), fmt::format("{}", value));
  std::mt19937_64 random(8);
  for (int k = 0; k < 200000; ++k) {
    const auto bits = random();
    const auto whole = static_cast<std::int64_t>(bits) >> (bits % 61);
    for (const double value :
         {std::bit_cast<double>(bits), static_cast<double>(whole), static_cast<double>(whole % 2000000) / 1000.0,
          std::ldexp(static_cast<double>(bits >> 11), -53), std::ldexp(static_cast<double>(bits >> 11), -70)})
      ASSERT_EQ(shortest(value), fmt::format("{}", value)) << bits;
  }
}

TEST(Shortest, StandsInFormats) {
  TextBuffer out;
  print(out, FMT_COMPILE("{} {}\n"), -0.25, 7);
  print(out, FMT_COMPILE("{}: {}\n"), std::string("one third"), 1.0 / 3.0);
  EXPECT_EQ(std::string(out.data(), out.size()), "-0.25 7\none third: 0.3333333333333333\n");
}

}  // namespace
}  // namespace triscope
