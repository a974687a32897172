// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/start_posture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

class StartPostures : public testing::Test {
 protected:
  const RobotModel& model() const { return GoodPlanOf("a1").model; }
  const MotionPlan& plan() const { return GoodPlanOf("a1").plan; }
  VectorX First() const { return plan().whole_body.q.front().tail(model().num_dofs()); }

  /// Text of a posture file without the joint `without`, if given.
  std::string FileOf(const VectorX& joints, const std::string& without = "", const std::string& indent = "") const {
    std::string text;
    for (int d = 0; d < model().num_dofs(); ++d) {
      const std::string& name = model().dof_names[static_cast<std::size_t>(d)];
      if (name != without) text += fmt::format("{}{}: {:.17g}\n", indent, name, joints[d]);
    }
    return text;
  }
  std::string ReasonRefused(const std::string& text) const {
    const auto read = StartPostureFromYaml(text, "start.yaml", model());
    EXPECT_FALSE(read);
    EXPECT_EQ(read ? FailureKind::kInfeasible : read.failure().kind, FailureKind::kBadInput);
    return read ? "" : read.failure().message;
  }
  void ExpectSaid(const std::string& text, const std::vector<std::string>& parts) const {
    const std::string why = ReasonRefused(text);
    for (const std::string& part : parts) EXPECT_NE(why.find(part), std::string::npos) << why;
  }
};

TEST_F(StartPostures, AreReadAtTheTopAndUnderJoints) {
  const auto flat = StartPostureFromYaml(FileOf(First()), "start.yaml", model());
  ASSERT_TRUE(flat) << flat.failure().message;
  EXPECT_EQ(flat->joints, First());
  EXPECT_FALSE(flat->R_WB);
  const auto under = StartPostureFromYaml(
      "joints:\n" + FileOf(First(), "", "  ") + "base_quaternion_xyzw: [0, 0.6, 0, 0.8]\n", "start.yaml", model());
  ASSERT_TRUE(under) << under.failure().message;
  EXPECT_EQ(under->joints, First());
  EXPECT_NEAR(under->R_WB->y(), 0.6, 1e-12);
}

TEST_F(StartPostures, AreRefusedByNameAndLine) {
  const std::string knee = model().dof_names[2];
  ExpectSaid(FileOf(First(), knee), {"'start.yaml', line 1", "'" + knee + "'", "missing"});
  ExpectSaid(FileOf(First()) + "FR_hip_jiont: 0\n", {"line 13", "no joint 'FR_hip_jiont'", "nearest", "FR_hip_joint"});
  ExpectSaid(FileOf(First()) + knee + ": 0\n", {"twice", knee});
  ExpectSaid(FileOf(First(), knee) + knee + ": 1.5\n", {knee, "1.5 rad", "limits of"});
  ExpectSaid(FileOf(First(), knee) + knee + ": bent\n", {knee, "'bent'", "number"});
  ExpectSaid(FileOf(First(), knee) + knee + ": .nan\n", {knee, "finite"});
  ExpectSaid(FileOf(First()) + "base_quaternion_xyzw: [0, 0, 1]\n", {"3 numbers", "[x, y, z, w]"});
  ExpectSaid(FileOf(First()) + "base_quaternion_xyzw: [0, 0, 1, 1]\n", {"length of 1.414"});
  ExpectSaid("joints:\n  a: 1\nspeed: 2\n", {"'speed'", "accepted: 'joints'"});
  ExpectSaid("[1, 2]\n", {"a list", "a map"});
  ExpectSaid("", {"a map"});
  ExpectSaid("a: [1\n", {"not valid YAML"});
}

TEST_F(StartPostures, InDegreesAreSaidToBe) {
  constexpr double kDegrees = 57.29577951308232;
  const std::string hint = "in degrees";
  ExpectSaid(FileOf(kDegrees * First()), {"line 2", "outside its limits", hint});
  VectorX one = First();
  one[2] = 1.5;
  EXPECT_EQ(ReasonRefused(FileOf(one)).find("degrees"), std::string::npos) << "the others are in rad";
  EXPECT_NE(ReasonRefused(FileOf(one)).find("correct the measurement"), std::string::npos);
}

TEST_F(StartPostures, JointsThatFollowOthersHaveNone) {
  const RobotModel& nao = GoodPlanOf("nao").model;
  for (const Joint& joint : nao.joints) {
    if (!joint.is_mimic) continue;
    const auto read = StartPostureFromYaml(joint.name + ": 0\n", "start.yaml", nao);
    ASSERT_FALSE(read);
    EXPECT_NE(read.failure().message.find("'" + joint.name + "' mimics '"), std::string::npos)
        << read.failure().message;
    return;
  }
  FAIL() << "NAO's hips are coupled";
}

