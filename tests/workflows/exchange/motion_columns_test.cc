// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_columns.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "kinematics/base/file.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/exchange/column_target.h"
#include "workflows/exchange/ocs2_columns.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A table of two rows with a column of time and all joints of a robot at 0.1, 0.2, ...
CsvTable TableOf(const RobotModel& model, const std::vector<std::pair<std::string, double>>& more = {}) {
  std::string header = "time_s", row;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Joint& joint = model.LeaderOf(d);
    header += ",q_" + joint.name + (joint.is_prismatic() ? "_m" : "_rad");
    row += fmt::format(",{}", 0.1 * (d + 1));
  }
  for (const auto& [name, value] : more) header += "," + name, row += fmt::format(",{}", value);
  return *ParseCsvTable(header + "\n0" + row + "\n0.01" + row + "\n", "motion.csv");
}

Result<MotionTable> Taken(const CsvTable& table, const ColumnNames& names = {}, const ImportOptions& options = {},
                          const std::string& robot = "a1") {
  return MotionFromCsv(NamedRobot(robot), table, names, options);
}

void ExpectRefusal(const Result<MotionTable>& motion, const std::string& part) {
  ASSERT_FALSE(motion.ok()) << part;
  EXPECT_EQ(motion.failure().code, FailureCode::kColumns);
  EXPECT_NE(motion.failure().message.find(part), std::string::npos) << motion.failure().message;
}

TEST(MotionColumns, TakesWhatNamesSay) {
  const Result<MotionTable> motion = Taken(
      TableOf(NamedRobot("a1"),
              {{"v_FL_hip_joint_rad_s", 2.0}, {"tau_FL_hip_joint_nm", 3.0}, {"base_vx_m_s", 9.0}, {"battery", 12.0}}));
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  const int dof = NamedRobot("a1").DofIndex("FL_hip_joint");
  EXPECT_NEAR(motion->q[1][dof], 0.1 * (dof + 1), 1e-12);
  EXPECT_EQ(motion->v[0][dof], 2.0);
  EXPECT_TRUE(std::isnan(motion->v[0][dof == 0 ? 1 : 0])) << "one that is not there is worked out";
  EXPECT_EQ(motion->tau[0][dof], 3.0);
  EXPECT_TRUE(motion->base_m.empty() && motion->quaternion.empty() && motion->contact.empty());
  EXPECT_EQ(motion->unused_columns, (std::vector<std::string>{"battery", "base_vx_m_s"}));
}

