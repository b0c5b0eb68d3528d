// What is written as JSON reads back as the same value, bit by bit.
#include "core/base/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "core/base/json_value.h"
#include "support/random.h"

namespace triscope::json_text_test {
namespace {

void expectSame(double value) {
  const Result<JsonValue> read = parseJson(jsonNumber(value));
  ASSERT_TRUE(read.ok()) << jsonNumber(value) << ": " << describe(read.error());
  ASSERT_NE(read->number(), nullptr) << jsonNumber(value);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(*read->number()), std::bit_cast<std::uint64_t>(value)) << jsonNumber(value);
}

TEST(JsonNumber, ReadsBackAsTheSameDouble) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, 0.1, 1.0 / 3.0, 1e15, 1e16, 123456789012345678.0, 9007199254740993.0, 1e19, 1e22,
                             Limits::max(), Limits::min(), Limits::denorm_min(), Limits::epsilon()}) {
    expectSame(value);
    expectSame(-value);
  }
  support::Random random(1);
  for (int k = 0; k < 2000;) {
    const auto value = std::bit_cast<double>(random.next());
    if (!std::isfinite(value)) continue;
    expectSame(value);
    ++k;
  }
}

TEST(JsonNumber, IsNullForWhatJsonHasNoNumberFor) {
  EXPECT_EQ(jsonNumber(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(jsonNumber(std::numeric_limits<double>::quiet_NaN()), "null");
}

TEST(JsonText, ReadsBackAsTheSameText) {
  for (const std::string& text :
       {std::string(), std::string("a \"b\" \\ c"), std::string("\n\t\0\x1f", 4), std::string("Δx → ω \U0001d11e")}) {
    const Result<JsonValue> read = parseJson(jsonText(text));
    ASSERT_TRUE(read.ok()) << describe(read.error());
    ASSERT_NE(read->text(), nullptr);
    EXPECT_EQ(*read->text(), text);
  }
}

}  // namespace
}  // namespace triscope::json_text_test
