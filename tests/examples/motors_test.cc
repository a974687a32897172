// SPDX-License-Identifier: BSD-3-Clause
// The robot.yaml of examples/motors on the bundled A1: read, audited and played, and what each figure is for.
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/base/file.h"
#include "kinematics/model/joint_losses.h"
#include "kinematics/model/load_robot.h"
#include "planning/audit/joint_watch.h"
#include "tests/built_paths.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

const RobotModel& Geared() {
  static const RobotModel model = [] {
    const std::string root = SourceFolder();
    const std::string urdf = ReadFile(root + "/robots/a1/robot.urdf").value();
    return LoadRobotFromText(urdf, ReadFile(root + "/examples/motors/a1.yaml").value()).value();
  }();
  return model;
}

const MotionPlan& AWalk() {
  static const MotionPlan plan = [] {
    WalkRequest request;
    request.command.distance_m = 1.0;
    const PlannedWalk planned = PlanWalk(Geared(), request).value();
    EXPECT_TRUE(planned.audit.pass()) << AuditText(planned.audit);
    return planned.motion.plan;
  }();
  return plan;
}

TEST(MotorsExample, SaysAllThatPlaybackAndAuditKnowOfMotors) {
  for (int dof = 0; dof < Geared().num_dofs(); ++dof) {
    EXPECT_TRUE(Geared().MotorOf(dof).has_curve());
    EXPECT_EQ(LossesOf(Geared(), dof).rotor_inertia, 0.01);
    EXPECT_EQ(LossesOf(Geared(), dof).friction, 0.2);
    EXPECT_EQ(LossesOf(Geared(), dof).damping, 0.05);
  }
  EXPECT_EQ(UnknownOfMotors(Geared()).size(), 2U) << "limits of acceleration and jerk alone";
  AuditOptions options;
  options.margins = true;
  const AuditReport audit = Audit(Geared(), AWalk(), options).value();
  for (const Law law : {Law::kTorqueSpeed, Law::kContinuousTorque}) {
    EXPECT_EQ(std::count_if(audit.margins.begin(), audit.margins.end(), [&](const auto& m) { return m.law == law; }),
              12)
        << law;
  }
}

TEST(MotorsExample, WalksAndFeelsItsLosses) {
  PlayRequest request;
  const PlayedWalk played = PlayWalk(Geared(), AWalk(), request).value();
  EXPECT_TRUE(played.report.pass) << played.report.reason;
  request.gains.loss_feed_forward = 0.0;
  const PlayedWalk unaware = PlayWalk(Geared(), AWalk(), request).value();
  const auto off = [](const PlayedWalk& walk) { return *walk.report.At("tracking_joint_rms_rad").value; };
  EXPECT_GT(off(unaware), off(played)) << "controllers that do not know them track worse";
}

TEST(MotorsExample, AMotorThatIsTooWarmGivesNoMoreThanItsContinuousEffort) {
  RobotModel weak = Geared();
  for (Motor& motor : weak.motors) motor.continuous_effort = 2.0, motor.thermal_s = 0.1;
  const PlayedWalk played = PlayWalk(weak, AWalk(), {}).value();
  EXPECT_GT(*played.report.At("torque_saturated_fraction").value, 0.01);
  EXPECT_FALSE(played.report.pass);
  EXPECT_NE(played.report.reason.find("of 33.50 N m (reduced by the motor's warmth)"), std::string::npos)
      << played.report.reason;
}

}  // namespace
}  // namespace gaitwright
