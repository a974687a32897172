// SPDX-License-Identifier: BSD-3-Clause
// The CSV log of a robot as one side of a comparison.
#include "workflows/exchange/csv_motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/file.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/other_software.h"
#include "workflows/compare/compare_motions.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

Result<ComparedMotion> Side(const std::string& text, const CsvReading& reading = {}) {
  return ComparedCsv(NamedRobot("a1"), *ParseCsvTable(text, "robot.csv"), reading);
}

std::string FileWith(const std::string& text) {
  std::string path = ScratchFile("side_names.yaml");
  EXPECT_TRUE(WriteFileAtomically(path, text).ok());
  return path;
}

void ExpectWhy(const std::string& text, const std::vector<std::string>& parts, const CsvReading& reading = {}) {
  const Result<ComparedMotion> side = Side(text, reading);
  ASSERT_FALSE(side.ok()) << parts.front();
  const std::string& message = side.failure().message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

OtherStance Standing() { return {.base_z_m = NamedRobot("a1").standing_base_height_m}; }

TEST(ComparedCsv, TheOrderOfTheQuaternionIsApplied) {
  OtherWalk walk;
  walk.w_first = true;
  ExpectWhy(CsvOf(walk), {"'robot.csv': the base's quaternion probably has w first", "--quaternion-order wxyz"});
  CsvReading by_file, by_flag;
  by_file.columns_file = FileWith("quaternion_order: wxyz\n");
  by_flag.options.quaternion_order = "wxyz";
  for (const CsvReading& reading : {by_file, by_flag}) {
    const Result<ComparedMotion> side = Side(CsvOf(walk), reading);
    ASSERT_TRUE(side.ok()) << side.failure().message;
    for (const VectorX& q : side->rows.q) ASSERT_EQ(q.segment<4>(3), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
  }
}

TEST(ComparedCsv, ItsWorldMayBeItsOwn) {
  OtherWalk walk;
  walk.length_scale = 0.0;  // its base position stays at the origin, so that the feet do not match the ground
  EXPECT_TRUE(Side(CsvOf(walk)).ok());
}

TEST(ComparedCsv, IsHeldToWhatMotionsAre) {
  OtherWalk degrees, millimetres, milliseconds;
  degrees.joint_scale = 180.0 / std::numbers::pi;
  millimetres.length_scale = 1000.0;
  milliseconds.time_scale = 1000.0;
  ExpectWhy(CsvOf(degrees), {"use --angle-unit deg for degrees"});
  ExpectWhy(CsvOf(millimetres), {"use --length-unit mm for millimetres"});
  ExpectWhy(CsvOf(milliseconds), {"use --time-unit ms"});
  OtherStance short_turn = Standing(), far = Standing();
  short_turn.turn = "0,0,0,0.5";
  far.base_z_m = 1e9;
  ExpectWhy(CsvOf(NamedRobot("a1"), short_turn), {"the quaternion of row 1 (0 s) has length 0.5"});
  ExpectWhy(CsvOf(NamedRobot("a1"), far), {"the base's position of row 1", "at most +-1e+08"});
}

TEST(ComparedCsv, ClocksOfNanosecondsAndLongerAreRefused) {
  OtherStance stance = Standing();
  stance.step_s = 5e6;
  ExpectWhy(CsvOf(NamedRobot("a1"), stance), {"its rows are 5e+06 s apart", "use --time-unit ns"});
  CsvReading seconds;
  seconds.options.time_unit = "s";
  ExpectWhy(CsvOf(NamedRobot("a1"), stance), {"lasts 2.45e+08 s; at most 3600 s are accepted"}, seconds);
  stance.step_s = 1e30;
  ExpectWhy(CsvOf(NamedRobot("a1"), stance), {"at most 3600 s are accepted"}, seconds);
}

TEST(ComparedCsv, SpeedsThatAreNotGivenAreWorkedOut) {
  std::string text = "time_s";
  for (const std::string& name : NamedRobot("a1").dof_names) text += "," + name;
  text += ",v_FL_hip_joint_rad_s";
  for (int row = 0; row < 6; ++row) {
    text += fmt::format("\n{}", 0.01 * row);
    for (int d = 0; d < NamedRobot("a1").num_dofs(); ++d)
      text += fmt::format(",{}", NamedRobot("a1").standing_joints[d] + 0.02 * row);
    text += ",7";
  }
  const Result<ComparedMotion> side = Side(text + "\n");
  ASSERT_TRUE(side.ok()) << side.failure().message;
  for (const VectorX& v : side->rows.v) {
    for (int d = 0; d < NamedRobot("a1").num_dofs(); ++d)
      EXPECT_NEAR(v[6 + d], NamedRobot("a1").dof_names[static_cast<std::size_t>(d)] == "FL_hip_joint" ? 7.0 : 2.0,
                  1e-9);
  }
}

TEST(ComparedCsv, SpeedsThatNoRobotHasAreRefused) {
  OtherStance stance = Standing();
  stance.step_s = 1e-12;
  std::string text = CsvOf(NamedRobot("a1"), stance);
  const std::string usual = fmt::format(",{}\n", NamedRobot("a1").standing_joints[NamedRobot("a1").num_dofs() - 1]);
  const std::size_t last = text.rfind(usual);
  ASSERT_NE(last, std::string::npos);
  text.replace(last, usual.size(), ",0\n");
  ExpectWhy(text, {"the computed speed", "its position jumps there"});
}

/// The A1 standing as OCS2's logger writes it.
std::string Ocs2Stance() {
  std::string text = "time";
  for (const char* axis : {"x", "y", "z"}) text += fmt::format(",base_positionInWorld_{}", axis);
  for (const char* part : {"w", "x", "y", "z"}) text += fmt::format(",base_quaternion_{}", part);
  for (const char* leg : {"LF", "RF", "LH", "RH"}) {
    for (const char* joint : {"HAA", "HFE", "KFE"}) text += fmt::format(",jointAngle_{}_{}", leg, joint);
  }
  for (int row = 0; row < 10; ++row) {
    text += fmt::format("\n{},0,0,{},1,0,0,0", 0.01 * row, NamedRobot("a1").standing_base_height_m);
    for (int leg = 0; leg < 4; ++leg) {
      for (int joint = 0; joint < 3; ++joint) text += fmt::format(",{}", NamedRobot("a1").standing_joints[joint]);
    }
  }
  return text + "\n";
}

TEST(ComparedCsv, HowItWasUnderstoodIsAmongTheNotes) {
  const Result<ComparedMotion> side = Side(Ocs2Stance());
  ASSERT_TRUE(side.ok()) << side.failure().message;
  const MotionComparison c = CompareMotions(*side, *side);
  const auto tells = [](const std::string& note) { return note.find("LF_HAA is FL_hip_joint") != std::string::npos; };
  EXPECT_EQ(std::count_if(c.notes.begin(), c.notes.end(), tells), 1);
  OtherStance with_battery = Standing();
  with_battery.turn_columns += ",battery";
  with_battery.turn += ",12";
  const Result<ComparedMotion> with_more = Side(CsvOf(NamedRobot("a1"), with_battery));
  ASSERT_TRUE(with_more.ok()) << with_more.failure().message;
  ASSERT_EQ(with_more->notes.size(), 1U);
  EXPECT_EQ(with_more->notes.front(), "'robot.csv', columns that are not used: 'battery'");
}

TEST(ComparedCsv, JointsThatItLacksAreNotANumber) {
  std::string text = CsvOf({});
  text.replace(text.find("q_FR_hip_joint_rad"), 18, "shoulder");
  const Result<ComparedMotion> side = Side(text);
  ASSERT_TRUE(side.ok()) << side.failure().message;
  const int dof = NamedRobot("a1").DofIndex("FR_hip_joint");
  for (int d = 0; d < NamedRobot("a1").num_dofs(); ++d) EXPECT_EQ(side->HasJoint(d), d != dof);
  EXPECT_NE(side->notes.front().find("lacks 1 of 12 joints"), std::string::npos) << side->notes.front();
  const MotionComparison c = CompareMotions(*side, *side);
  EXPECT_EQ(c.joints.size(), 11U);
  EXPECT_TRUE(c.same()) << c.in_order.front().quantity;
  ExpectWhy("time_s,battery\n0,1\n", {"lacks 12 of 12 joint positions", "not used: 'battery'"});
}

TEST(ComparedCsv, NamesMayBeForAnotherFileToo) {
  const std::string text = CsvOf(NamedRobot("a1"), Standing());
  CsvReading reading;
  reading.columns_file = FileWith("columns: {clock: time_s}\nscale: {clock: 2}\nignore: [battery]\n");
  ExpectWhy(text, {"there is no column 'clock' to take as 'time_s'"}, reading);
  reading.elsewhere = {"clock", "battery"};
  EXPECT_TRUE(Side(text, reading).ok());
}

TEST(ComparedCsv, MotionsOfMoreThanAnHourAreNotCompared) {
  Result<ComparedMotion> side = Side(CsvOf(NamedRobot("a1"), Standing()));
  ASSERT_TRUE(side.ok());
  ComparedMotion longer = *side;
  longer.rows.time_s.back() = 1e15;
  EXPECT_THROW(CompareMotions(*side, longer), InvalidArgument);
  EXPECT_THROW(CompareMotions(longer, *side), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
