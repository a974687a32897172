// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>

#include "kinematics/base/result.h"
#include "playback/control/joint_pd.h"
#include "playback/play/make_world.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

JointCommand Hold(const RobotModel& model, const VectorX& joints, double stiffness, double damping) {
  const VectorX zero = VectorX::Zero(model.num_dofs());
  return {joints, zero, zero, VectorX::Constant(model.num_dofs(), stiffness),
          VectorX::Constant(model.num_dofs(), damping)};
}

Vector3 TotalForce(const World& world) {
  Vector3 force = Vector3::Zero();
  for (const FootContact& foot : world.feet()) force += foot.wrench.force_W;
  return force;
}

/// Centre of pressure of all feet on level ground.
Vector2 CentreOfPressure(const World& world) {
  Vector2 moment = Vector2::Zero();
  for (const FootContact& foot : world.feet()) {
    const Vector3 about_origin = foot.wrench.moment_W + foot.p_W.cross(foot.wrench.force_W);
    moment += Vector2(-about_origin.y(), about_origin.x());
  }
  return moment / TotalForce(world).z();
}

/// High above the ground.
VectorX Airborne(const RobotModel& model) {
  VectorX q = StandingConfiguration(model);
  q[2] += 5.0;
  return q;
}

/// Laws and known answers that hold in each engine; parameters: robot and engine.
class WorldTest : public ::testing::TestWithParam<std::tuple<const char*, std::string>> {
 protected:
  std::unique_ptr<World> Make(const Terrain& terrain, const VectorX& q, WorldOptions options) const {
    options.engine = std::get<1>(GetParam());
    return MakeWorld(model_, terrain, q, options);
  }

  bool is_bullet() const { return std::get<1>(GetParam()) == "bullet"; }

  const RobotModel model_ = standing::Load(std::get<0>(GetParam()));
  const VectorX zero_v_ = VectorX::Zero(model_.nv());
};

TEST_P(WorldTest, WeighsWhatTheModelSays) {
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), StandingConfiguration(model_), {});
  World& world = *made_world;
  EXPECT_NEAR(world.total_mass_kg(), model_.total_mass_kg, 1e-12);
  WorldOptions heavier;
  heavier.mass_scale = 1.2;
  const std::unique_ptr<World> made_heavy = Make(FlatTerrain(), StandingConfiguration(model_), heavier);
  World& heavy = *made_heavy;
  EXPECT_NEAR(heavy.total_mass_kg(), 1.2 * model_.total_mass_kg, 1e-12);
}

TEST_P(WorldTest, TakesAndGivesStatesInOurOrder) {
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), StandingConfiguration(model_), {});
  World& world = *made_world;
  std::srand(3);
  VectorX q = VectorX::Random(model_.nq());
  q.segment<4>(3).normalize();
  const VectorX v = VectorX::Random(model_.nv());
  world.SetState(q, v);
  EXPECT_LT((world.v() - v).norm(), 1e-13);
  EXPECT_LT((world.q() - q).norm(), 1e-13);
}

TEST_P(WorldTest, StandsStillWhereThePlanStands) {
  const MotionPlan plan = standing::Plan(model_, 2.0);
  const std::unique_ptr<World> made_world = Make(plan.terrain, plan.whole_body.q.front(), {});
  World& world = *made_world;
  JointPd controller(model_, plan);
  ControlInput input;
  Vector2 first_pressure = Vector2::Zero();
  double slide = 0.0;
  for (int k = 0; k < 2000; ++k) {
    input.q = world.q();
    input.v = world.v();
    world.Step(controller.Update(input));
    if (k == 500) first_pressure = CentreOfPressure(world);
    for (const FootContact& foot : world.feet()) {
      slide += foot.slide_m;
      if (k > 100) {
        ASSERT_TRUE(foot.touching);
        ASSERT_LT(foot.penetration_m, 1e-4);
      }
    }
    if (k > 500) {
      ASSERT_NEAR(TotalForce(world).z(), model_.weight_n(), 1e-3 * model_.weight_n());
      ASSERT_LT((CentreOfPressure(world) - first_pressure).norm(), 1e-4);
    }
  }
  EXPECT_LT(slide, is_bullet() ? 1e-5 : 1e-4) << "MuJoCo's friction gives a little until the forces are settled";
  EXPECT_LT((world.q() - plan.whole_body.q.front()).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_TRUE(world.body_contacts().empty());
}

TEST_P(WorldTest, FallsFreelyAndAPushAddsItsImpulse) {
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), Airborne(model_), {});
  World& world = *made_world;
  const JointCommand command = Hold(model_, model_.standing_joints, 50.0, 1.0);
  DynamicsScratch scratch(model_);
  const Vector3 push(3.0, -7.0, 2.0);
  for (int k = 0; k < 200; ++k) {
    if (k < 100) world.PushRobot(push);
    world.Step(command);
  }
  ForwardVelocities(model_, world.q(), world.v(), scratch);
  const Vector3 momentum = CentroidalMomentum(model_, scratch).head<3>();
  const Vector3 expected = 0.1 * push + Vector3(0.0, 0.0, -0.2 * model_.weight_n());
  EXPECT_LT((momentum - expected).norm(), 1e-3 * expected.norm());
}

