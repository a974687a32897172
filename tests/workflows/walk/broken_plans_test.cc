// SPDX-License-Identifier: BSD-3-Clause
// Plans broken on purpose in the finished file: the audit names the check that each fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/plan/plan_json.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

class BrokenPlan : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    model_ = new RobotModel(*LoadNamedRobot("a1"));
    WalkRequest request;
    request.command.speed_m_s = 0.3;
    request.command.distance_m = 0.6;
    plan_ = new MotionPlan(PlanWalk(*model_, request)->motion.plan);
  }
  static void TearDownTestSuite() {
    delete plan_;
    delete model_;
  }

  static std::vector<Law> Broken(const MotionPlan& plan) {
    std::vector<Law> laws;
    const AuditReport report = *Audit(*model_, plan, {});
    for (const Violation& violation : report.violations) laws.push_back(violation.law);
    return laws;
  }
  static void ExpectNames(const MotionPlan& plan, Law law) {
    const auto laws = Broken(plan);
    EXPECT_NE(std::find(laws.begin(), laws.end(), law), laws.end()) << law;
  }

  /// A sample in the middle of a swing of foot 0.
  static std::size_t MidSwing() {
    for (const SwingTrajectory& swing : plan_->swings) {
      if (swing.foot == 0)
        return static_cast<std::size_t>(0.5 * (swing.start_s + swing.end_s) / plan_->whole_body.step_s);
    }
    return 0;
  }

  static const RobotModel* model_;
  static const MotionPlan* plan_;
};
const RobotModel* BrokenPlan::model_ = nullptr;
const MotionPlan* BrokenPlan::plan_ = nullptr;

TEST_F(BrokenPlan, TheWholeOnePasses) {
  const AuditReport report = *Audit(*model_, *plan_, {});
  EXPECT_TRUE(report.pass()) << AuditText(report);
}

TEST_F(BrokenPlan, FootholdMoved) {
  MotionPlan plan = *plan_;
  plan.footsteps.footholds[6].X_WF.translation().x() += 0.05;
  ExpectNames(plan, Law::kConsistency);
}

TEST_F(BrokenPlan, ZmpShiftedOut) {
  MotionPlan plan = *plan_;
  for (VectorX& a : plan.whole_body.a) a[1] += 0.05 * kGravity / plan.centroidal.p_WC[0].z();
  ExpectNames(plan, Law::kZmpSupport);
}

TEST_F(BrokenPlan, SwingThroughTheGround) {
  MotionPlan plan = *plan_;
  for (std::size_t k = MidSwing() - 5; k < MidSwing() + 5; ++k) plan.whole_body.q[k][2] -= 0.08;
  ExpectNames(plan, Law::kFootClearance);
}

TEST_F(BrokenPlan, JointPastItsLimit) {
  MotionPlan plan = *plan_;
  for (VectorX& q : plan.whole_body.q) q[7] = model_->dof_upper(0) + 0.1;
  ExpectNames(plan, Law::kJointPosition);
}

TEST_F(BrokenPlan, ForcesOutsideTheCone) {
  MotionPlan plan = *plan_;
  for (auto& wrenches : plan.whole_body.wrenches) {
    for (ContactWrench& wrench : wrenches) wrench.force_W.x() += wrench.force_W.z();
  }
  ExpectNames(plan, Law::kFrictionCone);
}

TEST_F(BrokenPlan, TorqueDoubled) {
  MotionPlan plan = *plan_;
  for (VectorX& tau : plan.whole_body.tau) tau *= 2.0;
  ExpectNames(plan, Law::kDynamics);
}

TEST_F(BrokenPlan, PullingForce) {
  MotionPlan plan = *plan_;
  plan.whole_body.wrenches[10][0].force_W.z() = -5.0;
  ExpectNames(plan, Law::kUnilateral);
}

TEST_F(BrokenPlan, NotANumber) {
  MotionPlan plan = *plan_;
  plan.whole_body.q[50][9] = std::nan("");
  EXPECT_FALSE(Broken(plan).empty());
}

TEST_F(BrokenPlan, LimitsCanBeDerated) {
  EXPECT_TRUE(Audit(*model_, *plan_, {})->pass());
  AuditOptions options;
  options.derate_torque = 0.1;
  const AuditReport report = *Audit(*model_, *plan_, options);
  ASSERT_FALSE(report.pass());
  EXPECT_EQ(report.violations[0].law, Law::kJointTorque);
}

TEST_F(BrokenPlan, FilesComeBackAsTheyWere) {
  const std::string text = PlanToJson(*plan_);
  const Result<MotionPlan> back = PlanFromJson(text, "test");
  ASSERT_TRUE(back.ok()) << back.failure().message;
  EXPECT_EQ(back->whole_body.q, plan_->whole_body.q);
  EXPECT_EQ(back->schedule, plan_->schedule);
  ASSERT_EQ(back->swings.size(), plan_->swings.size());
  EXPECT_EQ(back->swings[3].lift_m, plan_->swings[3].lift_m);
  EXPECT_TRUE(Audit(*model_, *back, {})->pass());
}

