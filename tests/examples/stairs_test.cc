// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stairs.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"

namespace gaitwright::examples {
namespace {

TEST(StairsExample, StepsOnEachStairAsPlannedAndEachIsARiseHigher) {
  const Climb climb = ClimbStairs("a1", "stairs:rise_m=0.07,tread_m=0.25,count=2,start_m=0.45", 1.2);
  EXPECT_TRUE(climb.report.pass) << climb.report.reason;
  ASSERT_EQ(climb.treads.size(), 4U);
  const char* const names[] = {"ground", "step 1", "step 2", "step 1 down"};
  for (std::size_t k = 0; k < climb.treads.size(); ++k) {
    EXPECT_EQ(climb.treads[k].patch, names[k]);
    EXPECT_EQ(climb.treads[k].measured, climb.treads[k].planned) << names[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(climb.treads[k].measured, 4) << "each foot on " << names[k];
    EXPECT_NEAR(climb.treads[k].height_m, 0.07 * static_cast<double>(k), 0.003) << names[k];
  }
  EXPECT_EQ(climb.treads[3].measured, 0) << "the walk ends on the landing";
}

TEST(StairsExample, AParameterThatStairsDoNotHaveIsNamed) {
  try {
    ClimbStairs("a1", "stairs:rise=0.07", 1.2);
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("'rise_m'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
