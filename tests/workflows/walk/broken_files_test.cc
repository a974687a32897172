// SPDX-License-Identifier: BSD-3-Clause
// Plans broken on purpose in one column of the finished file, so that the columns no longer agree: the audit names the
// check; the playback fails if the controller uses the column, and gives the reason.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/workflows/walk/broken_bench.h"

namespace gaitwright {
namespace {

using Laws = std::vector<Law>;

class BrokenFile : public testing::TestWithParam<std::string> {
 protected:
  const Bench& bench() const { return BenchOf(GetParam()); }
  const RobotModel& model() const { return bench().model; }

  void ExpectNoMatterInPhysics(const MotionPlan& plan) const {
    for (const char* controller : {"joint-pd", "stabilised"}) {
      const StabilityReport report = Played(model(), plan, controller).report;
      EXPECT_TRUE(report.pass) << controller << ": " << report.reason;
    }
  }
  void ExpectFails(const MotionPlan& plan, const std::string& controller, const std::string& reason) const {
    const StabilityReport report = Played(model(), plan, controller).report;
    EXPECT_FALSE(report.pass) << controller;
    EXPECT_TRUE(Says(report.reason, reason)) << controller << ": " << report.reason;
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, BrokenFile, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

bool Has(const Laws& laws, Law law) { return std::find(laws.begin(), laws.end(), law) != laws.end(); }

TEST_P(BrokenFile, AFootholdMovedIsInconsistentAndTheJointsWalkAsBefore) {
  MotionPlan plan = bench().plan;
  plan.footsteps.footholds[MiddleFoothold(plan)].X_WF.translation().x() -= 0.05;
  EXPECT_EQ(BrokenLaws(model(), plan), Laws{Law::kConsistency});
  ExpectNoMatterInPhysics(plan);
}

TEST_P(BrokenFile, AZmpReferenceShiftedOutIsNamedAndTheJointsWalkAsBefore) {
  MotionPlan plan = bench().plan;
  for (Vector2& p_WZ : plan.centroidal.p_WZ) p_WZ.y() += 0.05;
  EXPECT_EQ(BrokenLaws(model(), plan), (Laws{Law::kConsistency, Law::kZmpSupport}));
  ExpectNoMatterInPhysics(plan);
}

TEST_P(BrokenFile, AccelerationsThatPutTheZmpOutAreNamedAndTheJointsWalkAsBefore) {
  MotionPlan plan = bench().plan;
  for (VectorX& a : plan.whole_body.a) a[1] += 0.05 * kGravity / plan.centroidal.p_WC[0].z();
  EXPECT_EQ(BrokenLaws(model(), plan), (Laws{Law::kConsistency, Law::kZmpSupport, Law::kDynamics}));
  ExpectNoMatterInPhysics(plan);
}

TEST_P(BrokenFile, PositionsOfASwingThroughTheGroundScuff) {
  MotionPlan plan = bench().plan;
  plan.whole_body.q = WithSwingsThroughTheGround(bench(), 0).whole_body.q;
  const Laws laws = BrokenLaws(model(), plan);
  EXPECT_EQ(laws.front(), Law::kConsistency);
  EXPECT_TRUE(Has(laws, Law::kFootClearance));
  ExpectFails(plan, "joint-pd", "'" + model().feet[0].name + "' stayed on the ground after its swing began");
}

TEST_P(BrokenFile, AJointPastItsLimitFallsAndIsBlamed) {
  MotionPlan plan = bench().plan;
  const Leg& leg = model().legs[0];
  const int dof = model().joints[static_cast<std::size_t>(leg.knee_joint)].dof;
  const double past = leg.knee_sign > 0.0 ? model().dof_upper(dof) + 0.1 : model().dof_lower(dof) - 0.1;
  for (VectorX& q : plan.whole_body.q) q[7 + dof] = past;
  const Laws laws = BrokenLaws(model(), plan);
  EXPECT_EQ(laws.front(), Law::kConsistency);
  EXPECT_TRUE(Has(laws, Law::kJointPosition));
  const std::string& name = model().dof_names[static_cast<std::size_t>(dof)];
  ExpectFails(plan, "joint-pd", "the plan itself moves '" + name + "' past its limit, by up to 0.100 rad");
}

TEST_P(BrokenFile, ForcesOutsideTheConeMatterToTheControllerThatUsesThem) {
  MotionPlan plan = bench().plan;
  for (auto& wrenches : plan.whole_body.wrenches) {
    for (ContactWrench& wrench : wrenches) wrench.force_W.x() += wrench.force_W.z();
  }
  EXPECT_EQ(BrokenLaws(model(), plan), (Laws{Law::kFrictionCone, Law::kDynamics}));
  EXPECT_TRUE(Played(model(), plan, "joint-pd").report.pass) << "it replays joints only";
  ExpectFails(plan, "stabilised", "a tangential force of up to");
}

TEST_P(BrokenFile, TorquesDoubledLiftFeetAndAreBlamed) {
  MotionPlan plan = bench().plan;
  for (VectorX& tau : plan.whole_body.tau) tau *= 2.0;
  const Laws laws = BrokenLaws(model(), plan);
  EXPECT_EQ(laws.front(), Law::kDynamics);
  EXPECT_TRUE(laws.size() == 1 || laws == (Laws{Law::kDynamics, Law::kJointTorque}));
  for (const char* controller : {"joint-pd", "stabilised"})
    ExpectFails(plan, controller, "the plan's torques do not match its motion");
}

}  // namespace
}  // namespace gaitwright
