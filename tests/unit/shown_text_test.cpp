// Text of others in messages.
#include "core/base/shown_text.h"

#include <gtest/gtest.h>

#include "core/base/result.h"

namespace triscope::shown_text_test {
namespace {

TEST(ShownText, WhatCanBeReadStays) {
  EXPECT_EQ(shown(""), "");
  EXPECT_EQ(shown("hole 1, \"Löcher\", ω, 𝛼"), "hole 1, \"Löcher\", ω, 𝛼");
  EXPECT_EQ(shownLines("a\nb\n"), "a\nb\n");
}

TEST(ShownText, ControlCharactersAreEscaped) {
  EXPECT_EQ(shown("\x1b[2Ja\nb\t\x7f"), "\\x1b[2Ja\\nb\\x09\\x7f");
  EXPECT_EQ(shown(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(shown("\xc2\x9b"
                  "31m"),
            "\\xc2\\x9b31m");
  EXPECT_EQ(shownLines("a\r\x1b\n"), "a\\x0d\\x1b\n");
}

TEST(ShownText, WhatIsNotUtf8IsEscaped) {
  EXPECT_EQ(shown("\x9b"
                  "a\xff"),
            "\\x9ba\\xff");
  EXPECT_EQ(shown("\xe2\x80"), "\\xe2\\x80");
  EXPECT_EQ(shown("\xc3("), "\\xc3(");
}

TEST(ShownText, WhatIsLongIsCutBetweenCharacters) {
  EXPECT_EQ(shown(std::string(kLongestShown, 'x')), std::string(kLongestShown, 'x'));
  EXPECT_EQ(shown(std::string(100000, '1')), std::string(kLongestShown, '1') + "…");
  EXPECT_EQ(shown("aωω", 3), "aω…");
  EXPECT_EQ(shown("aωω", 2), "a…");
}

TEST(ShownText, AnErrorIsOneLineHoweverItsPlaceIsCalled) {
  const Error error{
      .message = "wrong\x1b", .file = std::string(200, 'f') + "\n", .loop = "a\nb" + std::string(99, 'x')};
  EXPECT_EQ(describe(error), std::string(200, 'f') + "\\n: loop 'a\\nb" + std::string(77, 'x') + "…': wrong\\x1b");
}

}  // namespace
}  // namespace triscope::shown_text_test
