// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/import_motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "kinematics/base/file.h"
#include "planning/plan/plan_json.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/other_software.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// Writes a text to a file in the folder of the tests.
std::string FileWith(const std::string& name, const std::string& text) {
  std::string path = ScratchFile(name);
  EXPECT_TRUE(WriteFileAtomically(path, text).ok());
  return path;
}

Result<ImportedMotion> Imported(const std::string& name, const std::string& text, const ImportOptions& options = {}) {
  ImportRequest request;
  request.file = FileWith(name, text);
  request.options = options;
  return ImportMotion(NamedRobot("a1"), request);
}

std::string ReasonImportMotionRefused(const std::string& text, const ImportOptions& options = {}) {
  const Result<ImportedMotion> imported = Imported("refused.csv", text, options);
  EXPECT_FALSE(imported.ok());
  if (imported.ok()) return "";
  EXPECT_EQ(imported.failure().kind, FailureKind::kBadInput);
  return imported.failure().message;
}

void ExpectSays(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

/// The checks that a report names, each once.
std::vector<Law> LawsOf(const AuditReport& report) {
  std::vector<Law> laws;
  for (const Violation& violation : report.violations) {
    if (std::find(laws.begin(), laws.end(), violation.law) == laws.end()) laws.push_back(violation.law);
  }
  return laws;
}

bool IsDerived(const ImportedMotion& imported, const std::string& what) {
  return std::any_of(imported.notes.derived.begin(), imported.notes.derived.end(),
                     [&](const DerivedPart& part) { return part.what.find(what) != std::string::npos; });
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(ImportOthers, TrotOfOtherSoftwareIsAuditedPlayedAndScored) {
  const Result<ImportedMotion> imported = Imported("trot.csv", CsvOf({}));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_EQ(imported->format, MotionFormat::kCsv);
  EXPECT_EQ(imported->plan.provenance.made_by, "ImportMotion");
  EXPECT_NEAR(imported->plan.duration_s(), 3.4, 1e-9);
  EXPECT_EQ(imported->plan.footsteps.footholds.size(), 4U + 16U);
  for (const char* what : {"velocities", "accelerations", "contacts", "footholds", "swings", "torques", "goal"})
    EXPECT_TRUE(IsDerived(*imported, what)) << what;
  // It trots open loop on the lines between two feet, which the audit reports.
  EXPECT_FALSE(imported->audit.pass());
  const std::vector<Law> laws = LawsOf(imported->audit);
  EXPECT_NE(std::find(laws.begin(), laws.end(), Law::kZmpSupport), laws.end());
  for (const Law law : laws)
    EXPECT_TRUE(law == Law::kConsistency || law == Law::kZmpSupport || law == Law::kDynamics) << law;
  const Result<PlayedWalk> played = PlayWalk(NamedRobot("a1"), imported->plan, {});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  EXPECT_GT(played->report.score, 70.0);
}

TEST(ImportOthers, CrawlThatTipsOverFallsAndTheReportSaysWhy) {
  OtherWalk walk;  // stands long on the two legs of one side, without leaning towards them
  walk.cycle_s = 4.0;
  walk.half_cycles = 2;
  walk.lift_m = 0.08;
  const Result<ImportedMotion> imported = Imported("slow_trot.csv", CsvOf(walk));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  PlayRequest request;
  request.controller = "joint-pd";
  const Result<PlayedWalk> played = PlayWalk(NamedRobot("a1"), imported->plan, request);
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_FALSE(played->report.pass);
  ExpectSays(played->report.reason, {"the robot fell at", "ZMP outside the support"});
  EXPECT_FALSE(imported->audit.pass());
}

TEST(ImportOthers, BaseIsWorkedOutFromTheFeetThatStand) {
  OtherWalk walk;
  const Result<ImportedMotion> with = Imported("with_base.csv", CsvOf(walk));
  walk.with_base = false;
  const Result<ImportedMotion> without = Imported("without_base.csv", CsvOf(walk));
  ASSERT_TRUE(with.ok() && without.ok()) << without.failure().message;
  EXPECT_TRUE(IsDerived(*without, "pose of the base"));
  EXPECT_FALSE(IsDerived(*with, "pose of the base"));
  double farthest = 0.0;
  for (std::size_t k = 0; k < with->plan.whole_body.q.size(); ++k) {
    farthest =
        std::max(farthest, (with->plan.whole_body.q[k].head<3>() - without->plan.whole_body.q[k].head<3>()).norm());
  }
  // The writer's feet do not roll, so that it is short by 0.02 m for each radian of shank rotation.
  EXPECT_GT(farthest, 1e-4);
  EXPECT_LT(farthest, 0.1);
  // The derived base fits its stance feet, except for the smoothing; the writer's base does not.
  const auto off_feet = [](const ImportedMotion& motion) {
    double most = 0.0;
    for (const Violation& violation : motion.audit.violations) {
      if (violation.law == Law::kConsistency) most = std::max(most, violation.value);
    }
    return most;
  };
  EXPECT_LT(off_feet(*without), 1.5e-3);
  EXPECT_GT(off_feet(*with), 3e-3);
  const Result<PlayedWalk> played = PlayWalk(NamedRobot("a1"), without->plan, {});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

TEST(ImportOthers, JointTrajectoryOfRosIsTheSameMotion) {
  OtherWalk walk;
  walk.with_base = false;
  const Result<ImportedMotion> csv = Imported("joints.csv", CsvOf(walk)),
                               ros = Imported("joints.yaml", TrajectoryOf(walk));
  ASSERT_TRUE(csv.ok() && ros.ok()) << ros.failure().message;
  EXPECT_EQ(ros->format, MotionFormat::kJointTrajectory);
  ASSERT_EQ(ros->plan.whole_body.size(), csv->plan.whole_body.size());
  for (std::size_t k = 0; k < ros->plan.whole_body.q.size(); k += 20)
    EXPECT_LT((ros->plan.whole_body.q[k] - csv->plan.whole_body.q[k]).norm(), 1e-6);
}

TEST(ImportOthers, ContactsOfTheFileAreTaken) {
  OtherWalk walk;
  walk.with_contacts = true;
  const Result<ImportedMotion> imported = Imported("flags.csv", CsvOf(walk));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_FALSE(IsDerived(*imported, "contacts"));
  // The first swing begins at 0.53 s; the next row is in the swing.
  EXPECT_NEAR(imported->plan.schedule.phases.front().end_s, 0.535, 1e-9);
}

TEST(ImportOthers, OtherRatesAreBroughtOntoTheGrid) {
  OtherWalk walk;
  walk.step_s = 0.0173;
  const Result<ImportedMotion> coarse = Imported("coarse.csv", CsvOf(walk));
  ASSERT_TRUE(coarse.ok()) << coarse.failure().message;
  EXPECT_EQ(coarse->plan.whole_body.step_s, 0.005);
  EXPECT_TRUE(IsDerived(*coarse, "rows"));
  walk.step_s = 0.002;
  const Result<ImportedMotion> fine = Imported("fine.csv", CsvOf(walk));
  ASSERT_TRUE(fine.ok());
  EXPECT_EQ(fine->plan.whole_body.step_s, 0.002);
}

TEST(ImportOthers, RowsALittleOverTheCoarsestStepApartAreBroughtOntoTheGridToo) {
  OtherWalk walk;
  walk.with_base = false;
  for (const auto& [step_s, grid_s] : {std::pair(0.01, 0.01), std::pair(0.010005, 0.005)}) {
    walk.step_s = step_s;
    const Result<ImportedMotion> imported = Imported("nearly.csv", CsvOf(walk));
    ASSERT_TRUE(imported.ok()) << imported.failure().message;
    EXPECT_EQ(imported->plan.whole_body.step_s, grid_s);
  }
}

TEST(ImportRefusals, QuaternionWithWFirstIsFoundByTheMotion) {
  OtherWalk walk;
  walk.w_first = true;
  ExpectSays(ReasonImportMotionRefused(CsvOf(walk)),
             {"the base's quaternion probably has w first", "leaning by 3.14 rad", "Use --quaternion-order wxyz"});
  ImportOptions options;
  options.quaternion_order = "wxyz";
  EXPECT_TRUE(Imported("w_first.csv", CsvOf(walk), options).ok());
}

TEST(ImportRefusals, UnitsAreFoundByTheMotion) {
  OtherWalk degrees, millimetres, milliseconds;
  degrees.joint_scale = 180.0 / std::numbers::pi;
  millimetres.length_scale = 1000.0;
  milliseconds.time_scale = 1000.0;
  ExpectSays(ReasonImportMotionRefused(CsvOf(degrees)),
             {"_joint' is at -", "within their limits: use --angle-unit deg for degrees"});
  ExpectSays(ReasonImportMotionRefused(CsvOf(millimetres)),
             {"the base is 300 m high, but robot 'a1' stands", "--length-unit mm"});
  ExpectSays(ReasonImportMotionRefused(CsvOf(milliseconds)), {"its rows are 5 s apart", "use --time-unit ms"});
  ImportOptions options;
  options.angle_unit = "deg";
  EXPECT_TRUE(Imported("deg.csv", CsvOf(degrees), options).ok());
  options = {};
  options.length_unit = "mm";
  EXPECT_TRUE(Imported("mm.csv", CsvOf(millimetres), options).ok());
  options = {};
  options.time_unit = "ms";
  EXPECT_TRUE(Imported("ms.csv", CsvOf(milliseconds), options).ok());
}

TEST(ImportRefusals, NamesAreHeldAgainstTheRobot) {
  const std::string good = CsvOf({});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "q_FR_hip_joint_rad", "q_FR_hop_joint_rad")),
             {"column 9 'q_FR_hop_joint_rad' is unknown for robot 'a1'; the nearest is 'q_FR_hip_joint_rad'"});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "q_FR_hip_joint_rad", "shoulder")),
             {"lacks 1 of 12 joint positions of robot 'a1': 'q_FR_hip_joint_rad'", "not used: 'shoulder'"});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "time_s", "moment")), {"has no time column: 'time_s' is needed"});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "base_z_m", "height")),
             {"has 'base_x_m' but lacks 'base_z_m'; all of them are needed, or none"});
  ImportOptions options;
  options.missing_joints = "standing";
  const Result<ImportedMotion> filled =
      Imported("filled.csv", Replaced(good, "q_FR_hip_joint_rad", "shoulder"), options);
  ASSERT_TRUE(filled.ok()) << filled.failure().message;
  EXPECT_TRUE(IsDerived(*filled, "q_FR_hip_joint_rad"));
  EXPECT_EQ(filled->unused_columns, std::vector<std::string>{"shoulder"});
}

