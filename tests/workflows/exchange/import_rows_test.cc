// SPDX-License-Identifier: BSD-3-Clause
// Missing rows, extra rows, and files that are not motions of other software.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

#include "kinematics/base/file.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/exchange/other_software.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

Result<ImportedMotion> ImportedRows(const std::string& name, const std::string& text) {
  ImportRequest request;
  request.file = ScratchFile(name);
  EXPECT_TRUE(WriteFileAtomically(request.file, text).ok());
  return ImportMotion(NamedRobot("a1"), request);
}

/// How a quantity was derived, or empty.
std::string HowOf(const ImportedMotion& imported, const std::string& what) {
  const std::vector<DerivedPart>& derived = imported.notes.derived;
  const auto found = std::find_if(derived.begin(), derived.end(), [&](const auto& part) { return part.what == what; });
  return found == derived.end() ? "" : found->how;
}

/// The first warning that begins with this text, or empty.
std::string WarningOf(const ImportedMotion& imported, const std::string& begin) {
  for (const std::string& warning : imported.notes.warnings) {
    if (warning.starts_with(begin)) return warning;
  }
  return "";
}

/// The rows without those from one time up to another.
std::string Without(const std::string& csv, double from_s, double to_s) {
  std::istringstream lines(csv);
  std::string text, line;
  std::getline(lines, line);
  text = line + "\n";
  while (std::getline(lines, line)) {
    const double time_s = std::strtod(line.c_str(), nullptr);
    if (time_s < from_s - 1e-9 || time_s >= to_s - 1e-9) text += line + "\n";
  }
  return text;
}

/// Repeats the last row at another time.
std::string WithLastRowAgainAt(const std::string& csv, const std::string& time) {
  const std::size_t last = csv.rfind('\n', csv.size() - 2) + 1;
  return csv + time + csv.substr(csv.find(',', last));
}

TEST(ImportRows, ALastStepThatIsShorterLeavesTheOthersAsTheyAre) {
  OtherWalk walk;
  for (const auto& [step_s, end] : {std::pair(0.005, "3.402"), std::pair(0.002, "3.4005")}) {
    walk.step_s = step_s;
    const Result<ImportedMotion> even = ImportedRows("even.csv", CsvOf(walk)),
                                 more = ImportedRows("more.csv", WithLastRowAgainAt(CsvOf(walk), end));
    ASSERT_TRUE(even.ok() && more.ok()) << more.failure().message;
    EXPECT_EQ(more->plan.whole_body.step_s, step_s);
    EXPECT_EQ(HowOf(*more, "rows"), "") << "they are the file's own";
    EXPECT_NE(HowOf(*more, "end").find("are left out, because this step is shorter than the others"),
              std::string::npos);
    EXPECT_EQ(HowOf(*even, "end"), "");
    ASSERT_EQ(more->plan.whole_body.size(), even->plan.whole_body.size());
    for (std::size_t k = 0; k < even->plan.whole_body.q.size(); ++k)
      ASSERT_LT((even->plan.whole_body.q[k] - more->plan.whole_body.q[k]).norm(), 1e-6) << k;
  }
}

TEST(ImportRows, ALastStepThatIsLongerIsAHoleLikeAnyOther) {
  const Result<ImportedMotion> imported = ImportedRows("late.csv", WithLastRowAgainAt(CsvOf({}), "3.6"));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_NE(HowOf(*imported, "rows"), "");
  EXPECT_NE(WarningOf(*imported, "rows are missing: no row for 0.2 s after 3.4 s of the file"), "");
}

TEST(ImportRows, HolesAreWarnedOf) {
  const std::string whole = CsvOf({}), one = Without(whole, 0.1, 0.4), two = Without(one, 3.0, 3.1);
  const Result<ImportedMotion> of_whole = ImportedRows("whole.csv", whole), of_one = ImportedRows("one.csv", one),
                               of_two = ImportedRows("two.csv", two),
                               of_few = ImportedRows("few.csv", Without(whole, 0.1, 0.115));
  ASSERT_TRUE(of_whole.ok() && of_one.ok() && of_two.ok() && of_few.ok());
  EXPECT_EQ(WarningOf(*of_whole, "rows are missing"), "");
  EXPECT_EQ(WarningOf(*of_few, "rows are missing"), "") << "20 ms";
  const std::string said = WarningOf(*of_one, "rows are missing");
  EXPECT_EQ(said,
            "rows are missing: no row for 0.305 s after 0.095 s of the file; rows are usually 5 ms apart; the "
            "motion in the gap is interpolated, not measured");
  EXPECT_NE(WarningOf(*of_two, "rows are missing in 2 places, and this is the longest gap: no row for 0.305 s"), "");
  const std::vector<std::string>& warnings = of_one->plan.warnings;
  EXPECT_NE(std::find(warnings.begin(), warnings.end(), said), warnings.end()) << "the plan keeps it";
}

