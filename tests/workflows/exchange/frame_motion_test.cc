// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/named_robot.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/frame_motion_internal.h"

namespace gaitwright {
namespace {

/// Frames with the numbers 0, 1, 2, ... in each.
std::string CountedFrames(int frames, int columns) {
  std::string text;
  for (int row = 0; row < frames; ++row) {
    for (int i = 0; i < columns; ++i) text += (i == 0 ? "" : ",") + std::to_string(i);
    text += "\n";
  }
  return text;
}

TEST(FrameMotion, KnowsTablesWithoutNames) {
  EXPECT_TRUE(LacksColumnNames("1,2,3\n4,5,6\n"));
  EXPECT_TRUE(LacksColumnNames("# made by hand\n1,2,3\n"));
  EXPECT_FALSE(LacksColumnNames("time_s,x,y\n1,2,3\n"));
  EXPECT_FALSE(LacksColumnNames("# time_s,x,y\n1,2,3\n"));
  EXPECT_FALSE(LacksColumnNames(""));
}

TEST(FrameMotion, JointsAreInTheOrderOfTheDescription) {
  const RobotModel& model = NamedRobot("h1");
  const std::vector<std::string> order = DescribedJointOrder(model);
  ASSERT_EQ(order.size(), model.dof_names.size());
  const auto motion = ParseNumberFrames(model, CountedFrames(3, 26), "h1.csv", {});
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->base_m[0], Vector3(0, 1, 2));
  EXPECT_EQ(motion->quaternion[0], Eigen::Vector4d(3, 4, 5, 6));
  for (std::size_t i = 0; i < order.size(); ++i)
    EXPECT_EQ(motion->q[0][model.DofIndex(order[i])], 7.0 + static_cast<double>(i));
  EXPECT_NEAR(motion->time_s[2], 2.0 / 30.0, 1e-12);
}

TEST(FrameMotion, TimesMayComeFirst) {
  const RobotModel& model = NamedRobot("h1");
  const std::string row = ",0,0,1,0,0,0,1" + std::string(",0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0");
  const auto motion = ParseNumberFrames(model, "0" + row + "\n0.5" + row + "\n0.7" + row + "\n", "h1.csv", {});
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->time_s, (std::vector<double>{0.0, 0.5, 0.7}));
  EXPECT_FALSE(ParseNumberFrames(model, CountedFrames(3, 27), "h1.csv", {}).ok()) << "a column that does not rise";
}

TEST(FrameMotion, UnitsAndOrderAreThoseOfTheOptions) {
  const RobotModel& model = NamedRobot("a1");
  ImportOptions options;
  options.quaternion_order = "wxyz";
  options.angle_unit = "deg";
  options.length_unit = "mm";
  const auto motion = ParseNumberFrames(model, CountedFrames(2, 19), "a1.csv", options);
  ASSERT_TRUE(motion.ok());
  EXPECT_NEAR(motion->base_m[0][2], 2e-3, 1e-15);
  EXPECT_EQ(motion->quaternion[0], Eigen::Vector4d(4, 5, 6, 3));
  EXPECT_NEAR(motion->q[0][model.DofIndex(DescribedJointOrder(model)[0])], 7.0 * M_PI / 180.0, 1e-12);
}

TEST(FrameMotion, RefusesFramesOfOtherLengths) {
  const RobotModel& model = NamedRobot("a1");
  const auto motion = ParseJsonFrames(model, "{\"FrameDuration\": 0.02, \"Frames\": [[1, 2]]}", "pace.txt", {});
  ASSERT_FALSE(motion.ok());
  EXPECT_NE(motion.failure().message.find("Frames[0]"), std::string::npos) << motion.failure().message;
  EXPECT_NE(motion.failure().message.find("has 2 numbers; robot 'a1' needs 19"), std::string::npos);
  EXPECT_FALSE(ParseJsonFrames(model, "{\"Frames\": []}", "pace.txt", {}).ok()) << "no duration";
}

TEST(FrameMotion, CoarseFramesAreSmoothed) {
  MotionTable table;
  table.time_s = {0.0, 1.0 / 30.0, 2.0 / 30.0};
  EXPECT_NEAR(CoarseSmoothingHz(table), 6.0, 1e-9);
  table.time_s = {0.0, 0.01, 0.02};
  EXPECT_EQ(CoarseSmoothingHz(table), 0.0);
}

}  // namespace
}  // namespace gaitwright
