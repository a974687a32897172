// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/check/check_robot.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

long CountOf(const std::string& urdf, FailureCode code, const std::string& yaml = "") {
  const Result<RobotModel> model = LoadRobotFromText(urdf, yaml);
  EXPECT_TRUE(model.ok()) << model.failure().message;
  const std::vector<Finding> findings = CheckRobot(*model);
  return std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
}

/// Limits of the abductions of the left and the right front leg.
std::string WithAbductions(const std::string& left, const std::string& right) {
  std::string urdf = unusual::Plain();
  const std::string limits = "lower='-0.8' upper='0.8'";
  for (const auto& [joint, given] : {std::pair("'a1_joint'", left), std::pair("'b1_joint'", right)}) {
    const std::size_t at = urdf.find(limits, urdf.find(joint));
    urdf.replace(at, limits.size(), given);
  }
  return urdf;
}

TEST(CheckSides, RangesAreComparedAsMirrorImages) {
  const std::string out = "lower='-0.3' upper='0.9'", mirrored = "lower='-0.9' upper='0.3'";
  EXPECT_EQ(CountOf(unusual::Plain(), FailureCode::kSidesDiffer), 0);
  EXPECT_EQ(CountOf(WithAbductions(out, mirrored), FailureCode::kSidesDiffer), 0) << "signs are opposite about x";
  EXPECT_EQ(CountOf(WithAbductions(out, out), FailureCode::kSidesDiffer), 1) << "as wide, and another";
  EXPECT_EQ(CountOf(WithAbductions(out, "lower='-0.9' upper='0.4'"), FailureCode::kSidesDiffer), 1);
}

/// The message on the first joint whose sides differ; "" where none do.
std::string MessageOfSides(const std::string& urdf) {
  for (const Finding& finding : CheckRobot(LoadRobotFromText(urdf, "").value())) {
    if (finding.code == FailureCode::kSidesDiffer) return finding.message;
  }
  return "";
}

TEST(CheckSides, AnUnknownLimitIsCalledSo) {
  const auto with = [](const std::string& left, const std::string& right) {
    std::string urdf = FourLegs();
    for (const auto& [joint, effort] : {std::pair("'A_knee'", left), std::pair("'B_knee'", right)})
      urdf.replace(urdf.find("'30'", urdf.find(joint)), 4, "'" + effort + "'");
    return MessageOfSides(urdf);
  };
  EXPECT_EQ(with("30", "30"), "");
  EXPECT_EQ(with("1e6", "1e9"), "") << "both stand for an unknown limit";
  EXPECT_EQ(with("1e6", "30"), "its effort limit is unknown (no limit), but that of its mirror 'B_knee' is 30 N m");
  EXPECT_EQ(with("30", "1e6"), "its effort limit is 30 N m, but that of its mirror 'B_knee' is unknown (no limit)");
  EXPECT_EQ(with("20", "30"), "its effort limit is 20 N m, but that of its mirror 'B_knee' is 30 N m");
}

TEST(CheckSides, ARangeWithoutLimitsIsCalledSo) {
  std::string urdf = FourLegs();
  urdf.replace(urdf.find("'revolute'", urdf.find("'B_knee'")), 10, "'continuous'");
  urdf.replace(urdf.find(" lower='-2' upper='1'", urdf.find("'B_knee'")), 21, "");
  EXPECT_EQ(MessageOfSides(urdf), "its range is -2 to 1 rad, but its mirror 'B_knee' has no limits");
}

TEST(CheckSides, BuiltInRobotsHaveNone) {
  for (const char* name : {"a1", "nao", "h1"})
    EXPECT_EQ(CountOf(LoadNamedRobot(name)->urdf_text, FailureCode::kSidesDiffer), 0) << name;
}

TEST(CheckSides, LengthsInMillimetresAreSeen) {
  EXPECT_EQ(CountOf(unusual::Plain(), FailureCode::kOddSize), 0);
  EXPECT_EQ(CountOf(unusual::Plain(0.3), FailureCode::kOddSize), 0);
  EXPECT_EQ(CountOf(unusual::Plain(), FailureCode::kOddSize, "scale: 30"), 1);
  EXPECT_EQ(CountOf(unusual::Plain(), FailureCode::kOddSize, "scale: 0.05"), 1);
}

}  // namespace
}  // namespace gaitwright
