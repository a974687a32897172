// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/foot_contact.h"
#include "playback/bullet/bullet_world.h"
#include "playback/control/joint_pd.h"
#include "playback/log/log_json.h"
#include "playback/play/play.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

class OffPlanTest : public testing::Test {
 protected:
  PlaybackLog StandOffPlan(const PlayOptions& options) const {
    JointPd controller(model_, plan_);
    return Play(model_, plan_, controller, options).value();
  }
  /// Centre of pressure of the feet, as the force-weighted mean, at the end.
  Vector2 Zmp(const PlaybackLog& log) const {
    DynamicsScratch scratch(model_);
    const LogSample& s = log.samples.back();
    ForwardKinematics(model_, s.q, scratch);
    Vector2 sum = Vector2::Zero();
    double force = 0.0;
    for (std::size_t i = 0; i < s.wrenches.size(); ++i) {
      const Vector3 p = ContactFrame(model_, scratch, static_cast<int>(i)).translation();
      const Vector3 &f = s.wrenches[i].force_W, &m = s.wrenches[i].moment_W;
      sum += f.z() * p.head<2>() + Vector2(-m.y(), m.x());
      force += f.z();
    }
    return sum / force;
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = standing::Plan(model_, 0.6);
};

TEST_F(OffPlanTest, AShiftOfTheBasesMassMovesWhereTheFeetPress) {
  PlayOptions options;
  const Vector2 plain = Zmp(StandOffPlan(options));
  options.world.com_shift_x_m = 0.02;
  options.world.com_shift_y_m = -0.01;
  const Vector2 moved = Zmp(StandOffPlan(options)) - plain;
  const double share = model_.bodies[0].mass / model_.total_mass_kg;
  EXPECT_NEAR(moved.x(), 0.02 * share, 0.15 * 0.02 * share);
  EXPECT_NEAR(moved.y(), -0.01 * share, 0.15 * 0.01 * share);
}

TEST_F(OffPlanTest, InertiaTurnsSlowerByItsFactor) {
  const VectorX q = plan_.whole_body.q.front();
  const auto spin = [&](double scale) {
    WorldOptions options;
    options.inertia_scale = scale;
    BulletWorld world(model_, FlatTerrain(), q, options);
    return world.Accelerations(q, VectorX::Zero(model_.nv()), VectorX::Constant(model_.num_dofs(), 1.0));
  };
  const double one = spin(1.0).tail(model_.num_dofs()).norm(), four = spin(4.0).tail(model_.num_dofs()).norm();
  EXPECT_LT(four, 0.9 * one);
  EXPECT_GT(four, 0.2 * one);
}

TEST_F(OffPlanTest, SlopesRiseInTheGivenDirection) {
  WorldOptions options;
  options.ground_slope_deg = 5.0;
  const double rise = std::tan(5.0 * M_PI / 180.0);
  for (const double deg : {0.0, 90.0, 210.0}) {
    options.ground_slope_direction_deg = deg;
    const Vector3 n = GroundTilt(FlatTerrain(), options, Vector2::Zero()).linear() * Vector3::UnitZ();
    const Vector2 uphill(std::cos(deg * M_PI / 180.0), std::sin(deg * M_PI / 180.0));
    EXPECT_NEAR(-n.head<2>().dot(uphill) / n.z(), rise, 1e-12);
    EXPECT_NEAR(n.head<2>().dot(Vector2(-uphill.y(), uphill.x())), 0.0, 1e-12);
  }
}

TEST_F(OffPlanTest, AShortPushHasItsImpulseAndOneForNoTimeNone) {
  const auto pushed = [&](double force_n, double at_s, double for_s) {
    PlayOptions options;
    options.push_force_W.y() = force_n;
    options.push_at_s = at_s;
    options.push_for_s = for_s;
    return StandOffPlan(options).samples.back().q;
  };
  const VectorX plain = StandOffPlan({}).samples.back().q, step = pushed(200.0, 0.1, 0.001);
  EXPECT_NE(plain, step);
  EXPECT_LT((pushed(500.0, 0.1, 0.0004) - step).norm(), 1e-9) << "0.4 of a step";
  EXPECT_LT((pushed(500.0, 0.1004, 0.0004) - step).norm(), 1e-9);
  EXPECT_LT((pushed(200.0, 0.1005, 0.001) - step).norm(), 0.05 * (plain - step).norm()) << "over two steps";
  EXPECT_EQ(pushed(200.0, 0.1, 0.0), plain);
}

TEST_F(OffPlanTest, StartsOutOfTheGroundAndSettles) {
  PlayOptions options;
  options.start_x_m = 0.03;
  options.start_z_m = -0.05;  // would be inside the ground
  options.start_roll_rad = 0.05;
  options.start_yaw_rad = 0.1;
  options.start_joints = VectorX::Constant(model_.num_dofs(), 0.03);
  const VectorX q0 = plan_.whole_body.q.front();
  BulletWorld world(model_, plan_.terrain, q0, {});
  VectorX q = q0;
  q.z() -= 0.05;
  world.SetState(q, VectorX::Zero(model_.nv()));
  EXPECT_NEAR(world.LiftOutOfGround(q0), 0.05, 2e-5);
  const PlaybackLog log = StandOffPlan(options);
  const LogSample& first = log.samples.front();
  EXPECT_NEAR(first.q.x() - q0.x(), 0.03, 0.02);
  EXPECT_GT(std::abs(std::atan2(BaseRotation(first.q)(1, 0), BaseRotation(first.q)(0, 0))), 0.05);
  for (const StanceRecord& stance : log.stances) EXPECT_LT(stance.penetration_m, 0.002);
  EXPECT_GT(log.samples.back().q.z(), 0.8 * q0.z());
  EXPECT_LT(log.samples.back().v.norm(), 0.2);
}

TEST_F(OffPlanTest, WithoutOffsetsNothingChanges) {
  PlayOptions options;
  options.start_joints = VectorX::Zero(model_.num_dofs());
  EXPECT_TRUE(LogToJson(StandOffPlan(options)) == LogToJson(StandOffPlan({})));
}

TEST_F(OffPlanTest, ManyPushesAddUp) {
  PlayOptions one, two;
  one.push_force_W = Vector3(30.0, 0.0, 0.0);
  one.push_at_s = 0.2;
  two.more_pushes = {{Vector3(10.0, 0.0, 0.0), 0.2, 0.1, "base"}, {Vector3(20.0, 0.0, 0.0), 0.2, 0.1, "base"}};
  const auto pushed = [](const PlaybackLog& log) { return log.samples[55].q; };  // at the push's end
  const VectorX a = pushed(StandOffPlan(one)), b = pushed(StandOffPlan(two));
  EXPECT_LT((a - b).norm(), 1e-9);
  EXPECT_GT((a - pushed(StandOffPlan({}))).norm(), 1e-4);
}

TEST_F(OffPlanTest, PushesOnALinkActThere) {
  PlayOptions options;
  options.push_force_W = Vector3(0.0, 40.0, 0.0);
  options.push_at_s = 0.2;
  options.push_on = "base";
  const VectorX on_base = StandOffPlan(options).samples.back().q;
  options.push_on = model_.bodies[3].name;
  EXPECT_GT((StandOffPlan(options).samples.back().q - on_base).norm(), 1e-4);
  options.push_on = "FR_claf";
  try {
    (void)StandOffPlan(options);
    ADD_FAILURE() << "a link that there is not was pushed";
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("'FR_calf'"), std::string::npos) << error.what();
  }
}

TEST_F(OffPlanTest, WeakMotorsSag) {
  PlayOptions options;
  options.world.motor_strength = 0.1;
  options.fall_height_lowest = 0.0;
  const PlaybackLog log = StandOffPlan(options);
  EXPECT_LT(log.samples.back().q.z(), 0.9 * plan_.whole_body.q.front().z());
  EXPECT_GT(log.saturated_s.maxCoeff(), 0.1);
}

TEST_F(OffPlanTest, GainsScale) {
  GainOptions options;
  const Gains plain = DeriveGains(model_, options);
  options.stiffness_scale = 0.5;
  options.damping_scale = 2.0;
  const Gains scaled = DeriveGains(model_, options);
  EXPECT_TRUE(scaled.stiffness.isApprox(0.5 * plain.stiffness, 1e-12));
  EXPECT_TRUE(scaled.damping.isApprox(2.0 * plain.damping, 1e-12));
}

}  // namespace
}  // namespace gaitwright
