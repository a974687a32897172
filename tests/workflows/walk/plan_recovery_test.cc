// SPDX-License-Identifier: BSD-3-Clause
// Standing robots that are pushed: 'recovering' compared with 'stabilised'.
#include "workflows/walk/plan_recovery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// A built-in robot that stands for 4 s.
struct Stander {
  RobotModel model;
  MotionPlan plan;
};

Stander Standing(const std::string& robot) {
  Stander stander{LoadNamedRobot(robot).value(), {}};
  WalkRequest request;
  request.sequence = "stand: duration=4";
  stander.plan = PlanWalk(stander.model, request)->motion.plan;
  return stander;
}

/// The recovery plans of a robot, made once for all tests.
const RecoveryPlans& RecoveryOf(const RobotModel& model) {
  static std::map<std::string, RecoveryPlans> plans;
  const auto at = plans.find(model.name);
  return at != plans.end() ? at->second : plans.emplace(model.name, PlanRecovery(model).value()).first->second;
}

/// A push at 0.5 s for 0.1 s; its direction counts from forward to the left [degree].
PlayRequest PushRequest(const std::string& controller, double force_n, double direction_deg) {
  const double angle = direction_deg * std::numbers::pi / 180.0;
  PlayRequest request;
  request.controller = controller;
  request.play.push_force_W = force_n * Vector3(std::cos(angle), std::sin(angle), 0.0);
  request.play.push_at_s = 0.5;
  return request;
}

PlayedWalk Pushed(const Stander& stander, const std::string& controller, double force_n, double direction_deg) {
  const PlayRequest request = PushRequest(controller, force_n, direction_deg);
  std::optional<RecoveryPlans> recovery;
  if (controller == "recovering") recovery = RecoveryOf(stander.model);
  return PlayWalk(stander.model, stander.plan, request, MakeController(stander.model, stander.plan, request, recovery))
      .value();
}

bool Fell(const PlayedWalk& played) { return *played.report.At("fell").value > 0.0; }

struct RecoveryCase {
  std::string robot;
  double force_n, direction_deg;
};

class Recovering : public testing::TestWithParam<RecoveryCase> {};
INSTANTIATE_TEST_SUITE_P(Pushes, Recovering,
                         testing::Values(RecoveryCase{"humanoid", 300.0, 0.0}, RecoveryCase{"humanoid", 280.0, 90.0},
                                         RecoveryCase{"humanoid", 280.0, -90.0}, RecoveryCase{"humanoid", 125.0, 180.0},
                                         RecoveryCase{"nao", 27.0, 135.0}, RecoveryCase{"nao", 27.0, -135.0},
                                         RecoveryCase{"a1", 190.0, 0.0}, RecoveryCase{"a1", 210.0, 180.0},
                                         RecoveryCase{"a1", 210.0, 45.0}));

TEST_P(Recovering, StepsWhereStandingDoesNotDo) {
  const auto& [robot, force_n, direction_deg] = GetParam();
  const Stander stander = Standing(robot);
  EXPECT_TRUE(Fell(Pushed(stander, "stabilised", force_n, direction_deg)));
  const PlayedWalk stepped = Pushed(stander, "recovering", force_n, direction_deg);
  EXPECT_FALSE(Fell(stepped)) << stepped.report.reason;
  EXPECT_GT(stepped.log.stances.size(), stander.model.legs.size()) << "it stepped";
}

TEST(RecoveringStander, StandsStillWhereThatDoes) {
  const Stander stander = Standing("nao");
  const PlayedWalk stood =  // plans the recovery in this call
      PlayWalk(stander.model, stander.plan, PushRequest("recovering", 10.0, 0.0)).value();
  EXPECT_TRUE(stood.report.pass) << stood.report.reason;
  EXPECT_EQ(stood.log.stances.size(), 2U);
}

/// Kinetic energy at the first ground contact of a link that is not a foot [J].
double EnergyAtImpact(const RobotModel& model, const PlaybackLog& log) {
  EXPECT_FALSE(log.body_contacts.empty());
  if (log.body_contacts.empty()) return 0.0;
  DynamicsScratch scratch(model);
  MatrixX M(model.nv(), model.nv());
  double energy_j = 0.0;
  for (const LogSample& sample : log.samples) {
    if (sample.time_s > log.body_contacts.front().time_s) break;
    MassMatrix(model, sample.q, scratch, M);
    energy_j = 0.5 * sample.v.dot(M * sample.v);
  }
  return energy_j;
}

TEST(RecoveringStander, GetsDownBeforeAFallThatIsCertain) {
  const Stander stander = Standing("nao");
  for (const double direction_deg : {45.0, 90.0}) {
    const PlayedWalk upright = Pushed(stander, "stabilised", 50.0, direction_deg);
    const PlayedWalk low = Pushed(stander, "recovering", 50.0, direction_deg);
    EXPECT_TRUE(Fell(low));
    EXPECT_LT(EnergyAtImpact(stander.model, low.log), 0.7 * EnergyAtImpact(stander.model, upright.log))
        << direction_deg;
  }
}

TEST(RecoveringStander, WithoutStepsItStands) {
  const Stander stander = Standing("nao");
  RecoveryPlans without = RecoveryOf(stander.model);
  without.steps.reset();
  const PlayRequest request = PushRequest("recovering", 10.0, 0.0);
  const auto played =
      PlayWalk(stander.model, stander.plan, request, MakeController(stander.model, stander.plan, request, without));
  EXPECT_FALSE(Fell(played.value()));
}

TEST(RecoveringStander, IsForPlansThatStand) {
  const Stander stander = Standing("nao");
  WalkRequest request;
  request.command.distance_m = 0.1;
  const MotionPlan walk = PlanWalk(stander.model, request)->motion.plan;
  const RecoveryPlans& recovery = RecoveryOf(stander.model);
  EXPECT_THROW(MakeRecovering(stander.model, walk, recovery), InvalidArgument);
  RecoveryPlans other = recovery;
  other.low = VectorX::Zero(1);
  EXPECT_THROW(MakeRecovering(stander.model, stander.plan, other), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
