// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/former_motion.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

/// The standing robot, pitching and moving forward at constant rates.
WholeBodyTrajectory Pitching(const RobotModel& model, double rate_rad_s, double speed_m_s) {
  WholeBodyTrajectory motion;
  motion.step_s = 0.005;
  for (int k = 0; k <= 200; ++k) {
    VectorX q = StandingConfiguration(model);
    const double time_s = k * motion.step_s;
    q[0] += speed_m_s * time_s;
    q.segment<4>(3) = Quaternion(RotationExp(rate_rad_s * time_s * Vector3::UnitY())).coeffs();
    motion.q.push_back(q);
  }
  return motion;
}

SwingTrajectory Swing() {
  SwingTrajectory swing;
  swing.start_s = 0.2;
  swing.end_s = 0.5;
  return swing;
}

TEST(MotionOf, AnEvenTurnRollsASphereOffItsCurveAndBack) {
  const RobotModel model = *LoadNamedRobot("a1");
  constexpr double kRate = 1.5;  // [rad/s]
  const SwingTrajectory swing = Swing();
  const SwingRoll roll = MotionOf(model, Pitching(model, kRate, 0.0)).roll(swing);
  const double whole_m = model.feet[0].radius * kRate * (swing.end_s - swing.start_s);
  for (const double u : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
    const Vector3 expected_W = whole_m * (u - SmoothStep(u).value) * Vector3::UnitX();
    EXPECT_LT((roll.At(u) - expected_W).norm(), 1e-5) << u;
  }
  EXPECT_GT(roll.At(0.2).x(), 0.1 * whole_m);
}

TEST(MotionOf, ASphereOnASlopeRollsAlongIt) {
  const RobotModel model = *LoadNamedRobot("a1");
  SwingTrajectory swing = Swing();
  swing.X_WF_start.linear() = swing.X_WF_end.linear() = RotationExp(0.3 * Vector3::UnitY());
  const Vector3 normal_W = swing.X_WF_start.linear().col(2);
  const SwingRoll roll = MotionOf(model, Pitching(model, 1.5, 0.0)).roll(swing);
  EXPECT_GT(roll.At(0.2).norm(), 5e-4);
  EXPECT_LT(std::abs(roll.At(0.2).dot(normal_W)), 1e-12);
}

TEST(MotionOf, SolesDoNotRoll) {
  const RobotModel model = *LoadNamedRobot("nao");
  EXPECT_EQ(MotionOf(model, Pitching(model, 1.5, 0.0)).roll(Swing()).At(0.2), Vector3::Zero());
}

TEST(MotionOf, TheBaseIsWhereItWas) {
  const RobotModel model = *LoadNamedRobot("a1");
  const WholeBodyTrajectory trajectory = Pitching(model, 1.5, 0.4);
  const FormerMotion motion = MotionOf(model, trajectory);
  for (const double time_s : {0.0, 0.3, 0.4321, 1.0}) {
    const Pose X_WB = motion.base(time_s);
    EXPECT_NEAR(X_WB.translation().x(), trajectory.q[0][0] + 0.4 * time_s, 1e-12);
    EXPECT_LT(RotationLog(X_WB.linear() * RotationExp(1.5 * time_s * Vector3::UnitY()).transpose()).norm(), 1e-9);
  }
  EXPECT_TRUE(motion.base(2.0).isApprox(motion.base(1.0), 1e-12));
}

TEST(SidesInWorld, HoldThePointsThatTheWorkspaceHolds) {
  const std::vector<WorkspaceSide> box_B = {
      {Vector3::UnitX(), 0.3}, {-Vector3::UnitX(), -0.1}, {Vector3::UnitZ(), -0.2}, {-Vector3::UnitZ(), 0.5}};
  const Matrix3 R_WB = Eigen::AngleAxisd(0.7, Vector3(0.1, 0.5, 1.0).normalized()).toRotationMatrix();
  const Vector3 p_W(1.0, -2.0, 0.6);
  const std::vector<ReachSide> sides = SidesInWorld(box_B, p_W, R_WB, 0.01);
  ASSERT_EQ(sides.size(), box_B.size());
  for (const Vector3& q_B : {Vector3(0.2, 0.0, -0.3), Vector3(0.31, 0.4, -0.19), Vector3(0.05, 0.0, -0.6)}) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      EXPECT_NEAR(sides[i].normal_W.dot(p_W + R_WB * q_B) - sides[i].offset_m,
                  box_B[i].normal.dot(q_B) - box_B[i].offset - 0.01, 1e-12);
    }
  }
}

}  // namespace
}  // namespace gaitwright
