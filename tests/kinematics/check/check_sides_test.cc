// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/check/check_robot.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

long CountOf(const std::string& urdf, const std::string& code, const std::string& yaml = "") {
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
  EXPECT_EQ(CountOf(unusual::Plain(), "sides_differ"), 0);
  EXPECT_EQ(CountOf(WithAbductions(out, mirrored), "sides_differ"), 0) << "signs are opposite about x";
  EXPECT_EQ(CountOf(WithAbductions(out, out), "sides_differ"), 1) << "as wide, and another";
  EXPECT_EQ(CountOf(WithAbductions(out, "lower='-0.9' upper='0.4'"), "sides_differ"), 1);
}

TEST(CheckSides, BuiltInRobotsHaveNone) {
  for (const char* name : {"a1", "nao", "h1"})
    EXPECT_EQ(CountOf(LoadNamedRobot(name)->urdf_text, "sides_differ"), 0) << name;
}

TEST(CheckSides, LengthsInMillimetresAreSeen) {
  EXPECT_EQ(CountOf(unusual::Plain(), "odd_size"), 0);
  EXPECT_EQ(CountOf(unusual::Plain(0.3), "odd_size"), 0);
  EXPECT_EQ(CountOf(unusual::Plain(), "odd_size", "scale: 30"), 1);
  EXPECT_EQ(CountOf(unusual::Plain(), "odd_size", "scale: 0.05"), 1);
}

}  // namespace
}  // namespace gaitwright
