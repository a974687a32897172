// SPDX-License-Identifier: BSD-3-Clause
// Plans broken on purpose before their last stages, so that all columns agree with each other: the audit names the
// failed check and only its consequences besides, and the playback fails and gives the reason.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/workflows/walk/broken_bench.h"
#include "tests/workflows/walk/restaged_plan.h"

namespace gaitwright {
namespace {

using Laws = std::vector<Law>;

class BrokenInput : public testing::TestWithParam<std::string> {
 protected:
  const Bench& bench() const { return BenchOf(GetParam()); }
  const RobotModel& model() const { return bench().model; }
};

INSTANTIATE_TEST_SUITE_P(Robots, BrokenInput, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

Vector3 TouchdownOf(const PlaybackLog& log, const Foothold& foothold) {
  for (const StanceRecord& stance : log.stances) {
    if (stance.foot == foothold.foot && std::abs(stance.touchdown_s - foothold.touchdown_s) < 0.05)
      return stance.p_touchdown_W;
  }
  return Vector3::Constant(std::nan(""));
}

/// Vector from the centre of the stance feet of a phase to the centre of its swing feet.
Vector3 TowardsTheSwingingFeet(const MotionPlan& plan, const ContactPhase& phase, int num_feet) {
  Vector3 swinging = Vector3::Zero(), standing = Vector3::Zero();
  const int stand = std::popcount(phase.stance);
  for (int f = 0; f < num_feet; ++f) {
    const auto at = static_cast<std::size_t>(FootholdAt(plan.footsteps, f, phase.start_s));
    const Vector3 p_WF = plan.footsteps.footholds[at].X_WF.translation();
    (Contains(phase.stance, f) ? standing : swinging) += p_WF;
  }
  return swinging / (num_feet - stand) - standing / stand;
}

/// Largest ratio of tangential to normal force of a loaded foot.
double FrictionUsed(const Bench& bench) {
  double use = 0.0;
  for (const auto& wrenches : bench.plan.whole_body.wrenches) {
    for (const ContactWrench& wrench : wrenches) {
      if (wrench.force_W.z() < 0.05 * bench.model.weight_n()) continue;
      use = std::max(use, wrench.force_W.head<2>().norm() / wrench.force_W.z());
    }
  }
  return use;
}

TEST_P(BrokenInput, WhatIsMadeAnewUnbrokenPassesAndWalks) {
  const MotionPlan body = WithWholeBodyAnew(model(), bench().plan), motion = WithMotionAnew(model(), bench().plan);
  for (const MotionPlan* plan : {&bench().plan, &body, &motion}) {
    EXPECT_EQ(BrokenLaws(model(), *plan), Laws{});
    const PlayedWalk played = Played(model(), *plan);
    EXPECT_TRUE(played.report.pass) << played.report.reason;
  }
}

TEST_P(BrokenInput, AFootholdMovedBeforeTheZmpIsPlannedIsAnotherSoundWalk) {
  MotionPlan moved = bench().plan;
  const std::size_t i = MiddleFoothold(moved);
  const Foothold whole = moved.footsteps.footholds[i];
  moved.footsteps.footholds[i].X_WF.translation().x() -= 0.05;
  moved = WithMotionAnew(model(), moved);
  EXPECT_EQ(BrokenLaws(model(), moved), Laws{});
  const PlayedWalk before = Played(model(), bench().plan), after = Played(model(), moved);
  EXPECT_TRUE(after.report.pass) << after.report.reason;
  EXPECT_NEAR((TouchdownOf(after.log, whole) - TouchdownOf(before.log, whole)).x(), -0.05, 0.01);
}

TEST_P(BrokenInput, AZmpShiftedOutTipsTheRobot) {
  MotionPlan shifted = bench().plan;
  const int phase = MiddleSwingPhase(shifted);
  const Vector3 lateral = TowardsTheSwingingFeet(shifted, shifted.schedule.phases[static_cast<std::size_t>(phase)],
                                                 static_cast<int>(model().feet.size()));
  ShiftZmp({0.0, std::copysign(0.05, lateral.y())}, phase, phase, shifted);
  shifted = WithWholeBodyAnew(model(), shifted);
  EXPECT_EQ(BrokenLaws(model(), shifted), (Laws{Law::kZmpSupport, Law::kDynamics})) << "no contact forces can do it";
  const StabilityReport report = Played(model(), shifted).report;
  EXPECT_FALSE(report.pass);
  EXPECT_TRUE(Says(report.reason, "first, from")) << report.reason;
  EXPECT_TRUE(Says(report.reason, "the plan itself has its ZMP outside the support of")) << report.reason;
  EXPECT_FALSE(report.At("contact_timing_error_max_s").pass) << "feet lift or land when they should not";
}

TEST_P(BrokenInput, ASwingThroughTheGroundScuffs) {
  const MotionPlan low = WithSwingsThroughTheGround(bench(), 0);
  EXPECT_EQ(BrokenLaws(model(), low), Laws{Law::kFootClearance});
  const StabilityReport report = Played(model(), low).report;
  EXPECT_FALSE(report.pass);
  EXPECT_FALSE(report.At("scuffs").pass);
  const std::string& foot = model().feet[0].name;
  EXPECT_TRUE(Says(report.reason, "'" + foot + "' stayed on the ground after its swing began")) << report.reason;
}

TEST_P(BrokenInput, AJointThatBendsLessThanThePlannerThoughtStopsAtItsLimit) {
  RobotModel stiff = model();
  const int knee = stiff.legs[0].knee_joint, dof = stiff.joints[static_cast<std::size_t>(knee)].dof;
  double most = 0.0;
  for (const VectorX& q : bench().plan.whole_body.q) most = std::abs(q[7 + dof]) > std::abs(most) ? q[7 + dof] : most;
  Joint& joint = stiff.joints[static_cast<std::size_t>(knee)];
  (most > 0.0 ? joint.upper : joint.lower) = 0.9 * most;
  EXPECT_EQ(BrokenLaws(stiff, bench().plan), Laws{Law::kJointPosition});
  const StabilityReport report = Played(stiff, bench().plan).report;
  EXPECT_FALSE(report.pass);
  EXPECT_FALSE(report.At("joint_limit_margin_min_rad").pass);
  EXPECT_TRUE(Says(report.reason, "the plan itself moves '" + joint.name + "' past its limit")) << report.reason;
}

TEST_P(BrokenInput, AGroundMoreSlipperyThanThePlannerThoughtSlips) {
  MotionPlan ice = bench().plan;
  for (TerrainPatch& patch : ice.terrain.patches) patch.friction = 0.25 * FrictionUsed(bench());
  EXPECT_EQ(BrokenLaws(model(), ice), Laws{Law::kFrictionCone});
  EXPECT_FALSE(Played(model(), ice, "joint-pd").report.At("slip_max_step_m").pass);
  for (const char* controller : {"joint-pd", "stabilised"}) {
    const StabilityReport report = Played(model(), ice, controller).report;
    EXPECT_FALSE(report.pass);
    // In open-loop replay the foot slides on; with balance control the robot may fall before a foot has slid far.
    EXPECT_TRUE(!report.At("slip_max_step_m").pass || report.At("fell").value == 1.0) << report.reason;
    EXPECT_TRUE(Says(report.reason, "first, from")) << report.reason;
    EXPECT_TRUE(Says(report.reason, "a tangential force of up to")) << report.reason;
  }
}

TEST_P(BrokenInput, TorquesForTwiceTheMassAreNotThoseOfTheMotion) {
  RobotModel heavy = model();
  heavy.total_mass_kg *= 2.0;
  for (Joint& joint : heavy.joints) joint.effort_limit *= 2.0;
  for (Body& body : heavy.bodies) {
    body.mass *= 2.0;
    body.I_C *= 2.0;
  }
  const MotionPlan doubled = WithWholeBodyAnew(heavy, bench().plan);
  EXPECT_EQ(BrokenLaws(heavy, doubled), Laws{}) << "its columns agree";
  const Laws laws = BrokenLaws(model(), doubled);
  ASSERT_FALSE(laws.empty());
  EXPECT_EQ(laws.front(), Law::kDynamics);
  EXPECT_TRUE(laws.size() == 1 || laws == (Laws{Law::kDynamics, Law::kJointTorque}));
  const StabilityReport report = Played(model(), doubled).report;
  EXPECT_FALSE(report.pass);
  EXPECT_TRUE(Says(report.reason, "the plan's contact forces do not match its motion")) << report.reason;
}

TEST(BrokenInputOfAQuadruped, AFootholdMovedAfterTheZmpWasPlannedLeavesItOffItsLine) {
  const Bench& a1 = BenchOf("a1");
  MotionPlan moved = a1.plan;
  Pose& X_WF = moved.footsteps.footholds[MiddleFoothold(moved)].X_WF;
  X_WF.translation().y() += std::copysign(0.05, X_WF.translation().y());
  moved = WithWholeBodyAnew(a1.model, moved);
  EXPECT_EQ(BrokenLaws(a1.model, moved), (Laws{Law::kZmpSupport, Law::kDynamics}));
  const StabilityReport report = Played(a1.model, moved).report;
  EXPECT_FALSE(report.At("contact_timing_error_max_s").pass) << report.reason;
  EXPECT_TRUE(Says(report.reason, "the plan itself has its ZMP outside the support of 'FL_foot', 'RR_foot'"))
      << report.reason;
}

TEST(BrokenInputOfABiped, AZmpShiftedOutMakesItFallOnTheSideWhereNothingStands) {
  const Bench& nao = BenchOf("nao");
  MotionPlan shifted = nao.plan;
  const int phase = MiddleSwingPhase(shifted);
  const bool on_left_foot = shifted.schedule.phases[static_cast<std::size_t>(phase)].stance == 1;
  ShiftZmp({0.0, on_left_foot ? -0.06 : 0.06}, phase, phase, shifted);
  shifted = WithWholeBodyAnew(nao.model, shifted);
  for (const char* controller : {"joint-pd", "stabilised"}) {
    const StabilityReport report = Played(nao.model, shifted, controller).report;
    EXPECT_EQ(*report.At("fell").value, 1.0);
    EXPECT_TRUE(Says(report.reason, "the DCM had left the support of")) << report.reason;
    EXPECT_TRUE(Says(report.reason, on_left_foot ? "mm to the right" : "mm to the left")) << report.reason;
    EXPECT_FALSE(Says(report.reason, "do not match its motion")) << "a consequence: " << report.reason;
  }
}

TEST_P(BrokenInput, ASoundPlanIsNotBlamedForAPush) {
  PlayRequest request;
  request.controller = "joint-pd";
  request.play.push_force_W.y() = model().weight_n();
  request.play.push_at_s = 0.5 * bench().plan.duration_s();
  request.play.push_for_s = 0.2;
  const StabilityReport report = PlayWalk(model(), bench().plan, request)->report;
  EXPECT_FALSE(report.pass);
  EXPECT_FALSE(Says(report.reason, "plan itself")) << report.reason;
  EXPECT_FALSE(Says(report.reason, "the plan's")) << report.reason;
}

}  // namespace
}  // namespace gaitwright
