// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/apply_transmissions.h"

#include <functional>

#include "kinematics/base/result.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// A transmission of two motors for hip and knee of a leg.
RobotYaml::SharedDrive DriveOfLeg(const std::string& leg, const std::string& name) {
  RobotYaml::SharedDrive drive;
  drive.name = name;
  drive.joints = {leg + "_hip", leg + "_knee"};
  drive.motors.resize(2);
  drive.motors[0].name = name + "_1";
  drive.motors[0].ratios = {1.0, 1.0};
  drive.motors[0].effort = 10.0;
  drive.motors[1].name = name + "_2";
  drive.motors[1].ratios = {1.0, -1.0};
  drive.motors[1].rotor_inertia = 0.5;
  drive.line = 3;
  drive.motors[0].line = 4;
  drive.motors[1].line = 5;
  return drive;
}

/// The message of two refused transmissions with changes; "" if they are accepted.
std::string TransmissionRefusal(const std::function<void(RobotYaml&)>& change, const std::string& urdf = FourLegs()) {
  RobotModel model = *LoadRobotFromText(urdf, "");
  RobotYaml yaml;
  yaml.transmissions = {DriveOfLeg("A", "front"), DriveOfLeg("B", "other")};
  change(yaml);
  try {
    ApplyTransmissions(yaml, model);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(ApplyTransmissions, MotorsHaveTheGivenDataAndNoLimitsOtherwise) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  RobotYaml yaml;
  yaml.transmissions = {DriveOfLeg("A", "front"), DriveOfLeg("B", "other")};
  ApplyTransmissions(yaml, model);
  ASSERT_EQ(model.transmissions.size(), 2U);
  const Transmission& t = model.transmissions[0];
  EXPECT_EQ(t.dofs, (std::vector<int>{model.DofIndex("A_hip"), model.DofIndex("A_knee")}));
  EXPECT_EQ(t.motors[0].effort_limit, 10.0);
  EXPECT_EQ(t.motors[0].velocity_limit, Motor::kNone);
  EXPECT_EQ(t.motors[1].effort_limit, Motor::kNone);
  EXPECT_EQ(t.motors[1].motor.rotor_inertia, 0.5);
  EXPECT_FALSE(t.motors[1].motor.has_curve());
  // In a differential, the rotor of the difference acts on both joints and couples them with the opposite sign.
  MatrixX expected(2, 2);
  expected << 0.5, -0.5, -0.5, 0.5;
  EXPECT_LT((t.RotorInertia() - expected).norm(), 1e-12);
}

TEST(ApplyTransmissions, RefusesByLine) {
  EXPECT_EQ(TransmissionRefusal([](RobotYaml&) {}), "");
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[1].name = "front"; }),
             {"line 3", "two transmissions"});
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[1].joints[0] = "A_hip"; }),
             {"'other'", "'A_hip'", "'front' also drives"});
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[0].joints[0] = "A_hipp"; }),
             {"'A_hipp'", "'A_hip'"});
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[0].joints[0] = "A_end"; }), {"'A_end'"});
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[1].motors[0].name = "front_2"; }),
             {"line 4", "two motors are named 'front_2'"});
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[0].motors[1].name = "C_hip"; }),
             {"line 5", "'C_hip'", "does not drive"});
  EXPECT_EQ(TransmissionRefusal([](RobotYaml& y) { y.transmissions[0].motors[1].name = "A_hip"; }), "")
      << "the name of a joint that it drives";
  ExpectSays(TransmissionRefusal([](RobotYaml& y) { y.transmissions[0].motors[1].ratios = {2.0, 2.0}; }), {"line 3"});
  ExpectSays(TransmissionRefusal([](RobotYaml&) {}, FourLegsWhere("A", "<mimic joint='B_hip'/>")),
             {"'A_knee'", "mimics", "'B_hip'"});
}

TEST(ApplyTransmissions, WhatTheMotorsHaveIsNotGivenForTheirJointsToo) {
  const auto limits = [](std::optional<double> effort, std::optional<double> lower) {
    return TransmissionRefusal([&](RobotYaml& yaml) {
      RobotYaml::JointLimits given;
      given.joint = "A_hip";
      given.line = 8;
      given.effort = effort;
      given.lower = lower;
      yaml.limits = {given};
    });
  };
  ExpectSays(limits(5.0, {}), {"line 8", "'A_hip'", "'front'"});
  EXPECT_EQ(limits({}, -1.0), "") << "a position limit is the joint's own";
  const auto motor = [](auto change) {
    return TransmissionRefusal([&](RobotYaml& yaml) {
      RobotYaml::JointMotor given;
      given.joint = "A_knee";
      given.line = 9;
      change(given);
      yaml.motors = {given};
    });
  };
  ExpectSays(motor([](auto& given) { given.continuous_effort = 5.0; }), {"line 9", "'A_knee'"});
  ExpectSays(motor([](auto& given) { given.rotor_inertia = 0.1; }), {"line 9", "rotor"});
  EXPECT_EQ(motor([](auto& given) { given.damping = 0.1; }), "");
}

TEST(ApplyTransmissions, ADriveOfAJointThatWasFixedIsLeftOut) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  model.findings.push_back(
      {FindingLevel::kWarning, FailureCode::kNoInertia, RobotPart{PartKind::kJoint, "A_hip"}, 0, ""});
  RobotYaml yaml;
  yaml.transmissions = {DriveOfLeg("A", "front"), DriveOfLeg("B", "other")};
  ApplyTransmissions(yaml, model);
  ASSERT_EQ(model.transmissions.size(), 1U);
  EXPECT_EQ(model.transmissions[0].name, "other");
  EXPECT_EQ(model.findings.back().code, FailureCode::kTransmission);
  EXPECT_EQ(PartText(model.findings.back().part), "transmission 'front'");
}

}  // namespace
}  // namespace gaitwright