TEST_P(WorldTest, MotorsAreImplicitPdWithFeedForward) {
  WorldOptions options;
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), Airborne(model_), options);
  World& world = *made_world;
  std::srand(5);
  const int n = model_.num_dofs();
  JointCommand command = Hold(model_, model_.standing_joints + 0.01 * VectorX::Random(n), 20.0, 0.4);
  command.v = 0.1 * VectorX::Random(n);
  command.tau_ff = 0.05 * VectorX::Random(n);
  world.Step(command);
  const VectorX wanted =
      command.tau_ff + 20.0 * (command.q - world.q().tail(n)) + 0.4 * (command.v - world.v().tail(n));
  for (int dof = 0; dof < n; ++dof) {
    if (world.effort_use()[dof] >= 1.0) continue;
    EXPECT_NEAR(world.tau()[dof], wanted[dof], 1e-9) << model_.dof_names[static_cast<std::size_t>(dof)];
  }
}

TEST_P(WorldTest, TorqueModeTakesTheStateAtTheStepsStart) {
  WorldOptions options;
  options.actuation = "torque";
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), Airborne(model_), options);
  World& world = *made_world;
  const int n = model_.num_dofs();
  JointCommand command = Hold(model_, model_.standing_joints + VectorX::Constant(n, 0.001), 1.0, 0.0);
  command.tau_ff = VectorX::Constant(n, 0.002);
  world.Step(command);
  EXPECT_LT((world.tau() - VectorX::Constant(n, 0.003)).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST_P(WorldTest, EffortLimitsHoldForTheSum) {
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), Airborne(model_), {});
  World& world = *made_world;
  const int n = model_.num_dofs();
  JointCommand command = Hold(model_, model_.standing_joints, 1e4, 1e2);
  int saturated = 0;
  for (int k = 0; k < 200; ++k) {
    const double swing = std::sin(0.05 * k);
    command.q = model_.standing_joints + VectorX::Constant(n, swing);
    command.tau_ff = VectorX::Constant(n, 100.0 * swing);
    world.Step(command);
    for (int dof = 0; dof < n; ++dof) {
      const double limit = model_.dof_effort_limit(dof);
      ASSERT_LE(std::abs(world.tau()[dof]), limit * (1.0 + 1e-12));
      saturated += world.effort_use()[dof] >= 1.0 ? 1 : 0;
    }
    ASSERT_TRUE(world.v().allFinite());
  }
  EXPECT_GT(saturated, 100);
}

TEST_P(WorldTest, StopsHoldTheJointLimits) {
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), Airborne(model_), {});
  World& world = *made_world;
  const int n = model_.num_dofs();
  for (int k = 0; k < 1000; ++k) {
    const double side = k < 500 ? 10.0 : -10.0;
    world.Step(Hold(model_, VectorX::Constant(n, side), 5.0, 0.1));
    for (int dof = 0; dof < n; ++dof) {
      constexpr double kBeyond = 1e-3;  // [rad]
      ASSERT_LT(world.q()[7 + dof], model_.dof_upper(dof) + kBeyond);
      ASSERT_GT(world.q()[7 + dof], model_.dof_lower(dof) - kBeyond);
    }
  }
}

TEST_P(WorldTest, ContactForcesExplainTheChangeOfMomentum) {
  const MotionPlan plan = standing::Plan(model_, 1.0);
  const std::unique_ptr<World> made_world = Make(plan.terrain, plan.whole_body.q.front(), {});
  World& world = *made_world;
  JointPd controller(model_, plan);
  DynamicsScratch scratch(model_);
  Vector3 momentum = Vector3::Zero();
  for (int k = 0; k < 400; ++k) {
    JointCommand command = controller.Update({});
    command.q.array() += 0.03 * std::sin(0.02 * k);
    world.Step(command);
    ForwardVelocities(model_, world.q(), world.v(), scratch);
    const Vector3 now = CentroidalMomentum(model_, scratch).head<3>();
    const Vector3 force = (now - momentum) / 1e-3 + Vector3(0.0, 0.0, model_.weight_n());
    momentum = now;
    ASSERT_LT((TotalForce(world) - force).norm(), 0.01 * model_.weight_n()) << "at step " << k;
  }
}

TEST_P(WorldTest, FrictionStaysInItsCone) {
  const MotionPlan plan = standing::Plan(model_, 1.0);
  WorldOptions slippery;
  slippery.friction = 0.05;
  const std::unique_ptr<World> made_world = Make(plan.terrain, plan.whole_body.q.front(), slippery);
  World& world = *made_world;
  JointPd controller(model_, plan);
  double most = 0.0;
  for (int k = 0; k < 300; ++k) {
    world.PushRobot(Vector3(0.0, 0.08 * model_.weight_n(), 0.0));
    world.Step(controller.Update({}));
    for (const FootContact& foot : world.feet()) {
      if (!foot.touching) continue;
      ASSERT_LE(foot.tangential_n, 0.05 * foot.normal_n * (1.0 + 1e-9));
      most = std::max(most, foot.tangential_n / foot.normal_n);
    }
  }
  EXPECT_NEAR(most, 0.05, 1e-6);
  EXPECT_GT(world.v()[1], 0.01) << "it slides";
}

