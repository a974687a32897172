// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_trajectory.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/workflows/exchange/quoted_walker.h"
#include "workflows/exchange/joint_trajectory.h"

namespace gaitwright {
namespace {

TEST(JointTrajectoryText, IsReadBackExactlyAsYaml) {
  const QuotedWalker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const Result<MotionTable> read =
      ParseJointTrajectory(walker.model, JointTrajectoryYaml(walker.model, rows), "trajectory.yaml", {});
  ASSERT_TRUE(read) << read.failure().message;
  ASSERT_EQ(read->rows(), rows.size());
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    EXPECT_NEAR(read->time_s[k], rows.time_s[k] - rows.time_s.front(), 0.6e-9) << "whole nanoseconds";
    ASSERT_TRUE(AreSame(read->q[k], rows.q[k].tail(6)) && AreSame(read->v[k], rows.v[k].tail(6))) << k;
    ASSERT_TRUE(AreSame(read->tau[k], rows.tau[k])) << k;
  }
}

TEST(JointTrajectoryText, IsTheSameMessageAsJson) {
  const QuotedWalker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const auto json = nlohmann::json::parse(JointTrajectoryJson(walker.model, rows));
  EXPECT_EQ(json.at("header").dump(), R"({"frame_id":"","stamp":{"nanosec":0,"sec":0}})");
  EXPECT_EQ(json.at("joint_names"), nlohmann::json(walker.model.dof_names));
  ASSERT_EQ(json.at("points").size(), rows.time_s.size());
  const nlohmann::json& point = json.at("points").at(333);
  EXPECT_EQ(point.at("time_from_start"), (nlohmann::json{{"sec", 1}, {"nanosec", 332000000}}));
  for (int dof = 0; dof < 6; ++dof) {
    EXPECT_EQ(point.at("positions").at(static_cast<std::size_t>(dof)), rows.q[333][7 + dof]);
    EXPECT_EQ(point.at("accelerations").at(static_cast<std::size_t>(dof)), rows.a[333][6 + dof]);
    EXPECT_EQ(point.at("effort").at(static_cast<std::size_t>(dof)), rows.tau[333][dof]);
  }
}

TEST(JointTrajectoryText, IsReadBackExactlyAsJson) {
  const QuotedWalker walker;
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  const Result<MotionTable> read =
      ParseJointTrajectoryJson(walker.model, JointTrajectoryJson(walker.model, rows), "trajectory.json", {});
  ASSERT_TRUE(read) << read.failure().message;
  ASSERT_EQ(read->rows(), rows.size());
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    ASSERT_TRUE(AreSame(read->q[k], rows.q[k].tail(6)) && AreSame(read->v[k], rows.v[k].tail(6))) << k;
    ASSERT_TRUE(AreSame(read->tau[k], rows.tau[k])) << k;
  }
}

TEST(JointTrajectoryText, HasDecimalsThatEveryReaderTakesForSuch) {
  QuotedWalker walker;
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 250.0);
  rows.q[0].tail(6) << 2.0, 1e-5, -0.0, 1e20, 0.1, -3.0;
  const std::string yaml = JointTrajectoryYaml(walker.model, rows);
  EXPECT_TRUE(synthetic::Says(yaml, "- positions: [2.0, 1.0e-05, 0.0, 1.0e+20, 0.1, -3.0]\n")) << yaml.substr(0, 400);
}

TEST(JointTrajectoryText, OfALogHasEmptyAccelerations) {
  const QuotedWalker walker;
  const MotionRows rows = RowsOfLog(walker.model, walker.log, 100.0);
  const auto json = nlohmann::json::parse(JointTrajectoryJson(walker.model, rows));
  EXPECT_TRUE(json.at("points").at(0).at("accelerations").empty());
  EXPECT_EQ(json.at("points").at(0).at("effort").size(), 6U);
}

TEST(JointTrajectoryText, NamesTheJointAndTheTimeOfWhatIsNotFinite) {
  const QuotedWalker walker;
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  rows.v[3][6 + 1] = INFINITY;
  EXPECT_EQ(RefusalText([&] { JointTrajectoryYaml(walker.model, rows); }),
            "'velocities' of joint 'left_y' is inf at 0.03 s; only finite numbers are exported");
  EXPECT_EQ(RefusalText([&] { JointTrajectoryJson(walker.model, rows); }),
            RefusalText([&] { JointTrajectoryYaml(walker.model, rows); }));
}

}  // namespace
}  // namespace gaitwright
