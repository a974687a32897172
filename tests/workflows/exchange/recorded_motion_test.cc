// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/workflows/exchange/mcap_bytes.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/export_mcap_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

Result<MotionTable> MotionIn(const RobotModel& model, const std::string& file, const ImportOptions& options = {}) {
  return ParseRecordedMotion(model, file, {}, "walk.mcap", options);
}

std::string ReasonNotIn(const RobotModel& model, const std::string& file, const ImportOptions& options = {}) {
  const auto read = MotionIn(model, file, options);
  return read.ok() ? "" : read.failure().message;
}

std::string SaidAbout(const MotionTable& table, const std::string& what) {
  const auto found =
      std::find_if(table.derived.begin(), table.derived.end(), [&](const auto& part) { return part.what == what; });
  return found == table.derived.end() ? "" : found->how;
}

TEST(RecordedMotion, JointsAreFoundByNameAndOthersAreListed) {
  const RobotModel& model = NamedRobot("a1");
  const MotionRows rows = MovingRows(model, 20);
  std::vector<std::string> names = model.dof_names;
  std::reverse(names.begin(), names.end());
  Recorder recorder;
  for (std::size_t k = 0; k < 20; ++k) {
    JointStateMessage state = StateOf(model, rows.q[k], names);
    state.names.push_back("gripper");
    state.positions.push_back(9.0);
    recorder.Add("/joint_states", kJointStateType, 1'700'000'000'000'000'000 + 10'000'000 * static_cast<int>(k), state);
  }
  const auto table = MotionIn(model, recorder.Finish());
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->format, MotionFormat::kRosBag);
  ASSERT_EQ(table->rows(), 20);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_NEAR(table->time_s[k], rows.time_s[k], 1e-12) << "from 0, since 1970 would cost digits";
    EXPECT_LT((table->q[k] - rows.q[k].tail(model.num_dofs())).norm(), 1e-12);
  }
  EXPECT_TRUE(table->v.empty() && table->tau.empty() && table->base_m.empty());
  EXPECT_EQ(table->unused_columns, std::vector<std::string>{"joint 'gripper'"});
  EXPECT_EQ(SaidAbout(*table, "times"), "times of recording, counted from 1700000000000000000 ns");
}

/// Legs in front every 10 ms; hind legs and base every 20 ms, in the middle between these.
std::string Scattered(const RobotModel& model, const MotionRows& rows) {
  Recorder recorder;
  std::vector<std::string> front, hind;
  for (const std::string& name : model.dof_names) (name[0] == 'F' ? front : hind).push_back(name);
  front.push_back(hind.back());
  hind.pop_back();
  for (std::size_t k = 0; k < rows.q.size(); ++k) {
    const auto time_ns = 10'000'000 * static_cast<std::int64_t>(k + 1);
    JointStateMessage state = StateOf(model, rows.q[k], k % 2 == 0 ? front : hind);
    state.stamp_ns = time_ns;
    recorder.Add("/joint_states", kJointStateType, 77, state);
    if (k % 2 == 0) continue;
    OdometryMessage pose;
    pose.stamp_ns = time_ns;
    pose.child_frame = "trunk";
    pose.p_WC = rows.q[k].head<3>();
    pose.turn = rows.q[k].segment<4>(3);
    recorder.Add("/odom", kOdometryType, 77, pose);
  }
  return recorder.Finish();
}

TEST(RecordedMotion, SeveralPublishersAreJoinedOnTheTimesOfTheLargest) {
  const RobotModel& model = NamedRobot("a1");
  const MotionRows rows = MovingRows(model, 21);
  const auto table = MotionIn(model, Scattered(model, rows));
  ASSERT_TRUE(table.ok()) << table.failure().message;
  ASSERT_EQ(table->rows(), 9) << "rows 2, 4, ... 18, at which all is known";
  for (std::size_t k = 0; k < 9; ++k) {
    const VectorX& q = rows.q[2 * k + 2];
    EXPECT_LT((table->q[k] - q.tail(model.num_dofs())).norm(), 1e-9) << "linear motion is interpolated exactly";
    EXPECT_LT((table->base_m[k] - q.head<3>()).norm(), 1e-9);
    EXPECT_LT((table->quaternion[k] - q.segment<4>(3)).norm(), 1e-9);
    EXPECT_NEAR(table->time_s[k], 0.02 * static_cast<double>(k), 1e-12);
  }
  EXPECT_EQ(SaidAbout(*table, "rows"), "2 rows are left out, at which some topic or joint has no value");
  EXPECT_EQ(SaidAbout(*table, "times"), "stamps of the messages, counted from 30000000 ns");
}

