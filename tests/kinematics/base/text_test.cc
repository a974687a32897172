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

}  // namespace
}  // namespace gaitwright
