// SPDX-License-Identifier: BSD-3-Clause
#include "examples/quadruped_walk.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"

namespace gaitwright::examples {
namespace {

TEST(QuadrupedWalkExample, ReachesTheSpeedThatIsAskedForAndNoMore) {
  for (const double speed_m_s : {0.3, 0.5}) {
    const WalkedQuadruped walk = WalkQuadruped("a1", "trot", speed_m_s);
    EXPECT_TRUE(walk.audit.pass()) << AuditText(walk.audit);
    EXPECT_TRUE(walk.report.pass) << walk.report.reason;
    EXPECT_NEAR(walk.speed_m_s, speed_m_s, 0.05 * speed_m_s);
    EXPECT_GT(walk.plan.duration_s(), 1.0 / speed_m_s) << "1 m, and the time to gain that speed and lose it";
  }
}

TEST(QuadrupedWalkExample, AGaitForAnotherNumberOfFeetIsNamed) {
  try {
    WalkQuadruped("a1", "biped", 0.3);
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("biped"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