TEST(RecordedMotion, FilesOfABagFollowOneAnother) {
  const RobotModel& model = NamedRobot("a1");
  const MotionRows rows = MovingRows(model, 10);
  std::vector<std::string> files;
  for (std::size_t part = 0; part < 2; ++part) {
    Recorder recorder;
    for (std::size_t k = 5 * part; k < 5 * part + 5; ++k) {
      recorder.Add("/joint_states", kJointStateType, 10'000'000 * static_cast<int>(k),
                   StateOf(model, rows.q[k], model.dof_names));
    }
    files.push_back(recorder.Finish());
  }
  const auto table = ParseRecordedMotion(model, files[1], {files[0]}, "bag", {});
  ASSERT_TRUE(table.ok()) << table.failure().message;
  ASSERT_EQ(table->rows(), 10) << "in the order of their times";
  for (std::size_t k = 0; k < 10; ++k) EXPECT_LT((table->q[k] - rows.q[k].tail(model.num_dofs())).norm(), 1e-12);
}

TEST(RecordedMotion, ATrajectoryIsReadWhereThereAreNoStates) {
  const RobotModel& model = NamedRobot("a1");
  MotionRows rows = MovingRows(model, 10);
  rows.a.assign(10, VectorX::LinSpaced(model.nv(), 1.0, 2.0));
  ImportOptions options;
  options.topics = "/joint_trajectory";
  const auto table = MotionIn(model, MotionMcap(model, rows), options);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->format, MotionFormat::kRosBagTrajectory);
  ASSERT_EQ(table->rows(), 10);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_LT((table->q[k] - rows.q[k].tail(model.num_dofs())).norm(), 1e-12);
    EXPECT_LT((table->v[k] - rows.v[k].tail(model.num_dofs())).norm(), 1e-12);
    EXPECT_LT((table->a[k] - rows.a[k].tail(model.num_dofs())).norm(), 1e-12);
    EXPECT_LT((table->tau[k] - rows.tau[k]).norm(), 1e-12);
  }
  EXPECT_NE(std::find(table->unused_columns.begin(), table->unused_columns.end(), "topic '/joint_states'"),
            table->unused_columns.end());
}

TEST(RecordedMotion, MissingJointsAreRefusedOrStand) {
  const RobotModel& model = NamedRobot("a1");
  const MotionRows rows = MovingRows(model, 5);
  std::vector<std::string> names = model.dof_names;
  names.pop_back();
  Recorder recorder;
  for (std::size_t k = 0; k < 5; ++k)
    recorder.Add("/s", kJointStateType, 10'000'000 * static_cast<int>(k), StateOf(model, rows.q[k], names));
  const std::string file = recorder.Finish();
  EXPECT_EQ(ReasonNotIn(model, file),
            "'walk.mcap': topic '/s' lacks 1 of 12 joints of robot 'a1': '" + model.dof_names.back() + "'");
  ImportOptions options;
  options.missing_joints = "standing";
  const auto table = MotionIn(model, file, options);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_EQ(table->q[3][11], model.standing_joints[11]);
}

TEST(RecordedMotion, UnitsOfTheOptionsApply) {
  const RobotModel& model = NamedRobot("a1");
  Recorder recorder;
  for (int k = 0; k < 5; ++k) {
    JointStateMessage state = StateOf(model, StandingConfiguration(model), model.dof_names);
    state.positions.assign(12, 90.0);
    state.velocities.assign(12, 180.0);
    recorder.Add("/s", kJointStateType, 10'000'000 * k, state);
  }
  ImportOptions options;
  options.angle_unit = "deg";
  const auto table = MotionIn(model, recorder.Finish(), options);
  ASSERT_TRUE(table.ok()) << table.failure().message;
  EXPECT_NEAR(table->q[0][0], M_PI / 2.0, 1e-12);
  EXPECT_NEAR(table->v[0][0], M_PI, 1e-12);
}

TEST(RecordedMotion, RefusesWhatIsNoMotion) {
  const RobotModel& model = NamedRobot("a1");
  const auto with = [&](auto change, std::int64_t odometry_ns = 0) {
    Recorder recorder;
    for (int k = 0; k < 3; ++k) {
      JointStateMessage state = StateOf(model, StandingConfiguration(model), model.dof_names);
      change(state);
      recorder.Add("/s", kJointStateType, 1000 + k, state);
    }
    OdometryMessage pose;
    pose.turn = {0.0, 0.0, 0.0, 1.0};
    if (odometry_ns > 0) recorder.Add("/odom", kOdometryType, odometry_ns, pose);
    return ReasonNotIn(model, recorder.Finish());
  };
  EXPECT_NE(with([](auto& state) { state.positions[3] = NAN; }).find("is nan at 1000 ns"), std::string::npos);
  EXPECT_NE(with([](auto& state) { state.positions.clear(); }).find("has no positions of joints"), std::string::npos);
  EXPECT_NE(with([](auto&) {}, 500).find("topics '/s' and '/odom' have no time in common"), std::string::npos);
  Recorder twice;
  for (int k = 0; k < 2; ++k) twice.Add("/t", kJointTrajectoryType, k, JointTrajectoryMessage{0, model.dof_names, {}});
  EXPECT_NE(ReasonNotIn(model, twice.Finish()).find("topic '/t' has 2 joint trajectories"), std::string::npos);
  EXPECT_NE(ReasonNotIn(model, "abc").find("'walk.mcap': it is not an MCAP file"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
