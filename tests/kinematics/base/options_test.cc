// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/options.h"

#include <gtest/gtest.h>

#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

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