TEST(ImportRefusals, TimesMustRise) {
  const std::string good = CsvOf({});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "\n0.01,", "\n0.005,")),
             {"line 4, column 1 'time_s': 0.005 does not come after 0.005 in the previous row; times must increase"});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "\n0.01,", "\n0.001,")), {"0.001 does not come after 0.005"});
  ExpectSays(ReasonImportMotionRefused(Replaced(good, "\n0.01,", "\nnan,")),
             {"line 4, column 1 'time_s' contains 'nan'"});
  std::size_t end = 0;
  for (int line = 0; line < 4; ++line) end = good.find('\n', end) + 1;
  ExpectSays(ReasonImportMotionRefused(good.substr(0, end)), {"has 3 rows; a motion needs 5 or more"});
}

TEST(ImportRefusals, ValuesAreSuchAsMotionsHave) {
  ExpectSays(ReasonImportMotionRefused(Replaced(CsvOf({}), "\n0.005,", "\n0.005,-1e9")),
             {"the base's position of row 2 (0.005 s)", "is -1e+90; at most +-1e+08"});
  ExpectSays(ReasonImportMotionRefused(Replaced(CsvOf({}), "\n0.005,", "\n0.005,-12345")),
             {"s from its start", "a position jumps there"});
}

TEST(ImportRefusals, QuaternionsMustBeRotations) {
  ExpectSays(ReasonImportMotionRefused(Replaced(CsvOf({}), ",0,0,0,1,", ",0,0,0,0.5,")),
             {"the quaternion of row 1 (0 s) has length 0.5; it must be 1"});
}

