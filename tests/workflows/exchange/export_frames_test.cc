// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "tests/named_robot.h"
#include "workflows/exchange/export_frames_internal.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/npy_array_internal.h"
#include "workflows/exchange/read_zip_internal.h"

namespace gaitwright {
namespace {

MotionRows Turning(const RobotModel& model) {
  MotionRows rows;
  for (int k = 0; k < 10; ++k) {
    rows.time_s.push_back(k / 30.0);
    VectorX q = StandingConfiguration(model);
    q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(0.1 * k, Vector3::UnitZ())).coeffs();
    for (int d = 0; d < model.num_dofs(); ++d) q[7 + d] += 0.01 * d;
    rows.q.push_back(q);
    VectorX v = VectorX::Zero(model.nv());
    v[5] = 3.0;
    rows.v.push_back(v);
  }
  return rows;
}

void ExpectReadBack(const Result<MotionTable>& read, const MotionRows& rows) {
  ASSERT_TRUE(read.ok()) << read.failure().message;
  ASSERT_EQ(read->time_s.size(), rows.time_s.size());
  for (std::size_t k = 0; k < rows.q.size(); ++k) {
    EXPECT_NEAR(read->time_s[k], rows.time_s[k], 1e-6);
    EXPECT_LT((read->base_m[k] - rows.q[k].head<3>()).norm(), 2e-6);
    EXPECT_LT((read->quaternion[k] - rows.q[k].segment<4>(3)).norm(), 2e-6);
    EXPECT_LT((read->q[k] - rows.q[k].tail(read->q[k].size())).lpNorm<Eigen::Infinity>(), 1e-6);
  }
}

TEST(ExportFrames, ImportReadsThemBack) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const MotionRows rows = Turning(model);
    ExpectReadBack(ParseNumberFrames(model, FramesCsv(model, rows), "a.csv", {}), rows);
    const std::string json = FramesJson(model, rows, 30.0);
    EXPECT_TRUE(HoldsJsonFrames(json));
    ExpectReadBack(ParseJsonFrames(model, json, "a.json", {}), rows);
  }
}

TEST(ExportFrames, ArraysHoldPosesAndVelocitiesOfAllBodies) {
  const RobotModel& model = NamedRobot("h1");
  const MotionRows rows = Turning(model);
  std::map<std::string, NpyArray> arrays;
  for (const ZipEntry& entry : ReadZip(FramesNpz(model, rows, 30.0), 1U << 24U))
    arrays[entry.name] = ParseNpy(entry.bytes);
  EXPECT_EQ(arrays.at("fps.npy").numbers, std::vector<double>{30.0});
  EXPECT_EQ(arrays.at("joint_names.npy").texts, DescribedJointOrder(model));
  const std::size_t bodies = model.bodies.size();
  EXPECT_EQ(arrays.at("body_pos_w.npy").shape, (std::vector<std::size_t>{10, bodies, 3}));
  EXPECT_EQ(arrays.at("body_names.npy").texts.size(), bodies);
  const auto& turn = arrays.at("body_quat_w.npy").numbers;
  EXPECT_NEAR(turn[3 * bodies * 4], std::cos(0.15), 1e-12) << "w first";
  EXPECT_NEAR(turn[3 * bodies * 4 + 3], std::sin(0.15), 1e-12);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, rows.q[4], scratch);
  const auto &p = arrays.at("body_pos_w.npy").numbers, &v = arrays.at("body_lin_vel_w.npy").numbers;
  const std::size_t last = 3 * (4 * bodies + bodies - 1);
  EXPECT_NEAR(p[last + 1], scratch.p_WB.back().y(), 1e-12);
  const Vector3 lever = scratch.p_WB.back() - scratch.p_WB.front();
  EXPECT_GT(lever.head<2>().norm(), 0.05);
  EXPECT_NEAR(v[last], -3.0 * lever.y(), 1e-9) << "it turns with the base";
  EXPECT_NEAR(v[last + 1], 3.0 * lever.x(), 1e-9);
  EXPECT_NEAR(arrays.at("body_ang_vel_w.npy").numbers[last + 2], 3.0, 1e-12);
}

TEST(ExportFrames, NamesTheOrderAndTheRate) {
  const RobotModel& model = NamedRobot("a1");
  const std::string note = FramesNote(model, 30.0, true);
  EXPECT_NE(note.find(DescribedJointOrder(model)[0] + ", "), std::string::npos);
  EXPECT_NE(note.find("does not contain its rate of 30 frames a second"), std::string::npos);
  EXPECT_EQ(FramesNote(model, 30.0, false).find("rate"), std::string::npos);
}

TEST(ExportFrames, RefuseWhatIsNotFinite) {
  const RobotModel& model = NamedRobot("a1");
  MotionRows rows = Turning(model);
  rows.v[2][7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(FramesCsv(model, rows)) << "it has no velocities";
  EXPECT_THROW(FramesNpz(model, rows, 30.0), InvalidArgument);
  rows.q[2][7] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(FramesCsv(model, rows), InvalidArgument);
  EXPECT_THROW(FramesJson(model, rows, 30.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