TEST_F(BrokenPlan, DetoursComeBackAndFilesWithoutThemAreRead) {
  MotionPlan plan = *plan_;
  plan.swings[1].detour_W = {{0.0, 0.01, 0.1}, {-0.02, 0.0, 0.2}, {0.0, 0.0, 0.1}};
  std::string text = PlanToJson(plan);
  EXPECT_EQ(PlanFromJson(text, "test")->swings[1].detour_W, plan.swings[1].detour_W);
  text = PlanToJson(*plan_);
  for (std::size_t at = 0; (at = text.find(",\"detour_m\":[]")) != std::string::npos;) text.erase(at, 14);
  const Result<MotionPlan> older = PlanFromJson(text, "test");
  ASSERT_TRUE(older.ok()) << older.failure().message;
  EXPECT_TRUE(older->swings[1].detour_W.empty());
}

TEST_F(BrokenPlan, CruisesComeBackAndThoseThatAreNoShareAreRefused) {
  MotionPlan plan = *plan_;
  plan.swings[1].cruise = 0.25;
  EXPECT_EQ(PlanFromJson(PlanToJson(plan), "test")->swings[1].cruise, 0.25);
  plan.swings[1].cruise = 1.0;
  const Result<MotionPlan> refused = PlanFromJson(PlanToJson(plan), "test");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.failure().message.find("'cruise' 1"), std::string::npos) << refused.failure().message;
}

TEST(Walk, A1LiftsItsFeetByDetours) {
  // More clearance in the whole middle of the swing than the closed form has at its edges.
  const RobotModel a1 = *LoadNamedRobot("a1");
  WalkRequest request;
  request.command.speed_m_s = 0.3;
  request.command.distance_m = 0.6;
  request.motion.swing.clearance_m = 0.045;
  const Result<PlannedWalk> planned = PlanWalk(a1, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  for (const SwingTrajectory& swing : planned->motion.plan.swings) {
    EXPECT_FALSE(swing.detour_W.empty());
    EXPECT_GT(swing.clearance_m, 0.0425);
  }
  const Result<PlayedWalk> played = PlayWalk(a1, planned->motion.plan, {});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

TEST_F(BrokenPlan, TruncatedForeignAndNewerFilesAreRefused) {
  const std::string text = PlanToJson(*plan_);
  const auto message = [](const std::string& t) {
    const Result<MotionPlan> plan = PlanFromJson(t, "x.json");
    return plan.ok() ? std::string() : plan.failure().message;
  };
  EXPECT_NE(message(text.substr(0, text.size() / 2)).find("cut short"), std::string::npos);
  EXPECT_NE(message("{\"a\": 1}").find("not a motion plan"), std::string::npos);
  const auto of_schema = [&](int schema) {
    const std::string own = fmt::format("\"schema\":{}", MotionPlan::kSchema);
    return std::string(text).replace(text.find(own), own.size(), fmt::format("\"schema\":{}", schema));
  };
  EXPECT_EQ(message(of_schema(MotionPlan::kSchema)), "");
  for (const int schema : {MotionPlan::kSchema - 1, MotionPlan::kSchema + 1}) {
    EXPECT_NE(message(of_schema(schema)).find(fmt::format("schema {};", schema)), std::string::npos);
  }
}

// Playback in physics.

TEST_F(BrokenPlan, TheWholeOneWalks) {
  const Result<PlayedWalk> played = PlayWalk(*model_, *plan_, {});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  EXPECT_LT(*played->report.At("goal_error_m").value, 0.01);
  EXPECT_LT(*played->report.At("zmp_error_mean_m").value, 0.01);
}

TEST_F(BrokenPlan, TheSameCommandGivesTheSameBytes) {
  WalkRequest request;
  request.command.speed_m_s = 0.3;
  request.command.distance_m = 0.6;
  EXPECT_EQ(PlanToJson(PlanWalk(*model_, request)->motion.plan), PlanToJson(*plan_));
}

TEST(Walk, NaoTakesFourSteps) {
  const RobotModel nao = *LoadNamedRobot("nao");
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.04;
  const Result<PlannedWalk> planned = PlanWalk(nao, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  PlayRequest play;
  play.controller = "joint-pd";
  const Result<PlayedWalk> played = PlayWalk(nao, planned->motion.plan, play);
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  EXPECT_GT(*played->report.At("zmp_margin_p05_m").value, 0.02);
}

}  // namespace
}  // namespace gaitwright
