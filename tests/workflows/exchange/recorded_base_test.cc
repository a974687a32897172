// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/recorded_base_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

/// Poses that move along x, and turn about z, by equal steps.
RecordedSeries<OdometryMessage> Poses(const std::string& child, int count) {
  RecordedSeries<OdometryMessage> series;
  for (int k = 0; k < count; ++k) {
    OdometryMessage message;
    message.child_frame = child;
    message.p_WC = {0.5 + 0.1 * k, -1.0, 0.3};
    message.turn = Quaternion(Eigen::AngleAxisd(0.2 * k, Vector3::UnitZ())).coeffs();
    message.v_WC = Vector3::UnitX();
    message.w_WC = {0.0, 0.0, 2.0};
    series.messages.push_back(message);
  }
  return series;
}

MotionTable TableAt(const RecordedBase& base, const std::vector<std::int64_t>& rows, const VectorX& joints,
                    const ImportOptions& options = {}) {
  MotionTable table;
  table.q.assign(rows.size(), joints);
  base.AddTo(NamedRobot("a1"), options, rows, table);
  return table;
}

TEST(RecordedBase, IsInterpolatedBetweenMessages) {
  const RobotModel& model = NamedRobot("a1");
  const RecordedBase base(Poses("no_such_link", 3), {100, 200, 300}, "/odom");
  const MotionTable table = TableAt(base, {100, 150, 275, 300}, model.standing_joints);
  const double x_m[] = {0.5, 0.55, 0.675, 0.7}, turn_rad[] = {0.0, 0.1, 0.35, 0.4};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT((table.base_m[k] - Vector3(x_m[k], -1.0, 0.3)).norm(), 1e-12);
    const Quaternion turn(Eigen::AngleAxisd(turn_rad[k], Vector3::UnitZ()));
    EXPECT_NEAR(std::abs(turn.coeffs().dot(table.quaternion[k])), 1.0, 1e-12);
    Vector6 rate;
    rate << turn * Vector3::UnitX(), 0.0, 0.0, 2.0;
    EXPECT_LT((table.base_rate[k] - rate).norm(), 1e-12) << "rates are in the axes of the link";
  }
  EXPECT_NE(table.derived.front().how.find("the robot has no such link"), std::string::npos);
}

TEST(RecordedBase, IsFoundFromAnotherLink) {
  const RobotModel& model = NamedRobot("a1");
  const VectorX joints = model.standing_joints + VectorX::LinSpaced(model.num_dofs(), -0.2, 0.3);
  const RecordedBase base(Poses("robot/FR_calf", 2), {0, 10}, "/odom");
  const MotionTable table = TableAt(base, {0, 10}, joints);
  EXPECT_TRUE(table.base_rate.empty()) << "the rates are those of the other link";
  DynamicsScratch scratch(model);
  for (std::size_t k = 0; k < 2; ++k) {
    VectorX q(model.nq());
    q << table.base_m[k], table.quaternion[k], joints;
    ForwardKinematics(model, q, scratch);
    const Frame& calf = model.frames[static_cast<std::size_t>(model.FrameIndex("FR_calf"))];
    const auto body = static_cast<std::size_t>(calf.body);
    const Vector3 p_WF = scratch.p_WB[body] + scratch.R_WB[body] * calf.X_BF.translation();
    EXPECT_LT((p_WF - Vector3(0.5 + 0.1 * static_cast<double>(k), -1.0, 0.3)).norm(), 1e-12);
    const Matrix3 R_WF = scratch.R_WB[body] * calf.X_BF.linear();
    EXPECT_LT((R_WF - Eigen::AngleAxisd(0.2 * static_cast<double>(k), Vector3::UnitZ()).toRotationMatrix()).norm(),
              1e-12);
  }
}

TEST(RecordedBase, OrderAndUnitsAreThoseOfTheOptions) {
  RecordedSeries<OdometryMessage> series = Poses("trunk", 2);
  for (OdometryMessage& message : series.messages) {
    message.p_WC *= 1000.0;
    message.turn = Eigen::Vector4d(message.turn[3], message.turn[0], message.turn[1], message.turn[2]);
    message.v_WC = message.w_WC = Vector3::Zero();
  }
  ImportOptions options;
  options.length_unit = "mm";
  options.quaternion_order = "wxyz";
  const RecordedBase base(series, {20, 10}, "/odom");
  EXPECT_EQ(base.times(), (std::vector<std::int64_t>{10, 20})) << "ordered by time";
  const MotionTable table = TableAt(base, {10, 20}, NamedRobot("a1").standing_joints, options);
  EXPECT_NEAR(table.base_m[0].x(), 0.6, 1e-12);
  EXPECT_NEAR(table.quaternion[0].z(), std::sin(0.1), 1e-12);
  EXPECT_TRUE(table.base_rate.empty()) << "zero in all messages means that they are not given";
}

TEST(RecordedBase, RefusesBadPosesAndLeavesOutEqualTimes) {
  RecordedSeries<OdometryMessage> series = Poses("trunk", 3);
  EXPECT_EQ(RecordedBase(series, {1, 1, 2}, "/odom").late(), 1);
  const auto why = [&] { return WhatOf<InvalidArgument>([&] { RecordedBase(series, {1, 2, 3}, "/odom"); }); };
  series.messages[1].child_frame = "base";
  EXPECT_EQ(why(), "topic '/odom' has poses of 'trunk' and of 'base'");
  series = Poses("trunk", 3);
  series.messages[2].turn *= 1.1;
  EXPECT_NE(why().find("message 3 of topic '/odom' is not finite"), std::string::npos);
  series = Poses("trunk", 3);
  series.messages[0].p_WC.x() = NAN;
  EXPECT_NE(why().find("message 1"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
