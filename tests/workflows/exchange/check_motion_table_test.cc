// SPDX-License-Identifier: BSD-3-Clause
// Motions that may be misinterpreted, and the options that set their interpretation.
#include "workflows/exchange/check_motion_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics/base/file.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/other_software.h"
#include "workflows/exchange/csv_motion.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// A standing robot; its feet are on the ground by default.
OtherStance StanceOf(const RobotModel& model) { return {.base_z_m = model.standing_base_height_m}; }

Result<ImportedMotion> Imported(const RobotModel& model, const OtherStance& stance, const ImportOptions& options = {}) {
  ImportRequest request;
  request.file = ScratchFile("stance.csv");
  EXPECT_TRUE(WriteFileAtomically(request.file, CsvOf(model, stance)).ok());
  request.options = options;
  return ImportMotion(model, request);
}

void ExpectWhy(const Result<ImportedMotion>& imported, const std::vector<std::string>& parts) {
  ASSERT_FALSE(imported.ok()) << parts.front();
  const std::string& message = imported.failure().message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

MotionTable TableOf(const std::string& text, const ImportOptions& options = {}) {
  CsvReading reading{"", options};
  return *MotionOfCsv(NamedRobot("a1"), *ParseCsvTable(text, "motion.csv"), reading);
}

std::string ReasonChecked(const MotionTable& table, const ImportOptions& options = {}) {
  try {
    CheckMotionTable(NamedRobot("a1"), FlatTerrain(), options, table);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(CheckMotionTable, KeyframesFarApartAreTakenWhenTheirUnitIsSaid) {
  OtherStance keyframes = StanceOf(NamedRobot("a1"));
  keyframes.step_s = 0.6;
  keyframes.rows = 5;
  ExpectWhy(Imported(NamedRobot("a1"), keyframes),
            {"its rows are 0.6 s apart", "use --time-unit ms for that unit, or --time-unit s for seconds"});
  ImportOptions seconds;
  seconds.time_unit = "s";
  const Result<ImportedMotion> imported = Imported(NamedRobot("a1"), keyframes, seconds);
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_NEAR(imported->plan.duration_s(), 2.4, 1e-9);
}

TEST(CheckMotionTable, TheUnitOfTimesIsGuessedByTheirSteps) {
  OtherStance stance = StanceOf(NamedRobot("a1"));
  for (const auto& [step, unit] : {std::pair{20.0, "ms"}, {5000.0, "us"}, {5e6, "ns"}, {1e6, "ns"}}) {
    stance.step_s = step;
    ExpectWhy(Imported(NamedRobot("a1"), stance), {fmt::format("use --time-unit {} for that unit", unit)});
    ImportOptions options;
    options.time_unit = unit;
    EXPECT_TRUE(Imported(NamedRobot("a1"), stance, options).ok()) << unit;
  }
}

TEST(CheckMotionTable, RadiansBeyondTheLimitsAreTakenWhenTheyAreSaidToBeSuch) {
  const RobotModel& nao = NamedRobot("nao");
  OtherStance stance = StanceOf(nao);
  stance.joints["LShoulderPitch"] = nao.dof_upper(nao.DofIndex("LShoulderPitch")) + 0.6;
  ExpectWhy(Imported(nao, stance), {"joint 'LShoulderPitch' is at", "--angle-unit rad for radians"});
  ImportOptions radians;
  radians.angle_unit = "rad";
  const Result<ImportedMotion> imported = Imported(nao, stance, radians);
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_FALSE(imported->audit.pass()) << "the audit says what is past its limits";
}

TEST(CheckMotionTable, MetresAreBelievedWhenTheyAreSaidToBeSuch) {
  OtherStance stance = StanceOf(NamedRobot("a1"));
  stance.base_z_m = 300.0;
  ExpectWhy(Imported(NamedRobot("a1"), stance),
            {"use --length-unit mm for millimetres, or --length-unit m for metres"});
  ImportOptions metres;
  metres.length_unit = "m";
  ExpectWhy(Imported(NamedRobot("a1"), stance, metres), {"over the ground in most rows"});
}

TEST(CheckMotionTable, AWrongHeightIsNotLaidToTheOrderOfTheQuaternion) {
  const RobotModel& a1 = NamedRobot("a1");
  const OtherStance low;  // its base is at height 0
  const std::string lift = fmt::format("--set lift_m={:.4f}", a1.standing_base_height_m);
  ExpectWhy(Imported(a1, low), {"under the ground in most rows", lift});
  ImportOptions options;
  options.lift_m = 0.2;
  ExpectWhy(Imported(a1, low, options), {"under the ground in most rows", lift});
  options.lift_m = a1.standing_base_height_m;
  const Result<ImportedMotion> imported = Imported(a1, low, options);
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
}

TEST(CheckMotionTable, TheOrderIsStillAskedWhereHeightsAreWrong) {
  OtherStance low;
  low.turn = "1,0,0,0";
  const std::string why = ReasonChecked(TableOf(CsvOf(NamedRobot("a1"), low)));
  EXPECT_NE(why.find("the base's quaternion probably has w first"), std::string::npos) << why;
  low.turn = "0,0.7071,0,0.7071";  // on its side in both orders
  const std::string neither = ReasonChecked(TableOf(CsvOf(NamedRobot("a1"), low)));
  EXPECT_NE(neither.find("the robot is not upright with either order of the base's quaternion"), std::string::npos)
      << neither;
}

TEST(CheckMotionTable, AStandingRobotIsTakenAsItIsNamed) {
  OtherStance stance = StanceOf(NamedRobot("a1"));
  for (const char* turn : {"0,0,0,1", "0,0,1,0"}) {
    stance.turn = turn;
    EXPECT_EQ(ReasonChecked(TableOf(CsvOf(NamedRobot("a1"), stance))), "") << turn;
  }
}

TEST(CheckMotionTable, AnglesOfTheBaseHaveNoOrder) {
  OtherStance stance = StanceOf(NamedRobot("a1"));
  stance.turn_columns = "base_roll_rad,base_pitch_rad,base_yaw_rad";
  stance.turn = "1.3,0,0";
  EXPECT_EQ(ReasonChecked(TableOf(CsvOf(NamedRobot("a1"), stance))), "") << "a robot may lean";
  ImportOptions options;
  options.quaternion_order = "wxyz";
  stance.turn = "0,0,0";
  const MotionTable table = TableOf(CsvOf(NamedRobot("a1"), stance), options);
  EXPECT_EQ(ReasonChecked(table, options), "");
  EXPECT_EQ(table.quaternion.front(), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
}

TEST(CheckMotionTable, ClocksAreBounded) {
  MotionTable table = TableOf(CsvOf(NamedRobot("a1"), StanceOf(NamedRobot("a1"))));
  table.time_s.back() = 3601.0;
  ImportOptions seconds;
  seconds.time_unit = "s";
  EXPECT_NE(ReasonChecked(table, seconds).find("lasts 3601 s; at most 3600 s are accepted"), std::string::npos);
  for (std::size_t k = 0; k < table.time_s.size(); ++k) table.time_s[k] = 1e11 + static_cast<double>(k);
  EXPECT_NE(ReasonChecked(table, seconds).find("begins at 1e+11 s"), std::string::npos);
}

std::string ReasonNoGrid(double grid_step_s, double duration_s) {
  ImportOptions options;
  options.grid_step_s = grid_step_s;
  MotionTable table = TableOf(CsvOf(NamedRobot("a1"), StanceOf(NamedRobot("a1"))));
  table.time_s.back() = duration_s;
  std::vector<DerivedPart> derived;
  std::vector<std::string> warnings;
  try {
    Resample(NamedRobot("a1"), table, options, derived, warnings);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(GridStep, IsNoneOrOneThatAPlanCanHave) {
  EXPECT_EQ(ReasonNoGrid(0.0, 1.0), "");
  EXPECT_EQ(ReasonNoGrid(0.0005, 1.0), "");
  EXPECT_EQ(ReasonNoGrid(1e-9, 1.0), "option 'grid_step_s' is 1e-09 s; accepted: 0, and 0.0005 to 0.01");
  EXPECT_EQ(ReasonNoGrid(0.02, 1.0), "option 'grid_step_s' is 0.02 s; accepted: 0 to 0.01");
  EXPECT_EQ(ReasonNoGrid(0.0005, 3600.0),
            "its 3600 s at steps of 0.0005 s would need 7200001 rows; at most 1000000 are accepted; raise grid_step_s");
  ImportOptions options;
  options.grid_step_s = 1e-9;
  EXPECT_THROW((void)Imported(NamedRobot("a1"), StanceOf(NamedRobot("a1")), options), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
