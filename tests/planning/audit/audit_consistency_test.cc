// SPDX-License-Identifier: BSD-3-Clause
// One column of a good plan is changed: the audit reports that it disagrees with the others, where and by how much.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kinematics/spatial/rotation.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using Laws = std::vector<Law>;

class AuditConsistency : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& good() const { return GoodPlanOf(GetParam()).plan; }
  const std::string& foot() const { return model().feet[0].name; }
  std::size_t row() const { return MidSwingRow(good()); }

  /// Changes the good plan. Only consistency may be violated then, and only at this place.
  Violation Changed(const std::string& where, const std::function<void(MotionPlan&)>& change) const {
    MotionPlan plan = good();
    change(plan);
    const auto found = ViolationsOf(model(), plan);
    EXPECT_EQ(LawsOf(found), Laws{Law::kConsistency}) << where;
    return At(found, where);
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, AuditConsistency, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

TEST_P(AuditConsistency, OfTheCentreOfMass) {
  const double row_s = TimeOf(good(), row());
  const auto expect = [&](const std::string& where, double value, const std::function<void(MotionPlan&)>& change) {
    const Violation found = Changed(where, change);
    EXPECT_NEAR(found.value, value, 1e-6) << where;
    EXPECT_NEAR(found.at_s, row_s, 1e-9) << where;
  };
  auto position = [&](MotionPlan& plan) { plan.centroidal.p_WC[row()].z() += 0.002; };
  expect("centre of mass against joints", 0.002, position);
  auto velocity = [&](MotionPlan& plan) { plan.centroidal.v_WC[row()].x() += 0.05; };
  expect("velocity of the centre of mass against joints", 0.05, velocity);
  auto acceleration = [&](MotionPlan& plan) { plan.centroidal.a_WC[row()].y() += 0.5; };
  expect("acceleration of the centre of mass against joints", 0.5, acceleration);
}

TEST_P(AuditConsistency, OfTheCentreOfMassWithItsOwnDerivatives) {
  // All rows are changed alike, so only the whole body and the other columns disagree.
  const auto velocity = [](MotionPlan& plan) {
    for (Vector3& v_WC : plan.centroidal.v_WC) v_WC.x() += 0.5;
  };
  EXPECT_NEAR(Changed("centre of mass against its velocity", velocity).value, 0.5, 1e-3);
  const auto acceleration = [](MotionPlan& plan) {
    for (Vector3& a_WC : plan.centroidal.a_WC) a_WC.x() += 5.0;
  };
  EXPECT_NEAR(Changed("velocity of the centre of mass against its acceleration", acceleration).value, 5.0, 1e-2);
}

TEST_P(AuditConsistency, OfTheReferenceOfTheZmp) {
  const auto shift = [&](MotionPlan& plan) { plan.centroidal.p_WZ[row()].x() += 0.0035; };
  const Violation found = Changed("reference of the zero-moment point against joints", shift);
  EXPECT_NEAR(found.value, 0.0035, 1e-3);
  EXPECT_NEAR(found.at_s, TimeOf(good(), row()), 1e-9);
}

TEST_P(AuditConsistency, OfThePendulumsFrequency) {
  for (const double omega : {0.0, -3.0, 1.05 * good().centroidal.omega_rad_s}) {
    const Violation found =
        Changed("frequency of the pendulum", [&](MotionPlan& p) { p.centroidal.omega_rad_s = omega; });
    EXPECT_EQ(found.value, omega);
    EXPECT_NEAR(found.limit, good().centroidal.omega_rad_s, 0.01);
  }
}

TEST_P(AuditConsistency, OfFootholds) {
  const auto index = static_cast<std::size_t>(FootholdAt(good().footsteps, 0, 1e9));
  const double touchdown_s = good().footsteps.footholds[index].touchdown_s;
  const auto changed = [&](const std::string& where, const std::function<void(Foothold&)>& change) {
    return Changed(where, [&](MotionPlan& plan) { change(plan.footsteps.footholds[index]); });
  };
  EXPECT_EQ(changed(foot() + " foothold's patch", [](Foothold& f) { f.patch = 77; }).value, 77.0);
  EXPECT_EQ(changed(foot() + " foothold's patch", [](Foothold& f) { f.patch = -1; }).at_s, touchdown_s);
  const auto raised = [](Foothold& f) { f.X_WF.translation().z() += 0.01; };
  EXPECT_NEAR(changed(foot() + " foothold off its patch", raised).value, 0.01, 1e-6);
  EXPECT_NEAR(changed(foot() + " off its foothold", raised).value, 0.01, 1e-3);
  const auto short_ground = [&](MotionPlan& plan) {  // ends a hand's breadth short of the last foothold
    const double x = good().footsteps.footholds[index].X_WF.translation().x() - 0.1;
    plan.terrain.patches[0].outline_T = {{x - 9.0, -9.0}, {x, -9.0}, {x, 9.0}, {x - 9.0, 9.0}};
  };
  MotionPlan beyond = good();
  short_ground(beyond);
  EXPECT_NEAR(At(ViolationsOf(model(), beyond), foot() + " foothold off its patch").value, 0.1, 1e-6);
  const auto tilted = [](Foothold& f) { f.X_WF.linear() *= RotationExp({0.1, 0.0, 0.0}); };
  EXPECT_NEAR(changed(foot() + " foothold tilted from its patch", tilted).value, 0.1, 1e-3);
  const auto early = [](Foothold& f) { f.touchdown_s -= 0.01; };
  EXPECT_NEAR(changed(foot() + " foothold's touch-down against schedule", early).value, touchdown_s - 0.01, 1e-9);
}

TEST_P(AuditConsistency, OfJointsWithTheirVelocities) {
  MotionPlan plan = good();
  const int dof = model().num_dofs() - 1;
  plan.whole_body.v[row()][6 + dof] += 0.1;
  const Violation found = At(ViolationsOf(model(), plan), model().dof_names.back() + " position against velocity");
  EXPECT_NEAR(found.value, 0.05, 1e-3) << "half of it in a mean over a step";
  EXPECT_NEAR(found.at_s, TimeOf(plan, row()), 1.01 * plan.whole_body.step_s);
}

TEST_P(AuditConsistency, OfTheGaitAndTheSchedule) {
  EXPECT_EQ(
      Changed("number of the gait's phases", [](MotionPlan& plan) { plan.parts.front().gait.phase = {0.0}; }).value,
      1.0);
  const auto late = [](MotionPlan& plan) { plan.schedule.phases.back().end_s += 0.5; };
  EXPECT_NEAR(Changed("end of the schedule", late).value, 0.5, 0.01);
}

TEST_P(AuditConsistency, OfThePartsWithTheGridAndEachOther) {
  EXPECT_NEAR(Changed("start of a part", [](MotionPlan& plan) { plan.parts.front().start_s += 0.3; }).value, 0.3, 1e-9);
  const auto early = [](MotionPlan& plan) { plan.parts.front().end_s -= 0.3; };
  EXPECT_NEAR(Changed("end of the last part", early).value, 0.3, 1e-9);
  EXPECT_NEAR(Changed("goal against the last part's", [](MotionPlan& plan) { plan.goal.x_m += 0.1; }).value, 0.1, 1e-9);
  const auto standing = [](MotionPlan& plan) {
    plan.parts.front().gait = StandingGait(plan.parts.front().gait.num_feet());
  };
  EXPECT_LT(Changed("feet on the ground while the robot stands", standing).value,
            static_cast<double>(model().feet.size()));
  EXPECT_NEAR(Changed("goal of standing still", standing).value, good().goal.x_m, 5e-3);
}

TEST_P(AuditConsistency, OfTheGoalWithACommandOfDistance) {
  const auto farther = [](MotionPlan& plan) { plan.parts.front().command.distance_m = 9.0; };
  EXPECT_NEAR(Changed("goal against the command's distance", farther).value,
              9.0 - good().parts.front().command.distance_m, 5e-3);
  const auto lateral = [](MotionPlan& plan) { plan.parts.front().goal.y_m += 0.05; };
  EXPECT_NEAR(Changed("goal against the command's distance", lateral).value, 0.05, 5e-3);
  const auto turned = [](MotionPlan& plan) { plan.parts.front().goal.yaw_rad += 0.1; };
  EXPECT_NEAR(Changed("goal against the command's distance, heading", turned).value, 0.1, 1e-3);
}

TEST_P(AuditConsistency, OfTheGoalWithOtherCommands) {
  MotionPlan plan = good();
  plan.parts.front().command = {};
  plan.parts.front().command.extent = WalkCommand::Extent::kGoal;
  plan.parts.front().command.goal_x_m = plan.goal.x_m;
  EXPECT_EQ(ViolationsOf(model(), plan), std::vector<Violation>{});
  plan.parts.front().command.goal_x_m += 0.05;
  EXPECT_NEAR(At(ViolationsOf(model(), plan), "goal against the command's pose").value, 0.05, 5e-3);
  plan.parts.front().command = {};
  plan.parts.front().command.extent = WalkCommand::Extent::kSteps;
  plan.parts.front().command.steps = 10;
  plan.parts.front().command.step_length_m = plan.goal.x_m / 9.0;
  EXPECT_EQ(ViolationsOf(model(), plan), std::vector<Violation>{});
  plan.parts.front().command.steps = 20;
  EXPECT_EQ(At(ViolationsOf(model(), plan), "goal against the command's steps").limit,
            20 * plan.parts.front().command.step_length_m);
}

TEST(AuditConsistencyOfCurves, HoldsForArcsAndCrawls) {
  const RobotModel& a1 = GoodPlanOf("a1").model;
  WalkCommand arc;
  arc.speed_m_s = 0.3;
  arc.yaw_rate_rad_s = 0.5;
  arc.distance_m = 0.5;
  WalkCommand slanted = arc;
  slanted.lateral_speed_m_s = -0.1;
  for (const WalkCommand& command : {arc, slanted}) {
    MotionPlan plan = PlanOf(a1, "trot", command);
    EXPECT_EQ(ViolationsOf(a1, plan), std::vector<Violation>{});
    plan.parts.front().command.yaw_rate_rad_s = -arc.yaw_rate_rad_s;
    EXPECT_EQ(LawsOf(ViolationsOf(a1, plan)), Laws{Law::kConsistency});
  }
  WalkCommand crawl;
  crawl.speed_m_s = 0.1;
  crawl.distance_m = 0.15;
  EXPECT_EQ(ViolationsOf(a1, PlanOf(a1, "walk", crawl)), std::vector<Violation>{});
}

TEST(AuditedRows, ThatAreNotTheRobotsAreRefused) {
  const GoodPlan& good = GoodPlanOf("a1");
  const auto why = [&](const std::function<void(MotionPlan&)>& change) {
    MotionPlan plan = good.plan;
    change(plan);
    const Result<AuditReport> report = Audit(good.model, plan, {});
    return report.ok() ? std::string() : report.failure().message;
  };
  const std::string start = "the plan does not fit robot 'a1': ";
  EXPECT_EQ(why([](MotionPlan& p) { p.whole_body.v[5].resize(17); }),
            start + "its v has 17 numbers, but the robot needs 18");
  EXPECT_EQ(why([](MotionPlan& p) { p.whole_body.tau.resize(3); }).find(start + "it has 3 rows of tau, "), 0U);
  EXPECT_EQ(why([](MotionPlan& p) { p.whole_body.wrenches[7].pop_back(); }),
            start + "it has 3 feet, but the robot has 4");
  EXPECT_EQ(why([](MotionPlan& p) { p.schedule = {}; }), start + "the contact schedule has no phase");
}

TEST(AuditedTime, APlanThatLastsForEverIsRefused) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  plan.whole_body.step_s = 1e9;
  const Result<AuditReport> report = Audit(GoodPlanOf("a1").model, plan, {});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.failure().message.find("at most 3600 s"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
