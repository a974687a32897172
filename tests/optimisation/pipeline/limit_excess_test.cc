// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/limit_excess.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// One row with the standing posture, but for one joint's position or speed.
class LimitExcess : public ::testing::Test {
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
  double Excess(double position, double spare) const { return TotalExcess(model_, With(position), spare); }

  RobotModel model_ = LoadNamedRobot("a1").value();
  int knee_ = model_.DofIndex("FL_calf_joint");
  double upper_ = model_.dof_upper(knee_), range_ = upper_ - model_.dof_lower(knee_);
};

TEST_F(LimitExcess, IsASumOfSharesOfTheLimits) {
  EXPECT_EQ(Excess(upper_ - 1e-9, 0.0), 0.0);
  EXPECT_NEAR(Excess(upper_ + 0.1 * range_, 0.0), 0.1, 1e-9);
  const double fast = 1.5 * model_.dof_velocity_limit(knee_);
  EXPECT_NEAR(TotalExcess(model_, With(upper_ + 0.1 * range_, -fast), 0.0), 0.6, 1e-9);
  EXPECT_EQ(LimitWarnings(model_, With(upper_ + 0.1, fast)).size(), 2u);
}

TEST_F(LimitExcess, TheEndOfARangeIsSparedOtherThanToStand) {
  constexpr double kSpare = 0.05;
  EXPECT_EQ(Excess(upper_ - 1.01 * kSpare * range_, kSpare), 0.0);
  EXPECT_NEAR(Excess(upper_ - 0.03 * range_, kSpare), 0.02, 1e-9);
  EXPECT_TRUE(LimitWarnings(model_, With(upper_ - 0.03 * range_)).empty()) << "that is no limit";
  model_.standing_joints[knee_] = upper_ - 0.03 * range_;
  EXPECT_EQ(Excess(upper_ - 0.03 * range_, kSpare), 0.0);
  EXPECT_NEAR(Excess(upper_ - 0.02 * range_, kSpare), 0.01, 1e-9);
}

}  // namespace
}  // namespace gaitwright