TEST(MotionColumns, AnglesOfTheBaseAreARotation) {
  const Result<MotionTable> motion = Taken(TableOf(NamedRobot("a1"), {{"base_x_m", 1},
                                                                      {"base_y_m", 2},
                                                                      {"base_z_mm", 300},
                                                                      {"base_roll_deg", 90},
                                                                      {"base_pitch_rad", 0},
                                                                      {"base_yaw_deg", 90}}));
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_NEAR(motion->base_m[0].z(), 0.3, 1e-12);
  const Eigen::Vector4d c = motion->quaternion[0];
  const Matrix3 R = Quaternion(c[3], c[0], c[1], c[2]).toRotationMatrix();
  EXPECT_LT((R * Vector3::UnitY() - Vector3::UnitZ()).norm(), 1e-12);  // the roll turns y up; yaw leaves it
  EXPECT_LT((R * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
}

TEST(MotionColumns, AJointsNameMayStandWithItsUnitAndWithoutItsQ) {
  const RobotModel& a1 = NamedRobot("a1");
  const CsvTable ours = TableOf(a1);
  for (const auto& [unit, scale] : {std::pair{"", 1.0}, {"_rad", 1.0}, {"_deg", kDegree}}) {
    CsvTable theirs = ours;
    for (int d = 0; d < a1.num_dofs(); ++d)
      theirs.columns[static_cast<std::size_t>(d) + 1] = a1.LeaderOf(d).name + unit;
    const Result<MotionTable> motion = Taken(theirs);
    ASSERT_TRUE(motion.ok()) << motion.failure().message;
    EXPECT_LT((motion->q[1] - scale * Taken(ours)->q[1]).norm(), 1e-12) << unit;
  }
}

TEST(MotionColumns, OfASlideTheUnitIsALength) {
  RobotModel model = NamedRobot("a1");
  model.joints[static_cast<std::size_t>(model.dof_joint[2])].type = JointType::kPrismatic;
  const std::string& name = model.dof_names[2];
  const auto targets = ColumnTargets(model, {});
  EXPECT_EQ(targets.at(name + "_mm").scale, 1e-3);
  EXPECT_EQ(targets.at(name + "_m").index, model.dof_joint[2]);
  EXPECT_EQ(targets.count(name + "_rad"), 0U);
}

TEST(MotionColumns, AJointThatIsCalledLikeAnothersUnitKeepsItsName) {
  RobotModel model = NamedRobot("a1");
  const int arm = model.dof_joint[0], other = model.dof_joint[1];
  model.joints[static_cast<std::size_t>(arm)].name = "arm";
  model.joints[static_cast<std::size_t>(other)].name = "arm_rad";
  const auto targets = ColumnTargets(model, {});
  EXPECT_EQ(targets.at("arm_rad").index, other);
  EXPECT_EQ(targets.at("q_arm_rad").index, arm);
  EXPECT_EQ(targets.at("arm_deg").index, arm);
}

TEST(MotionColumns, TheTimeIsNamedWhereSomeColumnIsLikelyIt) {
  CsvTable table = TableOf(NamedRobot("a1"));
  for (const char* likely : {"Time [s]", "timestamp_ms", "tims", "Stamp"}) {
    table.columns[0] = likely;
    ExpectRefusal(Taken(table),
                  fmt::format("has no time column: 'time_s' is needed; the nearest to it is '{}'", likely));
  }
  table.columns[0] = "clock";
  ExpectRefusal(Taken(table), "'time_s' is needed, or 'time' or 't'; no column has a similar name");
}

TEST(MotionColumns, UnitsScaleWhatHasNone) {
  ImportOptions options;
  options.angle_unit = "deg";
  options.time_unit = "ms";
  const Result<MotionTable> motion = Taken(TableOf(NamedRobot("a1")), {}, options);
  ASSERT_TRUE(motion.ok());
  EXPECT_NEAR(motion->q[0][1], 0.2 * kDegree, 1e-15);
  EXPECT_NEAR(motion->time_s[1], 1e-5, 1e-15);
}

TEST(MotionColumns, FeetAndForces) {
  std::vector<std::pair<std::string, double>> more;
  for (const Foot& foot : NamedRobot("a1").feet) {
    more.emplace_back("contact_" + foot.link, foot.link == "FL_foot" ? 0.0 : 1.0);
    for (const char axis : {'x', 'y', 'z'})
      more.emplace_back(fmt::format("force_{}_{}_n", foot.link, axis), axis - 'x');
  }
  const Result<MotionTable> motion = Taken(TableOf(NamedRobot("a1"), more));
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  for (int f = 0; f < 4; ++f)
    EXPECT_EQ(Contains(motion->contact[0], f), NamedRobot("a1").feet[static_cast<std::size_t>(f)].link != "FL_foot");
  EXPECT_EQ(motion->force_W[1][3], Vector3(0.0, 1.0, 2.0));
  more.front().second = 0.5;
  ExpectRefusal(Taken(TableOf(NamedRobot("a1"), more)), "0.5 is neither 0 nor 1");
  more.pop_back();
  ExpectRefusal(Taken(TableOf(NamedRobot("a1"), more)), "all of them are needed, or none");
}

TEST(MotionColumns, RefusesWhatDoesNotGoTogether) {
  const RobotModel& a1 = NamedRobot("a1");
  ExpectRefusal(Taken(TableOf(a1, {{"v_FL_hip_joint_deg", 1}})),
                "is unknown for robot 'a1'; the nearest is 'v_FL_hip_joint_deg_s'");
  ExpectRefusal(Taken(TableOf(a1, {{"contact_FL_fot", 1}})), "the nearest is 'contact_FL_foot'");
  CsvTable renamed = TableOf(a1);
  std::replace(renamed.columns.begin(), renamed.columns.end(), std::string("q_FR_hip_joint_rad"),
               std::string("FR_hip_joint_pos"));
  ExpectRefusal(Taken(renamed), "the nearest to the first of them is 'FR_hip_joint_pos'");
  ExpectRefusal(Taken(TableOf(a1, {{"FL_hip_joint", 1}})), "both are");
  ExpectRefusal(Taken(TableOf(a1, {{"base_x_m", 1}, {"base_y_m", 1}, {"base_z_m", 1}})),
                "has the position of the base but not its orientation");
  ExpectRefusal(Taken(TableOf(a1), {{{"time_s", "tim_s"}}, {}, {}}),
                "column 'time_s' is mapped to 'tim_s', which is not a known name");
  ExpectRefusal(Taken(TableOf(a1), {{}, {{"tim", 2.0}}, {}}),
                "there is no column 'tim' to scale; the nearest is 'time_s'");
}

TEST(MotionColumns, EachNameOfTheFileOfNamesIsAColumn) {
  const RobotModel& a1 = NamedRobot("a1");
  const CsvTable table = TableOf(a1, {{"hip vel", 1.0}, {"battery", 12.0}});
  ExpectRefusal(Taken(table, {{{"hip_vel", "v_FL_hip_joint_rad_s"}}, {}, {}}),
                "there is no column 'hip_vel' to take as 'v_FL_hip_joint_rad_s'; the nearest is 'hip vel'");
  ExpectRefusal(Taken(table, {{}, {}, {"batery"}}), "there is no column 'batery' to ignore; the nearest is 'battery'");
  ColumnNames of_many{{{"hip_vel", "v_FL_hip_joint_rad_s"}}, {}, {"batery"}};
  of_many.may_lack = true;
  EXPECT_TRUE(Taken(table, of_many).ok());
  of_many.may_lack = false;
  of_many.elsewhere = {"batery", "hip_vel"};
  EXPECT_TRUE(Taken(table, of_many).ok());
}

TEST(MotionColumns, TheQuaternionIsBroughtIntoOurOrder) {
  const CsvTable table =
      TableOf(NamedRobot("a1"), {{"base_qx", 0.1}, {"base_qy", 0.2}, {"base_qz", 0.3}, {"base_qw", 0.9}});
  ImportOptions options;
  EXPECT_EQ(Taken(table, {}, options)->quaternion[0], Eigen::Vector4d(0.1, 0.2, 0.3, 0.9));
  options.quaternion_order = "wxyz";
  EXPECT_EQ(Taken(table, {}, options)->quaternion[0], Eigen::Vector4d(0.2, 0.3, 0.9, 0.1));
}

TEST(MotionColumns, JointsThatFollowAreHeldAgainstTheirLeaders) {
  const RobotModel& nao = NamedRobot("nao");
  const auto mimic = std::find_if(nao.joints.begin(), nao.joints.end(), [](const Joint& j) { return j.is_mimic; });
  ASSERT_NE(mimic, nao.joints.end());
  const double right = mimic->multiplier * 0.1 * (mimic->dof + 1) + mimic->offset;
  const std::string column = "q_" + mimic->name + "_rad";
  EXPECT_TRUE(Taken(TableOf(nao, {{column, right}}), {}, {}, "nao").ok());
  ExpectRefusal(Taken(TableOf(nao, {{column, right + 0.1}}), {}, {}, "nao"), "joint '" + mimic->name + "' mimics '");
}

std::string FileWithNames(const std::string& text) {
  std::string path = ScratchFile("names.yaml");
  EXPECT_TRUE(WriteFileAtomically(path, text).ok());
  return path;
}

TEST(ColumnNamesFile, SaysNamesScalesAndUnits) {
  ImportOptions options;
  const Result<ColumnNames> names = ReadColumnNames(
      FileWithNames("columns: {t: time_s, hip: q_FL_hip_joint_rad}\nscale: {hip: -1}\nignore: [battery]\n"
                    "quaternion_order: wxyz\nangle_unit: rad\nlength_unit: mm\n"),
      options);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  EXPECT_EQ(names->ours.at("hip"), "q_FL_hip_joint_rad");
  EXPECT_EQ(names->scale.at("hip"), -1.0);
  EXPECT_EQ(names->ignored, std::vector<std::string>{"battery"});
  EXPECT_EQ(options.quaternion_order, "wxyz");
  EXPECT_EQ(options.angle_unit, "rad");
  EXPECT_EQ(options.length_unit, "mm");
}

TEST(ColumnNamesFile, AndCommandLineMayNotContradictEachOther) {
  ImportOptions options;
  options.angle_unit = "deg";
  EXPECT_TRUE(ReadColumnNames(FileWithNames("angle_unit: deg\n"), options).ok());
  EXPECT_TRUE(ReadColumnNames(FileWithNames("angle_unit: detect\n"), options).ok());
  EXPECT_EQ(options.angle_unit, "deg");
  const Result<ColumnNames> other = ReadColumnNames(FileWithNames("ignore: []\nangle_unit: rad\n"), options);
  ASSERT_FALSE(other.ok());
  EXPECT_NE(other.failure().message.find("line 2: 'angle_unit' is 'rad' here but 'deg' on the command line"),
            std::string::npos)
      << other.failure().message;
  EXPECT_FALSE(ReadColumnNames(FileWithNames("angle_unit: furlong\n"), options).ok()) << "though it is said elsewhere";
}

TEST(ColumnNamesFile, IsReadStrictly) {
  ImportOptions options;
  const auto why = [&](const std::string& text) { return ReadColumnNames(FileWithNames(text), options).failure(); };
  EXPECT_EQ(why("colums: {}\n").code, FailureCode::kColumnsFile);
  EXPECT_NE(why("colums: {}\n").message.find("'columns'"), std::string::npos) << why("colums: {}\n").message;
  EXPECT_NE(why("scale: {a: 0}\n").message.find("scale of 'a' is 0"), std::string::npos);
  EXPECT_NE(why("angle_unit: turns\n").message.find("line 1"), std::string::npos);
  EXPECT_NE(why("columns: [\n").message.find("line "), std::string::npos);
  EXPECT_NE(why("columns: {t: ''}\n").message.find("'t'"), std::string::npos) << why("columns: {t: ''}\n").message;
  EXPECT_NE(why("columns: &a\n  t: *a\n").message.find("line "), std::string::npos);
}

/// The columns of OCS2's QuadrupedLogger.
CsvTable Ocs2Table() {
  std::string header = "time", row = "0.005";
  const auto add = [&](const std::string& name, double value) {
    header += ", " + name;
    row += fmt::format(", {}", value);
  };
  const std::vector<std::string> legs = {"LF", "RF", "LH", "RH"};
  for (const auto& leg : legs) add("contactflag_" + leg, leg == "RF" ? 0 : 1);
  for (const char* axis : {"x", "y", "z"}) add(fmt::format("base_positionInWorld_{}", axis), 0.3);
  for (const char* part : {"w", "x", "y", "z"}) add(fmt::format("base_quaternion_{}", part), *part == 'w' ? 1.0 : 0.0);
  for (const char* of : {"linear", "angular"}) {
    for (const char* axis : {"x", "y", "z"}) add(fmt::format("base_{}velocityInBase_{}", of, axis), 0.0);
  }
  double value = 0.0;
  for (const char* what : {"jointAngle", "jointVelocity"}) {
    for (const auto& leg : legs) {
      for (const char* joint : {"HAA", "HFE", "KFE"}) add(fmt::format("{}_{}_{}", what, leg, joint), value += 0.01);
    }
  }
  for (const auto& leg : legs) {
    for (const char* axis : {"x", "y", "z"}) add(fmt::format("contactForcesInWorld_{}_{}", leg, axis), value += 0.01);
  }
  const std::string later = "0.0075" + row.substr(row.find(','));
  return *ParseCsvTable(header + ", \n" + row + ", \n" + later + ", \n", "ocs2.csv");
}

TEST(Ocs2Columns, AreTakenAsTheyAre) {
  const CsvTable table = Ocs2Table();
  ASSERT_TRUE(IsOcs2Motion(table));
  EXPECT_FALSE(IsOcs2Motion(TableOf(NamedRobot("a1"))));
  std::vector<DerivedPart> derived;
  const RobotModel& a1 = NamedRobot("a1");
  const Result<ColumnNames> names = Ocs2ColumnNames(a1, table, derived);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  ASSERT_EQ(derived.size(), 1U);
  EXPECT_NE(derived.front().how.find("LF_HAA is FL_hip_joint"), std::string::npos);
  EXPECT_NE(derived.front().how.find("RH_KFE is RR_calf_joint"), std::string::npos);
  const Result<MotionTable> motion = Taken(table, *names);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->quaternion[0], Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
  EXPECT_NEAR(motion->q[0][a1.DofIndex("FL_hip_joint")], 0.01, 1e-12);
  EXPECT_NEAR(motion->q[0][a1.DofIndex("RR_calf_joint")], 0.12, 1e-12);
  EXPECT_NEAR(motion->v[0][a1.DofIndex("FL_hip_joint")], 0.13, 1e-12);
  for (int f = 0; f < 4; ++f)
    EXPECT_EQ(Contains(motion->contact[0], f), a1.feet[static_cast<std::size_t>(f)].link != "FR_foot");
  EXPECT_EQ(motion->unused_columns.size(), 6U);
}

TEST(Ocs2Columns, AMisnamedColumnIsReported) {
  for (const char* theirs : {"jointAngle_LF_HAA", "jointAngle_RH_KFE", "jointVelocity_LH_HFE"}) {
    CsvTable table = Ocs2Table();
    std::replace(table.columns.begin(), table.columns.end(), std::string(theirs), theirs + std::string("x"));
    ASSERT_TRUE(IsOcs2Motion(table));
    std::vector<DerivedPart> derived;
    const Result<ColumnNames> names = Ocs2ColumnNames(NamedRobot("a1"), table, derived);
    ASSERT_FALSE(names.ok());
    EXPECT_NE(names.failure().message.find(fmt::format("'{0}x'; the nearest is '{0}'", theirs)), std::string::npos)
        << names.failure().message;
  }
}

TEST(Ocs2Columns, MayLackWhatIsNotNeeded) {
  CsvTable table = Ocs2Table();
  for (std::string& column : table.columns) {
    if (column.starts_with("contact")) column = "other_" + column;
  }
  std::vector<DerivedPart> derived;
  const Result<ColumnNames> names = Ocs2ColumnNames(NamedRobot("a1"), table, derived);
  ASSERT_TRUE(names.ok()) << names.failure().message;
  EXPECT_TRUE(Taken(table, *names).ok());
}

TEST(Ocs2Columns, NeedALeggedRobotOfThatKind) {
  std::vector<DerivedPart> derived;
  const Result<ColumnNames> names = Ocs2ColumnNames(NamedRobot("nao"), Ocs2Table(), derived);
  ASSERT_FALSE(names.ok());
  EXPECT_NE(names.failure().message.find("robot 'nao' has no such legs"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
