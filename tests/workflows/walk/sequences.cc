// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/sequences.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {

void ExpectToWalk(const std::string& sequence, std::size_t parts) {
  const RobotModel model = LoadNamedRobot("a1").value();
  WalkRequest request;
  request.sequence = sequence;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const MotionPlan& plan = planned->motion.plan;
  ASSERT_EQ(plan.parts.size(), parts);
  ASSERT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  for (const MotionPart& part : plan.parts) {
    const CentroidalSample middle = SampleCentroidal(plan.centroidal, 0.5 * (part.start_s + part.end_s));
    const bool at_end = &part == &plan.parts.front() || &part == &plan.parts.back();
    if (StandsStill(part.gait) && !at_end && planned->motion.residual > 0.0) {
      EXPECT_LT(middle.v_WC.norm(), 5e-3) << part.start_s;
    }
  }
  const Result<PlayedWalk> played = PlayWalk(model, plan, {});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  testing::Test::RecordProperty("score", std::to_string(played->report.score));
}

}  // namespace gaitwright
