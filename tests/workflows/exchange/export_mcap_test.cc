// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/export_mcap_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/exchange/recorded_topics_internal.h"

namespace gaitwright {
namespace {

TEST(ExportMcap, ImportReadsItBack) {
  for (const char* name : {"a1", "h1"}) {
    SCOPED_TRACE(name);
    const RobotModel& model = NamedRobot(name);
    const MotionRows rows = synthetic::MovingRows(model, 30);
    const auto table = ParseRecordedMotion(model, MotionMcap(model, rows), {}, "walk.mcap", {});
    ASSERT_TRUE(table.ok()) << table.failure().message;
    ASSERT_EQ(table->rows(), 30);
    for (std::size_t k = 0; k < 30; ++k) {
      EXPECT_NEAR(table->time_s[k], rows.time_s[k], 1e-9);
      EXPECT_LT((table->base_m[k] - rows.q[k].head<3>()).norm(), 1e-12);
      EXPECT_LT((table->quaternion[k] - rows.q[k].segment<4>(3)).norm(), 1e-12);
      EXPECT_LT((table->base_rate[k] - rows.v[k].head<6>()).norm(), 1e-12);
      EXPECT_EQ(table->q[k], rows.q[k].tail(model.num_dofs()));
      EXPECT_EQ(table->v[k], rows.v[k].tail(model.num_dofs()));
      EXPECT_EQ(table->tau[k], rows.tau[k]);
    }
    EXPECT_EQ(table->unused_columns, std::vector<std::string>{"topic '/joint_trajectory'"});
  }
}

TEST(ExportMcap, HasOneTrajectoryWithTimesFromItsStart) {
  const RobotModel& model = NamedRobot("a1");
  MotionRows rows = synthetic::MovingRows(model, 4);
  for (double& time_s : rows.time_s) time_s += 2.5;
  RecordedTopics topics;
  ReadRecording(MotionMcap(model, rows), topics);
  const auto& messages = topics.trajectories.at("/joint_trajectory").messages;
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].stamp_ns, 2'500'000'000);
  ASSERT_EQ(messages[0].points.size(), 4U);
  EXPECT_EQ(messages[0].points[3].from_start_ns, 30'000'000);
  EXPECT_TRUE(messages[0].points[3].accelerations.empty());
  EXPECT_EQ(topics.odometry.at("/odom").messages[0].child_frame, "base");
}

TEST(ExportMcap, RefusesWhatIsNotFinite) {
  const RobotModel& model = NamedRobot("a1");
  MotionRows rows = synthetic::MovingRows(model, 4);
  rows.q[2][9] = NAN;
  EXPECT_THROW(MotionMcap(model, rows), InvalidArgument);
  rows = synthetic::MovingRows(model, 4);
  rows.time_s[0] = -1.0;
  EXPECT_THROW(MotionMcap(model, rows), InvalidArgument) << "MCAP has no times below 0";
}

}  // namespace
}  // namespace gaitwright
