// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/exchange_readers.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/fuzz/inputs.h"
#include "tests/fuzz/motion_laws.h"
#include "tests/fuzz/plan_laws.h"
#include "workflows/compare/compare_motions.h"
#include "workflows/compare/compare_reports.h"
#include "workflows/exchange/csv_motion.h"
#include "workflows/exchange/export_npz.h"
#include "workflows/exchange/footstep_file.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_columns.h"
#include "workflows/exchange/npy_array_internal.h"
#include "workflows/exchange/npz_motion_internal.h"
#include "workflows/exchange/stored_zip.h"

namespace gaitwright::fuzz {
namespace {

Verdict ReadMotionCsv(const std::string& input) {
  const std::string file = InFile(input, ".csv");
  const Result<CsvTable> csv = ReadCsvTable(file);
  if (!csv) return Verdict::kRefused;
  Require(csv->values.size() == static_cast<std::size_t>(csv->rows()) * csv->columns.size(),
          "a table has a value in each cell");
  for (const double value : csv->values) Require(std::isfinite(value), "a table holds finite numbers");
  CsvReading reading;
  return CheckMotion(MotionOfCsv(Quadruped(), *csv, reading), file);
}

/// Laws of each table that may be compared. Missing values are NaN.
void CheckComparedLaws(const ComparedMotion& motion) {
  const MotionRows& rows = motion.rows;
  Require(rows.size() > 0 && rows.q.size() == rows.time_s.size() && rows.v.size() == rows.time_s.size(),
          "a motion has rows");
  Require(std::abs(motion.start_s()) <= kLatestStart && motion.end_s() - motion.start_s() <= kLongestMotion,
          "it lasts at most an hour");
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    Require(k == 0 || rows.time_s[k] > rows.time_s[k - 1], "times rise");
    for (int d = 0; d < Quadruped().num_dofs(); ++d) {
      const double q = rows.q[k][7 + d], v = rows.v[k][6 + d];
      Require(motion.HasJoint(d) ? std::abs(q) <= kMostOfAnything : std::isnan(q),
              "positions of the joints that it has are finite");
      Require(std::isnan(v) || std::abs(v) <= kMostOfAnything, "speeds are finite, or unknown next to missing rows");
    }
    const auto turn = rows.q[k].segment<4>(3);
    Require(turn.array().isNaN().all() || std::abs(turn.norm() - 1.0) < 1e-9,
            "quaternions have length 1, or are missing");
  }
}

Verdict ReadComparedCsv(const std::string& input) {
  const Result<CsvTable> csv = ParseCsvTable(input, "input");
  if (!csv) return Verdict::kRefused;
  const Result<ComparedMotion> motion = ComparedCsv(Quadruped(), *csv, {});
  if (!motion) return Verdict::kRefused;
  CheckComparedLaws(*motion);
  if (motion->rows.size() > 200 || motion->end_s() - motion->start_s() > 5.0) return Verdict::kAccepted;
  Require(CompareMotions(*motion, *motion, {.align = "none"}).same(), "a motion is the same as itself");
  return Verdict::kAccepted;
}

Verdict ReadTrajectory(const std::string& input) {
  const std::string file = InFile(input, ".yaml");
  return CheckMotion(ParseJointTrajectory(Quadruped(), input, "input", {}), file);
}

Verdict ReadTrajectoryJson(const std::string& input) {
  const std::string file = InFile(input, ".json");
  return CheckMotion(ParseJointTrajectoryJson(Quadruped(), input, "input", {}), file);
}

Verdict ReadMotionNpz(const std::string& input) {
  const std::string file = InFile(input, ".npz");
  return CheckMotion(ParseNpzMotion(Quadruped(), input, "input", {}), file);
}

Verdict ReadNpy(const std::string& input) {
  NpyArray array;
  try {
    array = ParseNpy(input);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  Require(array.has_texts ? array.numbers.empty() : array.texts.empty(), "an array has numbers or texts");
  const std::size_t count = array.has_texts ? array.texts.size() : array.numbers.size();
  Require(array.shape.empty() ? count == 1 : count == array.rows() * array.width(), "an array has its shape");
  return Verdict::kAccepted;
}

Verdict ReadColumns(const std::string& input) {
  ImportOptions options;
  const Result<ColumnNames> names = ReadColumnNames(InFile(input, ".yaml"), options);
  if (!names) return Verdict::kRefused;
  for (const auto& [theirs, ours] : names->ours) Require(!theirs.empty() && !ours.empty(), "names are not empty");
  for (const auto& [theirs, factor] : names->scale)
    Require(factor != 0.0 && std::abs(factor) <= 1e12, "a scale is finite and not 0");
  CheckOptions(options.Fields());
  return Verdict::kAccepted;
}

Verdict ReadFootstepFile(const std::string& input) {
  const Result<FootstepSkeleton> steps = ReadFootsteps(Quadruped(), FlatTerrain(), input, "input", 0.005);
  if (!steps) return Verdict::kRefused;
  CheckSchedule(steps->schedule, static_cast<int>(Quadruped().feet.size()));
  Require(steps->schedule.end_s() <= 3600.0, "it lasts at most an hour");
  for (const Foothold& foothold : steps->footsteps.footholds) {
    Require(foothold.foot >= 0 && foothold.foot < static_cast<int>(Quadruped().feet.size()), "its feet exist");
    Require(IsSensible(foothold.X_WF.translation()), "its footholds are finite");
    Require(foothold.touchdown_s <= foothold.liftoff_s, "a foot lands before it lifts");
  }
  return Verdict::kAccepted;
}

Verdict ReadReportFile(const std::string& input) {
  const Result<ReadReport> report = ReportFromJson(input, "input");
  if (!report) return Verdict::kRefused;
  Require(std::isfinite(report->score), "a score is finite");
  for (const ReportedFigure& figure : report->metrics) {
    Require(!figure.key.empty(), "metrics have names");
    Require(std::isfinite(figure.value.value_or(0.0)) && std::isfinite(figure.limit.value_or(0.0)),
            "metrics are finite");
  }
  Require(CompareReports(*report, *report, 0.0).same(), "a report is the same as itself");
  return Verdict::kAccepted;
}

/// Rows of the standing A1, as a CSV with all possible columns.
std::string StandingCsv(const std::string& joint_prefix, const std::string& joint_suffix) {
  const RobotModel& model = Quadruped();
  std::string text = "time_s,base_x_m,base_y_m,base_z_m,base_qx,base_qy,base_qz,base_qw";
  for (const std::string& name : model.dof_names) text += "," + joint_prefix + name + joint_suffix;
  for (int row = 0; row < 6; ++row) {
    text += fmt::format("\n{},0,0,{},0,0,0,1", 0.02 * row, model.standing_base_height_m);
    for (const double q : model.standing_joints) text += fmt::format(",{}", q);
  }
  return text + "\n";
}

std::string StandingOcs2() {
  std::string text = "time,contactflag_LF,contactflag_RF,contactflag_LH,contactflag_RH";
  for (const char* axis : {"x", "y", "z"}) text += std::string(",base_positionInWorld_") + axis;
  for (const char* axis : {"w", "x", "y", "z"}) text += std::string(",base_quaternion_") + axis;
  for (const char* leg : {"LF", "RF", "LH", "RH"}) {
    for (const char* joint : {"HAA", "HFE", "KFE"}) text += fmt::format(",jointAngle_{}_{}", leg, joint);
  }
  for (int row = 0; row < 6; ++row) {
    text += fmt::format("\n{},1,1,1,1,0,0,{},1,0,0,0", 0.02 * row, Quadruped().standing_base_height_m);
    for (int leg = 0; leg < 4; ++leg) {
      for (int joint = 0; joint < 3; ++joint) text += fmt::format(",{}", Quadruped().standing_joints[joint]);
    }
  }
  return text + "\n";
}

std::vector<std::string> MadeTables() { return {StandingCsv("q_", "_rad"), StandingCsv("", ""), StandingOcs2()}; }

std::vector<std::string> MadeTrajectories() {
  std::string names, positions;
  for (const std::string& name : Quadruped().dof_names) names += (names.empty() ? "" : ", ") + name;
  for (const double q : Quadruped().standing_joints) positions += fmt::format("{}{}", positions.empty() ? "" : ", ", q);
  std::string text = "joint_names: [" + names + "]\npoints:\n";
  for (int k = 0; k < 4; ++k)
    text += fmt::format("- positions: [{}]\n  time_from_start: {{sec: 0, nanosec: {}}}\n", positions, k * 20000000);
  return {text};
}

std::vector<std::string> MadeJsonTrajectories() {
  std::string names, positions;
  for (const std::string& name : Quadruped().dof_names) names += (names.empty() ? "\"" : ", \"") + name + "\"";
  for (const double q : Quadruped().standing_joints) positions += fmt::format("{}{}", positions.empty() ? "" : ", ", q);
  std::string text = "{\"joint_names\": [" + names + "], \"points\": [";
  for (int k = 0; k < 4; ++k) {
    text += fmt::format("{}{{\"positions\": [{}], \"time_from_start\": {{\"sec\": 0, \"nanosec\": {}}}}}",
                        k == 0 ? "" : ",\n", positions, k * 20000000);
  }
  return {text + "]}\n"};
}

std::vector<std::string> MadeReports() {
  return {
      R"({"robot":"a1","verdict":"pass","reason":"","score":91.5,"metrics":{"fell":{"value":false,"unit":"","limit":)"
      R"(false,"pass":true},"slip_m":{"value":0.01,"unit":"m","limit":null,"pass":true}}})"};
}

std::vector<std::string> MadeNpys() {
  return {NpyOfNumbers({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, {2, 3}), NpyOfTexts({"FR_hip_joint", "a", ""})};
}

std::vector<std::string> MadeNpzs() {
  const std::size_t rows = 6, n = Quadruped().dof_names.size();
  std::vector<double> q, p, turn;
  for (std::size_t k = 0; k < rows; ++k) {
    q.insert(q.end(), Quadruped().standing_joints.begin(), Quadruped().standing_joints.end());
    p.insert(p.end(), {0.0, 0.0, Quadruped().standing_base_height_m});
    turn.insert(turn.end(), {0.0, 0.0, 0.0, 1.0});
  }
  return {StoredZip({{"dof_pos.npy", NpyOfNumbers(q, {rows, n})},
                     {"root_pos.npy", NpyOfNumbers(p, {rows, 3})},
                     {"root_rot.npy", NpyOfNumbers(turn, {rows, 4})},
                     {"fps.npy", NpyOfNumbers({50.0}, {1})},
                     {"joint_names.npy", NpyOfTexts(Quadruped().dof_names)}})};
}

const std::vector<std::string> kNpyWords = {"<f4", "|O", "<U7", ">i2", "True", "(2, 3)", "()", "(0,)", "'", "}"};

const std::vector<std::string> kCsvWords = {",",
                                            "\n",
                                            "#",
                                            "\"",
                                            "\t",
                                            ";",
                                            "nan",
                                            "true",
                                            "1e308",
                                            "-1",
                                            "time_s",
                                            "base_roll_rad",
                                            "base_x_mm",
                                            "q_FR_hip_joint_deg",
                                            "v_FR_hip_joint_rad_s",
                                            "tau_FR_calf_joint_nm",
                                            "contact_FR_foot",
                                            "force_FR_foot_x_n",
                                            "jointVelocity_LF_HAA",
                                            "contactForcesInWorld_LF_x"};

const std::vector<std::string> kYaml = {"&a", "*a", "---", "{", "}", "[", "]", ": ", "- ", "~", ".nan", "1e400", "-1"};

std::vector<std::string> WithYaml(std::vector<std::string> words) {
  words.insert(words.end(), kYaml.begin(), kYaml.end());
  return words;
}

}  // namespace

std::vector<Reader> ExchangeReaders() {
  return {{"motion_csv", ReadMotionCsv, kCsvWords, {}, MadeTables, 500},
          {"motion_npz", ReadMotionNpz, {"PK\x03\x04", "PK\x01\x02", "PK\x05\x06"}, {}, MadeNpzs, 500},
          {"npy", ReadNpy, kNpyWords, {}, MadeNpys, 500},
          {"compare_csv", ReadComparedCsv, kCsvWords, {}, MadeTables, 500},
          {"column_names",
           ReadColumns,
           WithYaml({"columns", "scale", "ignore", "quaternion_order", "angle_unit", "length_unit", "time_unit", "wxyz",
                     "deg", "mm", "ms"}),
           {}},
          {"joint_trajectory",
           ReadTrajectory,
           WithYaml({"joint_names", "points", "positions", "velocities", "effort", "time_from_start", "sec", "nanosec",
                     "secs", "nsecs", "trajectory", "header"}),
           {},
           MadeTrajectories,
           500},
          {"joint_trajectory_json",
           ReadTrajectoryJson,
           {"null", "true", "{}", "[]", "\"\"", "-1", "1e400", "\"joint_names\"", "\"points\"", "\"positions\"",
            "\"velocities\"", "\"effort\"", "\"time_from_start\"", "\"sec\"", "\"nanosec\"", "\"secs\"",
            "\"trajectory\"", "\\u0000"},
           {},
           MadeJsonTrajectories,
           500},
          {"footsteps",
           ReadFootstepFile,
           WithYaml({"footsteps", "start", "foot", "FL_foot", "FR_foot", "RL_foot", "RR_foot", "x_m", "y_m", "yaw_rad",
                     "z_m", "lift_off_s", "touch_down_s", "swing_s", "pause_s", "initial_stand_s", "final_stand_s"}),
           {}},
          {"report",
           ReadReportFile,
           {"null", "true", "{}", "[]", "\"\"", "-1", "1e400", "\"metrics\"", "\"score\"", "\"verdict\"", "\"value\"",
            "\"limit\"", "\"unit\"", "\"audit\"", "\"violations\"", "\"law\"", "\\u0000"},
           {},
           MadeReports}};
}

}  // namespace gaitwright::fuzz
