// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/ways_to_standing_internal.h"

namespace gaitwright {
namespace {

/// The standing posture elsewhere on the ground.
VectorX StandingAt(const RobotModel& model, const PlanarPose& at) {
  VectorX q = StandingConfiguration(model);
  q.head<2>() << at.x_m, at.y_m;
  q.segment<4>(3) = Quaternion(YawRotation(at.yaw_rad)).coeffs();
  return q;
}

TEST(OffsetsToStanding, OfStandingAnywhereAreNone) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const PlanarPose at{0.7, -0.2, 1.1};
    const OffsetsToStanding offsets = FindOffsetsToStanding(model, StandingAt(model, at));
    EXPECT_LT(offsets.largest_m(), 1e-9);
    EXPECT_NEAR(offsets.base.plan.x_m, at.x_m, 1e-9);
    EXPECT_NEAR(offsets.base.plan.yaw_rad, at.yaw_rad, 1e-9);
  }
}

TEST(OffsetsToStanding, ADisplacedFootGoesBackButARolledSphereDoesNot) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  VectorX q = StandingConfiguration(a1);
  const Leg& leg = a1.legs.front();
  const int hip = a1.joints[static_cast<std::size_t>(leg.joints.front())].dof;  // moves its foot sideways
  q[7 + hip] += 0.05;
  const OffsetsToStanding offsets = FindOffsetsToStanding(a1, q, 0.0);
  for (std::size_t other = 1; other < a1.legs.size(); ++other)
    EXPECT_GT(offsets.offset_W[0].norm(), 2.0 * offsets.offset_W[other].norm()) << "the base fits the others better";
  EXPECT_GT(offsets.offset_W[0].norm(), 0.005);
  // The whole robot leans by a small angle about the line through its left feet: these roll, and roll back.
  VectorX leant = StandingConfiguration(a1);
  DynamicsScratch scratch(a1);
  ForwardKinematics(a1, leant, scratch);
  const Foot& foot = a1.feet[0];
  const Vector3 centre_W = FramePose(scratch, foot.body, foot.X_BF).translation();
  constexpr double kLean = 0.02;  // [rad]
  const Matrix3 R = Eigen::AngleAxisd(kLean, Vector3::UnitX()).toRotationMatrix();
  const Vector3 rolled_W = foot.radius * kLean * Vector3::UnitX().cross(Vector3::UnitZ());
  leant.head<3>() = centre_W + rolled_W + R * (Vector3(leant.head<3>()) - centre_W);
  leant.segment<4>(3) = Quaternion(R).coeffs();
  const OffsetsToStanding back = FindOffsetsToStanding(a1, leant, 0.0);
  const Vector3 apart_W = back.offset_W[0] - back.offset_W[2];  // front and rear foot on the left roll alike
  EXPECT_LT(apart_W.norm(), 1e-6);
}

}  // namespace
}  // namespace gaitwright
