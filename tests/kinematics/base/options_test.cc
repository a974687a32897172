// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/options.h"

#include <gtest/gtest.h>

#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

TEST(NearName, IsNoneWhereAllAreFar) {
  EXPECT_EQ(NearName("lenght", {"width", "length"}, 2), "length");
  EXPECT_EQ(NearName("lenght", {"width", "length"}, 1), "");
  EXPECT_EQ(NearName("word", {std::string(1000, 'w')}, 3), "");
  EXPECT_EQ(NearName("word", {}, 3), "");
}

/// The distance of two words goes with the product of their lengths: of a million letters each it would take hours.
TEST(NearestName, OfWordsOfAnyLengthIsFoundAtOnce) {
  const std::string long_word(1000000, 'a');
  EXPECT_EQ(NearestName(long_word, {"b", long_word + "c", "d"}), long_word + "c");
  EXPECT_EQ(NearestName("lenght", {"width", "length", "height"}), "length");
  EXPECT_EQ(NearestName("word", {}), "");
}

TEST(PlainText, HasNoControlCharactersAndIsUtf8) {
  EXPECT_TRUE(IsPlainText("caf\xc3\xa9\t1\n"));
  EXPECT_FALSE(IsPlainText("caf\xe9"));
  EXPECT_FALSE(IsPlainText("a\x07"));
  EXPECT_FALSE(IsPlainText(std::string("a\0b", 3)));
  EXPECT_FALSE(IsPlainText("\xed\xa0\x80"));  // half of a surrogate pair
}

TEST(ShortenedText, EndsBetweenCharacters) {
  EXPECT_EQ(Shortened("short"), "short");
  const std::string text = std::string(59, 'a') + "\xc3\xa9" + "b";
  EXPECT_EQ(Shortened(text), std::string(59, 'a') + "...");
}

}  // namespace
}  // namespace gaitwright
