// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/joint_trajectory.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

const RobotModel& Quadruped() {
  static const RobotModel model = *ChooseRobot("a1", "");
  return model;
}

/// All joints of the A1, and points as given, each `{positions}` standing for twelve numbers.
std::string Message(const std::string& points) {
  std::string text = "joint_names: [";
  for (const std::string& name : Quadruped().dof_names) text += (text.back() == '[' ? "" : ", ") + name;
  text += "]\npoints:\n" + points;
  const std::string twelve = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]";
  for (std::size_t at = text.find("{twelve}"); at != std::string::npos; at = text.find("{twelve}"))
    text.replace(at, 8, twelve);
  return text;
}

Result<MotionTable> Trajectory(const std::string& text, const ImportOptions& options = {}) {
  return ParseJointTrajectory(Quadruped(), text, "walk.yaml", options);
}

void ExpectWhy(const std::string& text, const std::string& part) {
  const Result<MotionTable> motion = Trajectory(text);
  ASSERT_FALSE(motion.ok()) << part;
  EXPECT_EQ(motion.failure().code, FailureCode::kJointTrajectory);
  EXPECT_NE(motion.failure().message.find(part), std::string::npos) << motion.failure().message;
}

const std::string kFirst = "- {positions: {twelve}, time_from_start: {sec: 0, nanosec: 0}}\n";

TEST(JointTrajectory, BothRosesAndPlainSecondsAreRead) {
  const std::string text = kFirst +
                           "- {positions: {twelve}, time_from_start: {secs: 1, nsecs: 500000000}}\n"
                           "- {positions: {twelve}, time_from_start: 2.25}\n";
  for (const std::string& message : {Message(text), "---\n" + Message(text) + "---\n"}) {
    const Result<MotionTable> motion = Trajectory(message);
    ASSERT_TRUE(motion.ok()) << motion.failure().message;
    EXPECT_EQ(motion->time_s, (std::vector<double>{0.0, 1.5, 2.25}));
    EXPECT_EQ(motion->q[2][7], 7.0);
    EXPECT_TRUE(motion->v.empty() && motion->tau.empty() && motion->base_m.empty());
  }
}

TEST(JointTrajectory, TakesVelocitiesAndEfforts) {
  const std::string point = "positions: {twelve}, velocities: {twelve}, accelerations: {twelve}, effort: {twelve}";
  const Result<MotionTable> motion =
      Trajectory(Message("- {" + point + ", time_from_start: 0}\n- {" + point + ", time_from_start: 0.1}\n"));
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->v[1][3], 3.0);
  EXPECT_EQ(motion->tau[1][11], 11.0);
  EXPECT_TRUE(motion->unused_columns.empty());
  EXPECT_EQ(motion->a.size(), motion->v.size());
}

TEST(JointTrajectory, IsReadStrictly) {
  ExpectWhy(Message(kFirst + kFirst), "time_from_start of 0 s does not come after 0 s of the previous point");
  ExpectWhy(Message("- {positions: [1, 2], time_from_start: 0}\n"),
            "positions has 2 numbers, but joint_names has 12 names");
  ExpectWhy(Message("- {positions: {twelve}}\n"), "time_from_start");
  ExpectWhy(Message(kFirst + "- {positions: {twelve}, velocities: {twelve}, time_from_start: 1}\n"),
            "points[1] has velocities, but the points before lack it; all points must have the same fields");
  ExpectWhy(Message("- {positions: [.nan, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], time_from_start: 0}\n"), "line 3");
  ExpectWhy("joint_names: [FL_hop_joint]\npoints: []\n",
            "robot 'a1' has no joint 'FL_hop_joint'; the nearest is 'FL_hip_joint'");
  ExpectWhy("joint_names: [FL_hip_joint, FL_hip_joint]\npoints: []\n", "joint 'FL_hip_joint' is given twice");
  ExpectWhy("joint_names: [FL_hip_joint]\npoints: []\n", "joint_names lacks 11 of 12 joints of robot 'a1': ");
  ExpectWhy("points: []\n", "joint_names");
  ExpectWhy(Message(kFirst) + "---\n" + Message(kFirst), "a second YAML document begins; exactly one is accepted");
  ExpectWhy("joint_names: [", "line ");
  ExpectWhy("x: " + std::string(100, '[') + std::string(100, ']'),
            "lists and maps are nested more than 32 levels deep");
}

TEST(JointTrajectory, IsComparedWithTheJointsThatItHas) {
  const auto with = [](const std::string& joints, const std::string& positions) {
    return "joint_names: [" + joints + "]\npoints:\n- {positions: [" + positions +
           "], time_from_start: 0}\n- {positions: [" + positions + "], time_from_start: 1}\n";
  };
  const Result<ComparedMotion> side = ComparedTrajectory(Quadruped(), with("FL_hip_joint", "0.1"), "walk.yaml", {});
  ASSERT_TRUE(side.ok()) << side.failure().message;
  for (int d = 0; d < Quadruped().num_dofs(); ++d) EXPECT_EQ(side->HasJoint(d), d == 0);
  const Result<ComparedMotion> none = ComparedTrajectory(Quadruped(), with("", ""), "walk.yaml", {});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.failure().message.find("lacks 12 of 12 joints"), std::string::npos) << none.failure().message;
}

