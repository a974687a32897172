// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/exchange/bvh_text.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/bvh_motion_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

std::string HowDerived(const MotionTable& table, const std::string& what) {
  for (const DerivedPart& part : table.derived) {
    if (part.what == what) return part.how;
  }
  return "";
}

void ExpectMotionOf(const MotionTable& table, const std::vector<VectorX>& motion, double tolerance) {
  ASSERT_EQ(table.q.size(), motion.size());
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_LT((table.base_m[k] - motion[k].head<3>()).norm(), tolerance);
    EXPECT_NEAR(std::abs(table.quaternion[k].dot(motion[k].segment<4>(3))), 1.0, tolerance);
    EXPECT_LT((table.q[k] - motion[k].tail(table.q[k].size())).lpNorm<Eigen::Infinity>(), tolerance) << k;
  }
}

std::string ReasonNoMotionIn(const RobotModel& model, const std::string& text, const ImportOptions& options = {}) {
  const auto read = ParseBvhMotion(model, text, "a.bvh", options);
  return read.ok() ? "" : read.failure().message;
}

TEST(BvhMotion, UnitAndAxesFollowFromTheSkeleton) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const std::vector<VectorX> motion = MovingRows(model, 20).q;
    for (const double unit_m : {1.0, 0.01, 0.001}) {
      SCOPED_TRACE(fmt::format("{} {}", name, unit_m));
      BvhWriter writer = SkeletonOf(model, false);
      writer.unit_m = unit_m;
      writer.R_SB = unit_m == 1.0 ? Matrix3(Matrix3::Identity()) : YUpward();
      const auto table = ParseBvhMotion(model, writer.Text(motion, 1.0 / 30.0), "a.bvh", {});
      ASSERT_TRUE(table.ok()) << table.failure().message;
      EXPECT_EQ(table->format, MotionFormat::kFramesBvh);
      ExpectMotionOf(*table, motion, 1e-6);
      EXPECT_NEAR(table->time_s.back(), 19.0 / 30.0, 1e-6);
      EXPECT_EQ(HowDerived(*table, "rotations left out"), "");
      EXPECT_EQ(HowDerived(*table, "skeleton"),
                unit_m == 1.0
                    ? "lengths in m, x forward, y to the left, z upward, from its joints at rest"
                    : fmt::format("lengths in {}, z forward, x to the left, y upward, from its joints at rest",
                                  unit_m == 0.01 ? "cm" : "mm"));
    }
  }
}

TEST(BvhMotion, BallJointsAreSplitOverTheJointsOfTheRobot) {
  const RobotModel& model = NamedRobot("h1");
  const std::vector<VectorX> motion = MovingRows(model, 40).q;
  BvhWriter writer = SkeletonOf(model, true);
  writer.R_SB = YUpward();
  writer.order = "XYZ";
  const auto table = ParseBvhMotion(model, writer.Text(motion, 0.01), "a.bvh", {});
  ASSERT_TRUE(table.ok()) << table.failure().message;
  ExpectMotionOf(*table, motion, 1e-6);
  EXPECT_NE(HowDerived(*table, "ball joints")
                .find("'left_hip' to 'left_hip_yaw_joint', 'left_hip_roll_joint', 'left_hip_pitch_joint'"),
            std::string::npos)
      << HowDerived(*table, "ball joints");
}

TEST(BvhMotion, NamesRotationsThatNoJointCanDo) {
  const RobotModel& model = NamedRobot("a1");
  std::vector<VectorX> motion(5, StandingConfiguration(model));
  std::string text = SkeletonOf(model, false).Text(motion, 0.01);
  // In the last frame, the first joint turns about another axis too.
  BvhWriter writer = SkeletonOf(model, false);
  const std::string frame = writer.AnglesOfChildren(-1, motion[0]);
  std::string turned = frame;
  turned.replace(0, turned.find(' ', 1), " 6");
  text.replace(text.rfind(frame), frame.size(), turned);
  const auto table = ParseBvhMotion(model, text, "a.bvh", {});
  ASSERT_TRUE(table.ok()) << table.failure().message;
  const std::string left = HowDerived(*table, "rotations left out");
  EXPECT_NE(left.find(fmt::format("joint '{}' up to 0.1", writer.names[0])), std::string::npos) << left;
  EXPECT_NE(left.find("at 0.040 s"), std::string::npos) << left;
}

TEST(BvhMotion, RefusesJointsWithoutPartner) {
  const RobotModel& model = NamedRobot("a1");
  const std::vector<VectorX> motion = MovingRows(model, 5).q;
  BvhWriter writer = SkeletonOf(model, false);
  writer.names[2] = "LeftShin";
  const std::string robots = model.dof_names[static_cast<std::size_t>(writer.runs[2].front())];
  const std::string text = writer.Text(motion, 0.01);
  EXPECT_EQ(ReasonNoMotionIn(model, text),
            "'a.bvh': 1 of its joints move no joint of robot 'a1': 'LeftShin'; 1 of 12 joints of robot 'a1' have no "
            "partner in it: '" +
                robots +
                "'; a skeleton is read if it has the robot's own joints, by name, so retarget the motion first");
  const std::vector<VectorX> still(5, [&] {
    VectorX q = StandingConfiguration(model);
    q[7 + writer.runs[2].front()] = 0.0;
    return q;
  }());
  ImportOptions options;
  options.missing_joints = "standing";
  const auto table = ParseBvhMotion(model, writer.Text(still, 0.01), "a.bvh", options);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->unused_columns, std::vector<std::string>{"joint 'LeftShin', which does not turn"});
  const int dof = writer.runs[2].front();
  EXPECT_EQ(table->q[0][dof], model.standing_joints[dof]);
}

TEST(BvhMotion, RefusesAnotherSkeletonOrPosture) {
  const RobotModel& model = NamedRobot("a1");
  const std::vector<VectorX> motion = MovingRows(model, 5).q;
  BvhWriter writer = SkeletonOf(model, false);
  writer.unit_m = 0.15;
  EXPECT_NE(ReasonNoMotionIn(model, writer.Text(motion, 0.01)).find("neither m, cm nor mm; use --length-unit"),
            std::string::npos);
  ImportOptions metres;
  metres.length_unit = "m";
  EXPECT_NE(
      ReasonNoMotionIn(model, writer.Text(motion, 0.01), metres).find("m away from the robot's at zero positions"),
      std::string::npos);
  writer.unit_m = 1.0;
  writer.R_SB = Eigen::AngleAxisd(0.6, Vector3(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  EXPECT_NE(ReasonNoMotionIn(model, writer.Text(motion, 0.01)).find("is turned by 0.60 rad"), std::string::npos);
  std::string flat = SkeletonOf(model, false).Text(motion, 0.01);
  for (std::size_t at = flat.find("OFFSET"); at != std::string::npos; at = flat.find("OFFSET", at + 1))
    flat.replace(at, flat.find('\n', at) - at, "OFFSET 0 0 1");
  EXPECT_NE(ReasonNoMotionIn(model, flat).find("on one line"), std::string::npos);
  EXPECT_EQ(ReasonNoMotionIn(model, "HIERARCHY\nJOINT a\n"), "'a.bvh': line 2: 'ROOT' is expected, found 'JOINT'");
}

}  // namespace
}  // namespace gaitwright
