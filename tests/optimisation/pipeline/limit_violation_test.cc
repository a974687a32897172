// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/limit_violation.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// One row with the standing posture, except for one joint's position or speed.
class LimitViolation : public ::testing::Test {
 protected:
  WholeBodyTrajectory With(double position, double speed = 0.0) const {
    WholeBodyTrajectory motion;
    motion.q = {StandingConfiguration(model_)};
    motion.v = {VectorX::Zero(model_.nv())};
    motion.tau = {VectorX::Zero(model_.num_dofs())};
    motion.q[0][7 + knee_] = position;
    motion.v[0][6 + knee_] = speed;
    return motion;
  }
  double ViolationSum(double position, double margin) const { return TotalViolation(model_, With(position), margin); }

  RobotModel model_ = LoadNamedRobot("a1").value();
  int knee_ = model_.DofIndex("FL_calf_joint");
  double upper_ = model_.dof_upper(knee_), range_ = upper_ - model_.dof_lower(knee_);
};

TEST_F(LimitViolation, IsASumOfSharesOfTheLimits) {
  EXPECT_EQ(ViolationSum(upper_ - 1e-9, 0.0), 0.0);
  EXPECT_NEAR(ViolationSum(upper_ + 0.1 * range_, 0.0), 0.1, 1e-9);
  const double fast = 1.5 * model_.dof_velocity_limit(knee_);
  EXPECT_NEAR(TotalViolation(model_, With(upper_ + 0.1 * range_, -fast), 0.0), 0.6, 1e-9);
  EXPECT_EQ(LimitWarnings(model_, With(upper_ + 0.1, fast)).size(), 2u);
}

TEST_F(LimitViolation, ARangeHasMarginsExceptForStanding) {
  constexpr double kMargin = 0.05;
  EXPECT_EQ(ViolationSum(upper_ - 1.01 * kMargin * range_, kMargin), 0.0);
  EXPECT_NEAR(ViolationSum(upper_ - 0.03 * range_, kMargin), 0.02, 1e-9);
  EXPECT_TRUE(LimitWarnings(model_, With(upper_ - 0.03 * range_)).empty()) << "that is no limit";
  model_.standing_joints[knee_] = upper_ - 0.03 * range_;
  EXPECT_EQ(ViolationSum(upper_ - 0.03 * range_, kMargin), 0.0);
  EXPECT_NEAR(ViolationSum(upper_ - 0.02 * range_, kMargin), 0.01, 1e-9);
}

TEST_F(LimitViolation, OfMotorsThatDriveSeveralJointsIsTheirs) {
  const int thigh = model_.DofIndex("FL_thigh_joint");
  Transmission leg{.name = "leg", .dofs = {thigh, knee_}, .motors = {}, .ratios = MatrixX(2, 2), .inverse = {}};
  leg.ratios << 1.0, 1.0, 1.0, -1.0;
  for (const char* name : {"front", "rear"})
    leg.motors.push_back({.name = name, .effort_limit = 10.0, .velocity_limit = 4.0});
  AddTransmission(leg, model_);
  WholeBodyTrajectory motion = With(model_.standing_joints[knee_]);
  motion.tau[0][thigh] = motion.tau[0][knee_] = 12.0;  // within the box of 20: 12 and 0
  motion.v[0][6 + thigh] = 3.0;
  motion.v[0][6 + knee_] = -3.0;  // within the box of 4: 0 and 6
  EXPECT_NEAR(TotalViolation(model_, motion, 0.0), 0.2 + 0.5, 1e-9);
  const std::vector<std::string> warnings = LimitWarnings(model_, motion);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_TRUE(warnings[0].starts_with("front is 2.00 N m over")) << warnings[0];
  EXPECT_TRUE(warnings[1].starts_with("rear is 2.00 rad/s over")) << warnings[1];
}

}  // namespace
}  // namespace gaitwright