TEST_F(StartPostures, AJumpOfTheFirstCommandIsNamedWithItsSize) {
  AuditOptions options;
  options.start = StartPosture{First(), {}};
  EXPECT_TRUE(Audit(model(), plan(), options)->pass());
  options.start->joints[4] += 0.04;
  EXPECT_TRUE(Audit(model(), plan(), options)->pass());
  options.start->joints[4] += 0.26;
  const auto found = Audit(model(), plan(), options)->violations;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kStartPosture);
  EXPECT_EQ(found[0].where, model().dof_names[4]);
  EXPECT_NEAR(found[0].value, 0.3, 1e-9);
  EXPECT_EQ(found[0].limit, 0.05);
  EXPECT_EQ(found[0].at_s, plan().whole_body.start_s);
  options.start_tolerance_rad = 0.31;
  EXPECT_TRUE(Audit(model(), plan(), options)->pass());
}

TEST_F(StartPostures, AFirstCommandThatMovesIsAJumpForARobotAtRest) {
  MotionPlan moving = plan();
  AuditOptions options;
  options.start = StartPosture{First(), {}};
  const auto speeds = [&] {
    std::vector<Violation> found = Audit(model(), moving, options)->violations;
    std::erase_if(found, [](const Violation& v) { return v.law != Law::kStartPosture; });
    return found;
  };
  EXPECT_TRUE(speeds().empty());
  moving.whole_body.v.front()[6 + 4] = -3.0;
  ASSERT_EQ(speeds().size(), 1U);
  EXPECT_EQ(speeds()[0].where, model().dof_names[4] + ", speed");
  EXPECT_EQ(speeds()[0].value, 3.0);
  EXPECT_EQ(speeds()[0].limit, 0.1);
  EXPECT_EQ(speeds()[0].unit, "rad/s");
  options.start_speed_rad_s = 3.1;
  EXPECT_TRUE(speeds().empty());
  moving.whole_body.v.front().head<3>() = Vector3(0.3, 0.0, 0.4);
  ASSERT_EQ(speeds().size(), 1U);
  EXPECT_EQ(speeds()[0].where, "base, speed");
  EXPECT_NEAR(speeds()[0].value, 0.5, 1e-12);
  options.start.reset();
  EXPECT_TRUE(speeds().empty()) << "only where the robot was measured";
}

TEST_F(StartPostures, OfJointsWithoutLimitsAreBounded) {
  RobotModel endless = model();
  for (Joint& joint : endless.joints) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  }
  const std::string knee = model().dof_names[2];
  for (const char* far : {"1001", "-1e9", "1e300"}) {
    const auto read = StartPostureFromYaml(FileOf(First(), knee) + knee + ": " + far + "\n", "start.yaml", endless);
    ASSERT_FALSE(read) << far;
    EXPECT_NE(read.failure().message.find("'" + knee + "'"), std::string::npos);
    EXPECT_NE(read.failure().message.find(": -1000 to 1000"), std::string::npos) << read.failure().message;
  }
  EXPECT_TRUE(StartPostureFromYaml(FileOf(First(), knee) + knee + ": 999\n", "start.yaml", endless));
}

TEST_F(StartPostures, TheBaseMayBeTurnedButNotTilted) {
  AuditOptions options;
  options.start = StartPosture{First(), Quaternion(Eigen::AngleAxisd(2.0, Vector3::UnitZ()))};
  EXPECT_TRUE(Audit(model(), plan(), options)->pass());
  options.start->R_WB = Quaternion(Eigen::AngleAxisd(0.2, Vector3(0.6, 0.8, 0.0)));
  const auto found = Audit(model(), plan(), options)->violations;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].where, "base tilt");
  EXPECT_NEAR(found[0].value, 0.2, 0.02) << "the plan's first posture is all but level";
}

TEST_F(StartPostures, AQuaternionThatLikelyHasWFirstIsSaidToHaveIt) {
  AuditOptions options;
  const auto measured = [&](const std::string& numbers) {
    options.start = *StartPostureFromYaml(FileOf(First()) + "base_quaternion_xyzw: " + numbers, "start.yaml", model());
    return *Audit(model(), plan(), options);
  };
  const AuditReport first = measured("[1, 0, 0, 0]\n");
  EXPECT_FALSE(first.pass());
  ASSERT_EQ(first.remarks.size(), 1U);
  for (const std::string& text : {AuditText(first), AuditJson(first)}) {
    EXPECT_NE(text.find("the start posture's quaternion seems to have w first"), std::string::npos) << text;
    EXPECT_NE(text.find("write it as base_quaternion_xyzw: [x, y, z, w]"), std::string::npos) << text;
  }
  EXPECT_TRUE(measured("[0, 0, 0, 1]\n").remarks.empty());
  EXPECT_FALSE(measured("[0, 0.68164, 0, 0.73169]\n").pass()) << "it lies on its nose";
  EXPECT_TRUE(measured("[0, 0.68164, 0, 0.73169]\n").remarks.empty()) << "in that order it would not be upright either";
  EXPECT_TRUE(measured("[0, 0.1, 0, 0.994987]\n").remarks.empty()) << "a little off is no other order";
}

}  // namespace
}  // namespace gaitwright