TEST(JointTrajectory, TimesAreSuchAsTheMessageHolds) {
  const auto at = [](const std::string& time) {
    return Message("- {positions: {twelve}, time_from_start: " + time + "}\n");
  };
  ExpectWhy(at("{sec: 1, nsecs: 0}"), "line 3: points[0].time_from_start needs sec and nanosec, or secs and nsecs");
  ExpectWhy(at("{secs: 1, nanosec: 0}"), "needs sec and nanosec, or secs and nsecs");
  ExpectWhy(at("{sec: 1, secs: 1}"), "needs sec and nanosec, or secs and nsecs");
  ExpectWhy(at("{nanosec: 1}"), "needs sec and nanosec, or secs and nsecs");
  ExpectWhy(at("{sec: 0, nanosec: 1000000000}"),
            "time_from_start.nanosec is 1000000000; a whole number from 0 to 999999999 is needed");
  ExpectWhy(at("{sec: 0, nanosec: -1}"), "time_from_start.nanosec is -1; a whole number from 0");
  ExpectWhy(at("{secs: 0.5, nsecs: 0}"), "time_from_start.secs is 0.5; a whole number from 0 to 2147483647 is needed");
  ExpectWhy(at("{sec: -1, nanosec: 0}"), "time_from_start.sec is -1; a whole number from 0");
  ExpectWhy(at("-0.5"), "time_from_start is -0.5; 0 or more is needed");
  ExpectWhy(at("{sec: 0, nanosec: .nan}"), "line 3");
}

TEST(JointTrajectory, ANumberHasTheUnitOfTimes) {
  ImportOptions options;
  options.time_unit = "ms";
  const Result<MotionTable> motion = Trajectory(Message("- {positions: {twelve}, time_from_start: 500}\n"
                                                        "- {positions: {twelve}, time_from_start: {sec: 2}}\n"),
                                                options);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->time_s, (std::vector<double>{0.5, 2.0})) << "what says its unit keeps it";
}

/// These messages as JSON.
std::string JsonMessage(const std::string& points) {
  std::string text = "{\"joint_names\": [";
  for (const std::string& name : Quadruped().dof_names) text += (text.back() == '[' ? "\"" : ", \"") + name + "\"";
  return text + "], \"points\": [" + points + "]}";
}

const std::string kTwelve = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]";

std::string JsonPoint(int nanoseconds) {
  return fmt::format(
      "{{\"positions\": {}, \"velocities\": null, \"time_from_start\": {{\"sec\": 0, \"nanosec\": {}}}}}", kTwelve,
      nanoseconds);
}

std::string ReasonNotJson(const std::string& text) {
  const Result<MotionTable> motion = ParseJointTrajectoryJson(Quadruped(), text, "walk.json", {});
  return motion.ok() ? "" : motion.failure().message;
}

TEST(JointTrajectoryJson, IsReadByTheReaderOfJson) {
  const Result<MotionTable> motion =
      ParseJointTrajectoryJson(Quadruped(), JsonMessage(JsonPoint(0) + ",\n" + JsonPoint(500000000)), "walk.json", {});
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_EQ(motion->time_s, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(motion->q[1][7], 7.0);
  EXPECT_TRUE(motion->v.empty());
  EXPECT_EQ(ReasonNotJson(JsonMessage(JsonPoint(5) + "," + JsonPoint(5))),
            "'walk.json': 'points[1].time_from_start' of 5e-09 s does not come after 5e-09 s of the previous point; "
            "times must increase");
  EXPECT_EQ(ReasonNotJson(JsonMessage(R"({"positions": [1], "time_from_start": 0})")),
            "'walk.json': 'points[0].positions' has 1 numbers, but joint_names has 12 names");
  EXPECT_EQ(ReasonNotJson(JsonMessage(R"({"position": [1], "time_from_start": 0})")),
            "'walk.json': 'points[0]' has an unknown key 'position'; the nearest is 'positions'");
  EXPECT_NE(ReasonNotJson(R"({"joint_names": )").find("its JSON is cut short"), std::string::npos);
  EXPECT_NE(ReasonNotJson("joint_names: []").find("its JSON has a syntax error"), std::string::npos);
  EXPECT_NE(ReasonNotJson("[]").find("object"), std::string::npos) << ReasonNotJson("[]");
}

constexpr int kLong = 60000;  // points; more than the million values that other YAML files may have

TEST(JointTrajectory, LongOnesAreReadInBothLanguages) {
  std::string yaml = "- {positions: &p {twelve}, velocities: *p, effort: *p, time_from_start: 0}\n",
              json = JsonPoint(0);
  for (int k = 1; k < kLong; ++k) {
    if (k < kLong / 2) yaml += fmt::format("- {{positions: *p, velocities: *p, effort: *p, time_from_start: {}}}\n", k);
    json += "," + JsonPoint(k);
  }
  const Result<MotionTable> of_yaml = Trajectory(Message(yaml));
  ASSERT_TRUE(of_yaml.ok()) << of_yaml.failure().message;
  EXPECT_EQ(of_yaml->rows(), kLong / 2);
  const Result<MotionTable> of_json = ParseJointTrajectoryJson(Quadruped(), JsonMessage(json), "walk.json", {});
  ASSERT_TRUE(of_json.ok()) << of_json.failure().message;
  EXPECT_EQ(of_json->rows(), kLong);
}

TEST(JointTrajectory, JointsThatAreNotThereMayStand) {
  ImportOptions options;
  options.missing_joints = "standing";
  const Result<MotionTable> motion =
      Trajectory("joint_names: [FL_hip_joint]\npoints: [{positions: [0.2], time_from_start: 0}]\n", options);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  VectorX expected = Quadruped().standing_joints;
  expected[Quadruped().DofIndex("FL_hip_joint")] = 0.2;
  EXPECT_EQ(motion->q[0], expected);
  ASSERT_EQ(motion->derived.size(), 1U);
}

}  // namespace
}  // namespace gaitwright
