// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "kinematics/model/upper_body.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/follow_weights_internal.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {
namespace {

const char kFile[] = R"(
always: {arms: 2, base_orientation: 3}
during:
  - {start_s: 1.0, end_s: 2.0, arms: 8, hands: 40}
  - {start_s: 1.5, end_s: 3.0, hands: 5}
hands_in: base
)";

FollowWeights Read(const std::string& robot, const std::string& text) {
  const Result<FollowWeights> weights = ReadFollowWeights(NamedRobot(robot), text, "weights.yaml");
  EXPECT_TRUE(weights.ok()) << (weights.ok() ? "" : weights.failure().message);
  return weights ? *weights : FollowWeights{};
}

void ExpectRefused(const std::string& robot, const std::string& text, const std::string& message) {
  const Result<FollowWeights> weights = ReadFollowWeights(NamedRobot(robot), text, "weights.yaml");
  ASSERT_FALSE(weights.ok()) << text;
  EXPECT_EQ(weights.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(weights.failure().message, "'weights.yaml': " + message);
}

TEST(FollowWeights, HoldOverTimeAndTheLastRangeCounts) {
  const FollowWeights weights = Read("h1", kFile);
  EXPECT_TRUE(weights.hands_in_base);
  EXPECT_EQ(weights.Of("arms", 0.5, 1.0), 2.0);
  EXPECT_EQ(weights.Of("arms", 1.7, 1.0), 8.0);
  EXPECT_EQ(weights.Of("hands", 0.5, 0.0), 0.0);
  EXPECT_EQ(weights.Of("hands", 1.2, 0.0), 40.0);
  EXPECT_EQ(weights.Of("hands", 1.7, 0.0), 5.0);
  EXPECT_EQ(weights.Of("legs", 1.7, 1.0), 1.0);
  EXPECT_FALSE(Read("h1", "always: {arms: 2}").hands_in_base);
}

TEST(FollowWeights, AreRefusedWithTheNamesThatExist) {
  const std::string all = "legs, arms, torso, head, base_position, base_orientation, hands";
  ExpectRefused("h1", "always: {amrs: 2}", "line 1: unknown group 'amrs'; groups: " + all);
  ExpectRefused(
      "h1", "always:\n  feet: 2",
      "line 2: feet have no weight, because they follow the clean contacts and swings exactly; groups: " + all);
  ExpectRefused("a1", "always: {arms: 2}",
                "line 1: robot 'a1' has no arms; its groups: legs, base_position, base_orientation");
  ExpectRefused("h1", "during: [{start_s: 2, end_s: 1, arms: 2}]",
                "line 1: end_s is 1 and start_s 2; the end must be later");
  ExpectRefused("h1", "hands_in: room", "line 1: hands_in is 'room'; accepted: world, base");
  for (const char* text : {"always: {arms: -1}", "always: {arms: many}", "during: [{arms: 2}]", "sometimes: {arms: 2}",
                           "always: [", "always: 3"})
    EXPECT_FALSE(ReadFollowWeights(NamedRobot("h1"), text, "weights.yaml").ok()) << text;
}

/// A humanoid that stands and swings its left arm faster than its motors like.
RepairRequest FastArms(const RobotModel& model, const std::string& weights) {
  EvenMotion motion = synthetic::Standing(model, 101);
  const int dof = FindUpperBody(model).left_arm->dofs.front();
  for (int k = 0; k < motion.size(); ++k) {
    const double inside = std::pow(std::sin(M_PI * k / 100.0), 2.0);
    motion.q[static_cast<std::size_t>(k)][7 + dof] -= 0.7 * inside * std::sin(0.14 * k);
    motion.q[static_cast<std::size_t>(k)][1] += 0.02 * inside;
  }
  std::ofstream(ScratchFile("arms.csv")) << synthetic::FramesOf(model, motion);
  std::ofstream(ScratchFile("weights.yaml")) << weights;
  RepairRequest request;
  request.source.file = ScratchFile("arms.csv");
  request.source.options.rate_hz = 100.0;
  request.repair.effort = 20.0;
  if (!weights.empty()) request.weights_file = ScratchFile("weights.yaml");
  return request;
}

/// Root mean square over time of the left arm's distance from the file, of its joints and of its end relative to the
/// base.
struct ArmError {
  double joints_rad = 0.0, hand_m = 0.0;
};

ArmError ErrorWith(const std::string& weights) {
  const RobotModel& model = NamedRobot("h1");
  const RepairRequest request = FastArms(model, weights);
  const Result<RepairedMotion> repaired = RepairMotion(model, request);
  EXPECT_TRUE(repaired.ok()) << (repaired.ok() ? "" : repaired.failure().message);
  ArmError error;
  if (!repaired) return error;
  const UpperBody upper = FindUpperBody(model);
  const int dof = upper.left_arm->dofs.front();
  DynamicsScratch scratch(model);
  const auto hand = [&](const VectorX& q) -> Vector3 {
    ForwardKinematics(model, q, scratch);
    const auto body = static_cast<std::size_t>(upper.left_arm->end_body);
    return scratch.R_WB[0].transpose() *
           (scratch.p_WB[body] + scratch.R_WB[body] * upper.left_arm->p_BE - scratch.p_WB[0]);
  };
  const WholeBodyTrajectory& motion = repaired->plan.whole_body;
  for (int k = 0; k < motion.size(); ++k) {
    const double at = k * motion.step_s / 0.01, inside = std::pow(std::sin(M_PI * at / 100.0), 2.0);
    VectorX wanted = StandingConfiguration(model);
    wanted[7 + dof] -= 0.7 * inside * std::sin(0.14 * at);
    const VectorX& q = motion.q[static_cast<std::size_t>(k)];
    error.joints_rad += std::pow(q[7 + dof] - wanted[7 + dof], 2.0) / motion.size();
    error.hand_m += (hand(q) - hand(wanted)).squaredNorm() / motion.size();
  }
  return {std::sqrt(error.joints_rad), std::sqrt(error.hand_m)};
}

TEST(FollowWeights, BringArmsAndHandsNearer) {
  const ArmError usual = ErrorWith(""), arms = ErrorWith("always: {arms: 10}"),
                 hands = ErrorWith("always: {hands: 100}\nhands_in: base");
  EXPECT_GT(usual.joints_rad, 1e-3);
  EXPECT_LT(arms.joints_rad, 0.5 * usual.joints_rad);
  EXPECT_LT(hands.hand_m, 0.5 * usual.hand_m);
}

TEST(FollowWeights, SetFactorsByCoordinateAndPlacesOfHands) {
  const RobotModel& model = NamedRobot("h1");
  BodyProblem problem;
  problem.model = &model;
  const VectorX q = StandingConfiguration(model), none = VectorX::Zero(model.nv());
  problem.chart = TurningChart(TurningChart::First::kYaw, BaseRotation(q));
  problem.knots.resize(2);
  for (BodyKnot& knot : problem.knots) knot.reference = JetOf(problem.chart, q, none, none, none);
  SetWeights(Read("h1", kFile), {0.5, 1.2}, problem);
  const UpperBody upper = FindUpperBody(model);
  const VectorX &before = problem.knots[0].near_scale, &during = problem.knots[1].near_scale;
  EXPECT_EQ(before[0], 1.0);
  EXPECT_EQ(before[3], 3.0);
  EXPECT_EQ(before[6 + upper.left_arm->dofs.front()], 2.0);
  EXPECT_EQ(during[6 + upper.right_arm->dofs.back()], 8.0);
  EXPECT_EQ(during[6 + model.joints[static_cast<std::size_t>(model.legs[0].joints[0])].dof], 1.0);
  EXPECT_TRUE(problem.knots[0].points.empty());
  ASSERT_EQ(problem.knots[1].points.size(), 2U);
  const PointGoal& hand = problem.knots[1].points.front();
  EXPECT_EQ(hand.body, upper.left_arm->end_body);
  EXPECT_EQ(hand.weight, 40.0);
  EXPECT_TRUE(hand.in_base);
  EXPECT_GT(hand.p_W.y(), 0.1) << "to the left of the base";
}

}  // namespace
}  // namespace gaitwright
