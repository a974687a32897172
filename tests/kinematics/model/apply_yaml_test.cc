// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/apply_yaml.h"

#include <cmath>

#include "kinematics/base/result.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

RobotModel FourLegsModel() { return *LoadRobotFromText(FourLegs(), ""); }

/// The message of a refused robot.yaml with some items.
template <class Apply>
std::string ApplyRefusal(const Apply& apply) {
  RobotModel model = FourLegsModel();
  RobotYaml yaml;
  try {
    apply(yaml, model);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

RobotYaml::JointLimits LimitsOf(const std::string& joint) {
  RobotYaml::JointLimits limits;
  limits.joint = joint;
  limits.line = 7;
  return limits;
}

TEST(ApplyLimits, ReplacesOnlyWhatIsGiven) {
  RobotModel model = FourLegsModel();
  RobotYaml yaml;
  yaml.limits = {LimitsOf("A_hip"), LimitsOf("B_knee")};
  yaml.limits[0].upper = 0.5;
  yaml.limits[1].effort = 7.0;
  ApplyLimits(yaml, model);
  const int hip = model.DofIndex("A_hip"), knee = model.DofIndex("B_knee");
  EXPECT_EQ(model.dof_lower(hip), -2.0);
  EXPECT_EQ(model.dof_upper(hip), 0.5);
  EXPECT_EQ(model.dof_effort_limit(hip), 30.0);
  EXPECT_EQ(model.dof_effort_limit(knee), 7.0);
  EXPECT_EQ(model.dof_velocity_limit(knee), 20.0);
}

TEST(ApplyLimits, AGivenLimitIsNoPlaceholder) {
  RobotModel model = FourLegsModel();
  for (Joint& joint : model.joints) joint.effort_limit_is_placeholder = joint.velocity_limit_is_placeholder = true;
  RobotYaml yaml;
  yaml.limits = {LimitsOf("A_hip")};
  yaml.limits[0].effort = 7.0;
  ApplyLimits(yaml, model);
  const Joint& joint = model.LeaderOf(model.DofIndex("A_hip"));
  EXPECT_FALSE(joint.effort_limit_is_placeholder);
  EXPECT_TRUE(joint.velocity_limit_is_placeholder);
}

TEST(ApplyLimits, RefusesByLineAndName) {
  const auto refusal = [](const std::string& joint, auto change) {
    return ApplyRefusal([&](RobotYaml& yaml, RobotModel& model) {
      yaml.limits = {LimitsOf(joint)};
      change(yaml.limits[0], model);
      ApplyLimits(yaml, model);
    });
  };
  const auto nothing = [](auto&, auto&) {};
  ExpectSays(refusal("A_hipp", nothing), {"line 7", "'A_hipp'", "'A_hip'"});
  ExpectSays(refusal("A_hip", [](auto& limits, auto&) { limits.lower = 1.5; }), {"line 7", "1.5", "above", "1"});
  ExpectSays(refusal("A_hip", [](auto& limits, auto&) { limits.sliding = true, limits.upper = 0.1; }),
             {"line 7", "'A_hip' is revolute"});
  ExpectSays(refusal("A_hip",
                     [](auto& limits, auto& model) {
                       model.joints[0].type = JointType::kContinuous;
                       limits.lower = -1.0;
                     }),
             {"continuous", "both"});
}

TEST(ApplyMotors, TakesTheDataOfTheJointAndLeavesOthersPlain) {
  RobotModel model = FourLegsModel();
  RobotYaml yaml;
  RobotYaml::JointMotor motor;
  motor.joint = "A_knee";
  motor.corner_speed = 4.0;
  motor.no_load_speed = 8.0;
  motor.continuous_effort = 30.0;
  motor.friction = 0.25;
  yaml.motors = {motor};
  ApplyMotors(yaml, model);
  const int knee = model.DofIndex("A_knee");
  EXPECT_EQ(model.MotorOf(knee).EffortAt(6.0, 30.0), 15.0);
  EXPECT_EQ(model.MotorOf(knee).continuous_effort, 30.0) << "at the joint's limit";
  EXPECT_EQ(model.LeaderOf(knee).friction, 0.25);
  EXPECT_EQ(model.LeaderOf(knee).damping, 0.1) << "of the URDF";
  EXPECT_FALSE(model.MotorOf(model.DofIndex("B_knee")).has_curve());
  EXPECT_EQ(model.motors.size(), 8U);
}

TEST(ApplyMotors, RefusesDataThatContradictEachOther) {
  const auto refusal = [](auto change) {
    return ApplyRefusal([&](RobotYaml& yaml, RobotModel& model) {
      yaml.motors.resize(1);
      yaml.motors[0].joint = "A_knee";
      yaml.motors[0].line = 4;
      change(yaml.motors[0]);
      ApplyMotors(yaml, model);
    });
  };
  ExpectSays(refusal([](auto& motor) { motor.corner_speed = 4.0; }), {"line 4", "one end"});
  ExpectSays(refusal([](auto& motor) { motor.corner_speed = motor.no_load_speed = 4.0; }), {"line 4", "not below"});
  ExpectSays(refusal([](auto& motor) { motor.continuous_effort = 30.5; }), {"line 4", "30.5", "limit of 30"});
  ExpectSays(refusal([](auto& motor) { motor.sliding = motor.has_units = true; }), {"line 4", "revolute"});
  ExpectSays(refusal([](auto& motor) { motor.joint = "A_end"; }), {"line 4", "'A_end'"});
}

TEST(GivenPosture, IsNanWhereNothingIsGiven) {
  const RobotModel model = FourLegsModel();
  RobotYaml yaml;
  yaml.standing = {{"A_hip", -2.0, 3}, {"B_knee", 0.5, 4}};
  const VectorX given = GivenPosture(yaml, model);
  ASSERT_EQ(given.size(), 8);
  EXPECT_EQ(given[model.DofIndex("A_hip")], -2.0) << "at its limit";
  EXPECT_EQ(given[model.DofIndex("B_knee")], 0.5);
  EXPECT_EQ(given.unaryExpr([](double q) { return std::isnan(q) ? 1.0 : 0.0; }).sum(), 6.0);
  yaml.standing[1].position = 1.001;
  EXPECT_THROW(GivenPosture(yaml, model), InvalidArgument);
}

TEST(ApplyStanding, TheHeightMustBeThatOfTheFeet) {
  const double stands = FourLegsModel().standing_base_height_m;
  const auto refusal = [&](double height) {
    return ApplyRefusal([&](RobotYaml& yaml, RobotModel& model) {
      yaml.standing_base_height_m = height;
      yaml.height_line = 9;
      ApplyStanding(yaml, model);
      EXPECT_EQ(model.standing_base_height_m, height);
    });
  };
  EXPECT_EQ(refusal(stands + 0.0045), "");
  EXPECT_EQ(refusal(stands - 0.0045), "");
  ExpectSays(refusal(stands + 0.01), {"line 9", "10.0 mm off"});
}

TEST(ApplyStanding, GainsAndSpeedAreTaken) {
  RobotModel model = FourLegsModel();
  const double height = model.standing_base_height_m;
  RobotYaml yaml;
  yaml.nominal_speed_m_s = 0.3;
  yaml.gains.resize(1);
  yaml.gains[0].joint = "C_hip";
  yaml.gains[0].stiffness = 80.0;
  ApplyStanding(yaml, model);
  EXPECT_EQ(model.nominal_speed_m_s, 0.3);
  EXPECT_EQ(model.stiffness[model.DofIndex("C_hip")], 80.0);
  EXPECT_EQ(model.stiffness.sum(), 80.0);
  EXPECT_EQ(model.damping.sum(), 0.0);
  EXPECT_EQ(model.standing_base_height_m, height);
}

TEST(ApplyRests, ALinkWithAFlatBottomIsASurfaceToLieOn) {
  RobotModel model = FourLegsModel();
  RobotYaml yaml;
  yaml.rests = {{"trunk", 5}};
  ApplyRests(yaml, model);
  ASSERT_EQ(model.feet.size(), 5U);
  EXPECT_EQ(model.feet.back().link, "trunk");
  EXPECT_EQ(model.feet.back().body, 0);
  EXPECT_NEAR(model.feet.back().X_BF.translation().z(), -0.05, 1e-12);
  EXPECT_EQ(model.legs.size(), 4U);
  EXPECT_THROW(ApplyRests(yaml, model), InvalidArgument) << "twice";
  for (const char* wrong : {"trunkk", "A_foot", "A_thigh"}) {
    yaml.rests = {{wrong, 6}};
    EXPECT_THROW(ApplyRests(yaml, model), InvalidArgument) << wrong;
  }
}

}  // namespace
}  // namespace gaitwright
