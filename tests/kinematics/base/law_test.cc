// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/law.h"

#include <gtest/gtest.h>

#include <sstream>

namespace gaitwright {
namespace {

TEST(Law, NamesAreOfOneLawEach) {
  ASSERT_EQ(AllLaws().size(), LawNames().size());
  EXPECT_EQ(AllLaws().front(), Law::kConsistency);
  EXPECT_EQ(AllLaws().back(), Law::kContinuousTorque);
  for (const Law law : AllLaws()) {
    EXPECT_EQ(LawOfName(LawName(law)), law);
    std::ostringstream out;
    out << law;
    EXPECT_EQ(out.str(), LawName(law));
  }
  EXPECT_EQ(LawName(Law::kZmpSupport), "zmp_support");
  EXPECT_EQ(LawName(Law::kDynamics), "dynamics");
  EXPECT_EQ(LawOfName("gravity"), std::nullopt);
}

}  // namespace
}  // namespace gaitwright
