// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/carried_plan.h"

#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

Pose Away() { return PoseOf({1.3, -0.7, 2.1}); }

class Carried : public testing::TestWithParam<const char*> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& plan() const { return GoodPlanOf(GetParam()).plan; }
};

INSTANTIATE_TEST_SUITE_P(Robots, Carried, testing::Values("a1", "nao"), [](const auto& robot) { return robot.param; });

TEST_P(Carried, APlanKeepsAllLawsElsewhereAndLater) {
  const MotionPlan there = CarriedPlan(Away(), 3.5, plan());
  EXPECT_EQ(LawsOf(ViolationsOf(model(), there)), std::vector<Law>());
  EXPECT_NEAR(there.whole_body.start_s, plan().whole_body.start_s + 3.5, 1e-12);
  EXPECT_NEAR(there.schedule.end_s(), plan().schedule.end_s() + 3.5, 1e-12);
  EXPECT_NEAR(there.goal.yaw_rad, WrapAngle(plan().goal.yaw_rad + 2.1), 1e-12);
}

TEST_P(Carried, BodiesGoWhereTheTransformTakesThem) {
  const MotionPlan there = CarriedPlan(Away(), 2.0, plan());
  const double time_s = TimeOf(plan(), MidSwingRow(plan()));
  const Moment was(model(), plan(), time_s), is(model(), there, time_s + 2.0);
  for (std::size_t body = 0; body < model().bodies.size(); ++body) {
    EXPECT_LT((is.scratch.p_WB[body] - Away() * was.scratch.p_WB[body]).norm(), 1e-9);
    EXPECT_LT((is.scratch.R_WB[body] - Away().linear() * was.scratch.R_WB[body]).norm(), 1e-9);
  }
  EXPECT_LT((is.sample.v.head<3>() - Away().linear() * was.sample.v.head<3>()).norm(), 1e-9);
  EXPECT_LT((is.sample.tau - was.sample.tau).norm(), 1e-9) << "joints feel nothing of it";
}

TEST_P(Carried, SwingsGoAlongWithTheirDetours) {
  MotionPlan here = plan();
  for (SwingTrajectory& swing : here.swings) swing.detour_W = {{0.01, 0.02, 0.05}, {-0.02, 0.0, 0.08}};
  const MotionPlan there = CarriedPlan(Away(), 2.0, here);
  for (std::size_t i = 0; i < here.swings.size(); ++i) {
    const SwingTrajectory& swing = here.swings[i];
    for (const double share : {0.2, 0.5, 0.9}) {
      const double time_s = swing.start_s + share * (swing.end_s - swing.start_s);
      const Pose was = Evaluate(CurveOf(swing), time_s).X_WF,
                 is = Evaluate(CurveOf(there.swings[i]), time_s + 2.0).X_WF;
      EXPECT_LT((is.translation() - Away() * was.translation()).norm(), 1e-9);
    }
  }
}

TEST_P(Carried, AndBackItIsAsItWas) {
  const MotionPlan back = CarriedPlan(Away().inverse(), -2.0, CarriedPlan(Away(), 2.0, plan()));
  for (std::size_t k = 0; k < plan().whole_body.q.size(); k += 50) {
    const VectorX &is = back.whole_body.q[k], &was = plan().whole_body.q[k];
    EXPECT_LT((is.head<3>() - was.head<3>()).norm(), 1e-9);
    EXPECT_LT((BaseRotation(is) - BaseRotation(was)).norm(), 1e-9);
  }
  for (std::size_t k = 0; k < plan().centroidal.p_WZ.size(); k += 50)
    EXPECT_LT((back.centroidal.p_WZ[k] - plan().centroidal.p_WZ[k]).norm(), 1e-9);
}

TEST(CarriedStates, AreMovedRigidlyByAnyTransform) {
  Pose X(RotationExp({0.3, -0.5, 1.0}));
  X.translation() << 1.0, 2.0, 3.0;
  const VectorX& q = GoodPlanOf("a1").plan.whole_body.q.front();
  const VectorX there = CarriedState(X, q);
  EXPECT_LT((BaseRotation(there) - X.linear() * BaseRotation(q)).norm(), 1e-12);
  EXPECT_LT((there.head<3>() - X * Vector3(q.head<3>())).norm(), 1e-12);
  EXPECT_NEAR(there.segment<4>(3).norm(), 1.0, 1e-12);
  EXPECT_EQ(there.tail(12), q.tail(12));
}

}  // namespace
}  // namespace gaitwright
