// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/model/transmission_yaml_internal.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

std::vector<RobotYaml::SharedDrive> DrivesOf(const std::string& yaml) { return ParseTransmissions(LoadYaml(yaml)); }

std::string DriveRefusal(const std::string& yaml) {
  try {
    DrivesOf(yaml);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

/// A transmission of two joints, on lines 1 to 5; the second motor has more keys.
std::string TwoMotors(const std::string& more = "", const std::string& ratios = "[0, -3]") {
  return "- name: ankle\n  joints: [pitch, roll]\n  motors:\n  - {name: m1, ratios: [2, 1]}\n  - {name: m2, ratios: " +
         ratios + (more.empty() ? "" : ", " + more) + "}\n";
}

TEST(TransmissionYaml, WhatIsWrittenIsRead) {
  const std::vector<RobotYaml::SharedDrive> drives =
      DrivesOf(TwoMotors("effort_nm: 30, velocity_rad_s: 10, corner_velocity_rad_s: 4, no_load_velocity_rad_s: 8, "
                         "continuous_nm: 12, thermal_s: 5, rotor_inertia_kg_m2: 0.001"));
  ASSERT_EQ(drives.size(), 1U);
  EXPECT_EQ(drives[0].name, "ankle");
  EXPECT_EQ(drives[0].line, 1);
  EXPECT_EQ(drives[0].joints, (std::vector<std::string>{"pitch", "roll"}));
  ASSERT_EQ(drives[0].motors.size(), 2U);
  const RobotYaml::SharedMotor &first = drives[0].motors[0], &second = drives[0].motors[1];
  EXPECT_EQ(first.ratios, (std::vector<double>{2.0, 1.0}));
  EXPECT_EQ(first.effort, std::nullopt);
  EXPECT_EQ(second.ratios, (std::vector<double>{0.0, -3.0}));
  EXPECT_EQ(second.effort, 30.0);
  EXPECT_EQ(second.velocity, 10.0);
  EXPECT_EQ(second.corner_speed, 4.0);
  EXPECT_EQ(second.no_load_speed, 8.0);
  EXPECT_EQ(second.continuous_effort, 12.0);
  EXPECT_EQ(second.thermal_s, 5.0);
  EXPECT_EQ(second.rotor_inertia, 0.001);
  EXPECT_FALSE(second.sliding);
  EXPECT_EQ(second.line, 5);
}

TEST(TransmissionYaml, AMotorThatSlidesHasKeysOfItsOwn) {
  const RobotYaml::SharedMotor motor =
      DrivesOf(TwoMotors("effort_n: 300, velocity_m_s: 0.5, rotor_mass_kg: 2"))[0].motors[1];
  EXPECT_TRUE(motor.sliding);
  EXPECT_EQ(motor.effort, 300.0);
  EXPECT_EQ(motor.rotor_inertia, 2.0);
  ExpectSays(DriveRefusal(TwoMotors("effort_n: 300, velocity_rad_s: 5")), {"line 5", "'m2'", "both"});
}

TEST(TransmissionYaml, RatiosOfAnyUsefulSizeAreTaken) {
  for (const char* ratios : {"[1e6, -1e6]", "[1e-6, 0]", "[0, 1]"})
    EXPECT_EQ(DriveRefusal(TwoMotors("", ratios)), "") << ratios;
  ExpectSays(DriveRefusal(TwoMotors("", "[1e-7, 1]")), {"line 5", "1e-07"});
  ExpectSays(DriveRefusal(TwoMotors("", "[1.1e6, 1]")), {"line 5", "-1000000 to 1000000"});
  ExpectSays(DriveRefusal(TwoMotors("", "[1, 2, 3]")), {"line 5", "'m2' has 3 ratios", "2 joints"});
  ExpectSays(DriveRefusal(TwoMotors("", "[1, x]")), {"line 5", "'x'"});
}

TEST(TransmissionYaml, DataOfAMotorMustAgree) {
  ExpectSays(DriveRefusal(TwoMotors("corner_velocity_rad_s: 4")), {"'m2'", "one end"});
  ExpectSays(DriveRefusal(TwoMotors("corner_velocity_rad_s: 8, no_load_velocity_rad_s: 8")), {"'m2'", "not below"});
  ExpectSays(DriveRefusal(TwoMotors("effort_nm: 5, continuous_nm: 5.1")), {"'m2'", "5.1", "5"});
  EXPECT_EQ(DriveRefusal(TwoMotors("effort_nm: 5, continuous_nm: 5")), "");
  ExpectSays(DriveRefusal(TwoMotors("thermal_s: 5")), {"'m2'", "thermal_s"});
  ExpectSays(DriveRefusal(TwoMotors("effort_nm: 0")), {"line 5", "above 0"});
  ExpectSays(DriveRefusal(TwoMotors("efort_nm: 5")), {"'efort_nm'", "'effort_nm'"});
}

TEST(TransmissionYaml, AMotorBelongsToEachJointAndAJointIsNamedOnce) {
  ExpectSays(DriveRefusal(Replaced(TwoMotors(), "roll", "pitch")), {"line 2", "'ankle'", "'pitch' twice"});
  ExpectSays(DriveRefusal(Replaced(TwoMotors(), "[pitch, roll]", "[pitch]")), {"line 2", "1 joints", "2 to 8"});
  ExpectSays(DriveRefusal(Replaced(TwoMotors(), "[pitch, roll]", "[a, b, c]")), {"2 motors but 3 joints"});
  ExpectSays(DriveRefusal(Replaced(TwoMotors(), "name: ankle", "name: ''")), {"line 1", "empty 'name'"});
  ExpectSays(DriveRefusal(Replaced(TwoMotors(), "name: m1, ", "")), {"line 4", "'name'"});
  ExpectSays(DriveRefusal("ankle"), {"'transmissions'", "list"});
  EXPECT_TRUE(DrivesOf("[]").empty());
}

}  // namespace
}  // namespace gaitwright