/// The rows with other times.
std::string Retimed(const std::string& csv, const std::function<double(int row, double time_s)>& time_of) {
  std::istringstream lines(csv);
  std::string text, line;
  std::getline(lines, line);
  text = line + "\n";
  for (int row = 0; std::getline(lines, line); ++row) {
    const std::size_t comma = line.find(',');
    text += fmt::format("{}{}\n", time_of(row, std::stod(line.substr(0, comma))), line.substr(comma));
  }
  return text;
}

TEST(ImportRows, TimesOfArrivalAreWarnedOf) {
  const std::string whole = CsvOf({});
  const auto late = [](int row, double time_s) { return time_s + 1e-3 * std::sin(2.7 * row); };
  const Result<ImportedMotion> even = ImportedRows("even.csv", whole),
                               uneven = ImportedRows("uneven.csv", Retimed(whole, late));
  ASSERT_TRUE(even.ok() && uneven.ok());
  EXPECT_EQ(WarningOf(*even, "rows are uneven"), "");
  EXPECT_NE(WarningOf(*uneven, "rows are uneven, "), "");
}

TEST(ImportRows, FewRowsAreWarnedOf) {
  OtherStance stance{.base_z_m = NamedRobot("a1").standing_base_height_m};
  stance.step_s = 0.03;
  EXPECT_EQ(WarningOf(*ImportedRows("often.csv", CsvOf(NamedRobot("a1"), stance)), "rows are "), "");
  stance.step_s = 0.2;
  EXPECT_NE(WarningOf(*ImportedRows("seldom.csv", CsvOf(NamedRobot("a1"), stance)), "rows are 200 ms apart"), "");
}

TEST(ImportRows, VelocitiesThatAreNotThoseOfThePositionsAreWarnedOfWithUnitAndTime) {
  OtherStance stance{.base_z_m = NamedRobot("a1").standing_base_height_m};
  stance.turn_columns += ",v_FL_hip_joint_rad_s";
  stance.turn += ",3";
  const Result<ImportedMotion> imported = ImportedRows("still.csv", CsvOf(NamedRobot("a1"), stance));
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  const std::string said = WarningOf(*imported, "the velocities of joint 'FL_hip_joint' differ");
  EXPECT_NE(said.find("by up to 3 rad/s, at 0 s; its largest speed is "), std::string::npos) << said;
}

TEST(ImportRefusals, OwnFilesAreRefusedWithTheCommandForThem) {
  const auto why = [](const std::string& name, const std::string& text) {
    const Result<ImportedMotion> imported = ImportedRows(name, text);
    EXPECT_FALSE(imported.ok()) << name;
    return imported.ok() ? "" : imported.failure().message;
  };
  const std::string plan = R"({"format": "gaitwright-motion-plan", "schema": 3})";
  for (const char* name : {"plan.json", "plan.yaml", "plan.csv"})
    EXPECT_NE(why(name, plan).find("is a plan of this program: 'audit', 'play' and 'compare' accept it directly"),
              std::string::npos)
        << why(name, plan);
  const auto expect = [&](const std::string& text, const std::string& part) {
    const std::string message = why("ours.json", text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect(R"({"format": "gaitwright-playback-log"})",
         "is a log of this program: 'compare' and 'view' accept it directly");
  expect(R"({"format": "gaitwright-playback-log"})", "'export LOG --plan PLAN --out motion.csv'");
  expect(R"({"verdict": "pass", "metrics": {}})", "is a report of this program: it contains no motion");
  expect(R"({"n": 2, "survived": 2, "survival": 1.0})", "is a result of trials of this program: it contains no motion");
}

TEST(ImportRefusals, AFolderIsNoMotion) {
  ImportRequest request;
  for (const char* name : {"a_folder", "motions.csv"}) {
    request.file = ScratchFile(name);
    std::filesystem::create_directories(request.file);
    const Result<ImportedMotion> imported = ImportMotion(NamedRobot("a1"), request);
    ASSERT_FALSE(imported.ok());
    EXPECT_NE(imported.failure().message.find(std::string(name) + "': is a folder"), std::string::npos)
        << imported.failure().message;
  }
}

}  // namespace
}  // namespace gaitwright