TEST(ImportRefusals, FeetMustBeNearTheGroundAndStand) {
  ImportOptions options;
  options.lift_m = 0.1;
  ExpectSays(ReasonImportMotionRefused(CsvOf({}), options),
             {"lowest foot is 0.100 m over the ground in most rows", "lift_m="});
  options = {};
  options.contact_speed = 0.0;
  options.contact_height = 0.0;
  ExpectSays(ReasonImportMotionRefused(CsvOf({}), options), {"is never in stance"});
  EXPECT_FALSE(Imported("motion.bag", "x").ok());
  ExpectSays(Imported("motion.bag", "x").failure().message,
             {"accepted: .csv, .tsv, .txt, .npz, .mcap, .db3, .bvh, .yaml, .yml, .json"});
}

TEST(ImportRefusals, ReversedJointsAreNamedFirst) {
  OtherWalk walk;
  walk.joint_scale = -1.0;
  ExpectSays(ReasonImportMotionRefused(CsvOf(walk)),
             {"_calf_joint' and 3 more are past their limits in most rows: check signs"});
}

TEST(ImportOthers, FeetThatDoNotRollAreSaid) {
  // Its thighs rotate by 0.25 rad and more over stance feet: a sphere of 20 mm would roll by 5 mm.
  const Result<ImportedMotion> imported = Imported("points.csv", CsvOf({}));
  ASSERT_TRUE(imported.ok());
  const auto& said = imported->notes.warnings;
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& warning) {
    return warning.starts_with("the file's feet are points, which do not roll");
  }));
}

TEST(ImportOthers, AccelerationsThatAreNotThoseOfTheMotionAreLeftOut) {
  OtherStance stance{.base_z_m = NamedRobot("a1").standing_base_height_m};
  stance.step_s = 0.005;
  stance.turn_columns += ",v_FL_hip_joint_rad_s,a_FL_hip_joint_rad_s2";
  stance.turn += ",0,20";
  const Result<ImportedMotion> imported = Imported("not_so.csv", CsvOf(NamedRobot("a1"), stance));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  for (const VectorX& a : imported->plan.whole_body.a) ASSERT_LT(a.norm(), 1e-6);
  EXPECT_NE(
      std::find(
          imported->notes.warnings.begin(), imported->notes.warnings.end(),
          "the acceleration of joint 'FL_hip_joint' in the file is inconsistent with the positions, and is ignored"),
      imported->notes.warnings.end());
}

TEST(ImportOthers, TheSameFileMakesTheSamePlan) {
  const std::string text = CsvOf({});
  EXPECT_EQ(PlanToJson(Imported("same.csv", text)->plan), PlanToJson(Imported("same.csv", text)->plan));
}

}  // namespace
}  // namespace gaitwright
