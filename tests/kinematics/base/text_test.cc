// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/text.h"

#include <gtest/gtest.h>

#include <iterator>

namespace gaitwright {
namespace {

TEST(Text, TrimmedHasNoBlanksAtItsEnds) {
  EXPECT_EQ(Trimmed(" \t two words\r\n"), "two words");
  EXPECT_EQ(Trimmed("as it is"), "as it is");
  EXPECT_EQ(Trimmed(" \n\t"), "");
  EXPECT_EQ(Trimmed(""), "");
}

TEST(Text, LowerCaseTouchesNothingButCapitals) {
  EXPECT_EQ(LowerCase("Time [S]_9"), "time [s]_9");
  EXPECT_EQ(LowerCase("\xc3\x84"), "\xc3\x84") << "of other letters it knows nothing";
  EXPECT_EQ(LowerCase(""), "");
}

// "ä" has two bytes, the character after it three and the last one four.
TEST(Text, FirstBytesEndBetweenCharacters) {
  const std::string text = "a\u00e4\u932f\U0001f916";
  ASSERT_EQ(text.size(), 10U);
  const std::size_t whole[] = {0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 10};
  for (std::size_t most = 0; most < std::size(whole); ++most)
    EXPECT_EQ(FirstBytes(text, most), text.substr(0, whole[most])) << most;
  EXPECT_EQ(FirstBytes("\x80\x80\x80\x80\x80\x80", 5).size(), 2U) << "bytes that are no text are still cut";
}

TEST(Text, ShortenedIsStillText) {
  std::string text = "a";
  for (int i = 0; i < 20; ++i) text += "\u932f";
  EXPECT_EQ(Shortened(text), text.substr(0, 58) + "...");
  EXPECT_TRUE(IsPlainText(Shortened(text)));
  EXPECT_EQ(Shortened(text.substr(0, 58)), text.substr(0, 58));
}

}  // namespace
}  // namespace gaitwright