TEST_P(WorldTest, ALockedRobotSlidesDownASlope) {
  WorldOptions options;
  options.friction = 0.1;
  options.ground_slope_deg = 15.0;
  for (int dof = 0; dof < model_.num_dofs(); ++dof) options.locked_dofs.push_back(dof);
  const VectorX q0 = StandingConfiguration(model_);
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), q0, options);
  World& world = *made_world;
  const Pose X_tilt = GroundTilt(FlatTerrain(), options, q0.head<2>());
  VectorX q = q0;
  q.head<3>() = X_tilt * Vector3(q0.head<3>());
  q.segment<4>(3) = Quaternion(X_tilt.linear()).coeffs();
  world.SetState(q, zero_v_);
  const JointCommand command = Hold(model_, model_.standing_joints, 0.0, 0.0);
  for (int k = 0; k < 100; ++k) world.Step(command);
  const double v100 = world.v().head<3>().norm();
  double slide = 0.0;
  for (int k = 0; k < 100; ++k) {
    world.Step(command);
    for (const FootContact& foot : world.feet()) slide += foot.slide_m;
  }
  const double slope = 15.0 * std::numbers::pi / 180.0;
  const double expected = kGravity * (std::sin(slope) - 0.1 * std::cos(slope));
  EXPECT_NEAR((world.v().head<3>().norm() - v100) / 0.1, expected, 0.02 * expected);
  EXPECT_LT(world.v()[0], 0.0) << "positive slopes are uphill ahead";
  EXPECT_GT(slide, 1e-5);
  EXPECT_EQ((world.q().tail(model_.num_dofs()) - model_.standing_joints).norm(), 0.0);
}

TEST_P(WorldTest, StandsOnBoundedPatchesAndPlates) {
  Terrain block = FlatTerrain();
  block.patches[0].outline_T = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  WorldOptions plates;
  plates.sole_contact = "plate";
  const MotionPlan plan = standing::Plan(model_, 1.0);
  for (const auto& [terrain, options] : {std::pair{block, WorldOptions{}}, std::pair{FlatTerrain(), plates}}) {
    const std::unique_ptr<World> made_world = Make(terrain, plan.whole_body.q.front(), options);
    World& world = *made_world;
    JointPd controller(model_, plan);
    for (int k = 0; k < 1000; ++k) {
      world.Step(controller.Update({}));
      if (k < 300) continue;
      ASSERT_NEAR(TotalForce(world).z(), model_.weight_n(), 0.01 * model_.weight_n()) << "at step " << k;
      for (const FootContact& foot : world.feet()) ASSERT_LT(foot.penetration_m, 1e-4);
    }
    EXPECT_LT((world.q() - plan.whole_body.q.front()).lpNorm<Eigen::Infinity>(), 2e-3);
  }
}

TEST_P(WorldTest, StandsOnBumps) {
  WorldOptions options;
  options.ground_bumps_m = 0.02;
  const MotionPlan plan = standing::Plan(model_, 1.0);
  const std::unique_ptr<World> made_world = Make(plan.terrain, plan.whole_body.q.front(), options);
  World& world = *made_world;
  JointPd controller(model_, plan);
  for (int k = 0; k < 500; ++k) world.Step(controller.Update({}));
  EXPECT_NEAR(TotalForce(world).z(), model_.weight_n(), 0.01 * model_.weight_n());
  EXPECT_TRUE(world.body_contacts().empty());
}

TEST_P(WorldTest, RefusesWhatDoesNotFit) {
  const VectorX q = StandingConfiguration(model_);
  const std::unique_ptr<World> made_world = Make(FlatTerrain(), q, {});
  World& world = *made_world;
  JointCommand command = Hold(model_, model_.standing_joints, 1.0, 1.0);
  command.tau_ff[0] = std::nan("");
  EXPECT_THROW(world.Step(command), InvalidArgument);
  command = Hold(model_, model_.standing_joints, -1.0, 1.0);
  EXPECT_THROW(world.Step(command), InvalidArgument);
  command.q.resize(1);
  EXPECT_THROW(world.Step(command), InvalidArgument);
  EXPECT_THROW(Make(FlatTerrain(), VectorX::Zero(3), {}), InvalidArgument);
  WorldOptions options;
  options.locked_dofs = {99};
  EXPECT_THROW(Make(FlatTerrain(), q, options), InvalidArgument);
  options = {};
  options.actuation = "magic";
  EXPECT_THROW(Make(FlatTerrain(), q, options), InvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Engines, WorldTest,
                         ::testing::Combine(::testing::Values("a1", "nao"), ::testing::ValuesIn(EngineNames())),
                         [](const auto& i) { return std::get<0>(i.param) + ("_" + std::get<1>(i.param)); });

}  // namespace
}  // namespace gaitwright
