// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/text.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gaitwright
