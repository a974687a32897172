// SPDX-License-Identifier: BSD-3-Clause
// Time is told by the tests: nothing here depends on how fast the machine is.
#include "examples/hardware_adapter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "examples/stream_plan.h"

namespace gaitwright::examples {
namespace {

constexpr double kUntilItComes = 30.0;  // [s]; longer than anything takes that is sure to come

/// A command to two joints.
JointCommand ACommand() {
  JointCommand command;
  command.q = VectorX::Constant(2, 0.3);
  command.v = VectorX::Constant(2, 0.1);
  command.tau_ff = VectorX::Constant(2, 8.0);
  command.stiffness = VectorX::Constant(2, 100.0);
  command.damping = VectorX::Constant(2, 10.0);
  return command;
}

NumberedParts StateOf(std::uint64_t number, double q) { return {number, {VectorX::Constant(2, q), VectorX::Zero(2)}}; }

TEST(HardwareAdapterExample, ARowSaysWhatWasSaidAndNothingElseIsBelieved) {
  const NumberedParts said{7, {Vector2(1.0, -2.0), Vector2(0.25, 1e-9)}};
  const std::vector<double> row = RowOf(said);
  const NumberedParts read = PartsOf(row, 2, 2).value();
  EXPECT_EQ(read.number, 7U);
  EXPECT_EQ(read.parts, said.parts);
  EXPECT_FALSE(PartsOf(row, 2, 5));
  EXPECT_FALSE(PartsOf({}, 2, 2));
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::vector<double> spoilt = row;
    spoilt[3] = wrong;
    EXPECT_FALSE(PartsOf(spoilt, 2, 2));
  }
  EXPECT_FALSE(PartsOf({-1.0, 0.0, 0.0, 0.0, 0.0}, 2, 2));
}

TEST(HardwareAdapterExample, NewerStatesCountOnceAndOthersNot) {
  const LoopbackSocket robot, stranger;
  HardwareAdapter adapter(robot.port());
  EXPECT_FALSE(adapter.Exchange(0.000, ACommand(), 0.0));
  const std::uint16_t to = robot.Receive(kUntilItComes).value().from_port;
  double now_s = 0.0;
  const auto hears = [&](const LoopbackSocket& from, const std::vector<double>& row) {
    from.Send(to, row);
    return adapter.Exchange(now_s += 0.001, ACommand(), kUntilItComes);
  };
  EXPECT_EQ(hears(robot, RowOf(StateOf(0, 0.1))).value().number, 0U);
  EXPECT_FALSE(hears(robot, RowOf(StateOf(0, 0.1)))) << "twice";
  const JointState third = hears(robot, RowOf(StateOf(2, 0.3))).value();
  EXPECT_EQ(third.number, 2U);
  EXPECT_EQ(third.q[1], 0.3);
  EXPECT_FALSE(hears(robot, RowOf(StateOf(1, 0.2)))) << "late";
  EXPECT_FALSE(hears(robot, RowOf(StateOf(1000, 0.2)))) << "to what was never sent";
  EXPECT_FALSE(hears(robot, {1.0, 2.0})) << "not a state";
  EXPECT_FALSE(hears(stranger, RowOf(StateOf(3, 0.4))));
  EXPECT_EQ(hears(robot, RowOf(StateOf(3, 0.4))).value().number, 3U);
  EXPECT_EQ(adapter.sent(), 9U);
  EXPECT_EQ(adapter.lost(), 6U);
}

TEST(HardwareAdapterExample, WithoutStatesItStopsForGoodAndDamps) {
  const LoopbackSocket robot;
  HardwareAdapter adapter(robot.port(), 0.020);
  std::uint16_t to = 0;
  const auto given = [&](double now_s) {
    adapter.Exchange(now_s, ACommand(), 0.0);
    const ReceivedRow received = robot.Receive(kUntilItComes).value();
    to = received.from_port;
    return PartsOf(received.row, 2, 5).value();
  };
  given(5.0);
  EXPECT_EQ(given(5.019).parts[3], ACommand().stiffness);
  EXPECT_FALSE(adapter.stopped());
  robot.Send(to, RowOf(StateOf(1, 0.3)));
  EXPECT_TRUE(adapter.Exchange(5.019, ACommand(), kUntilItComes));
  robot.Receive(kUntilItComes);
  EXPECT_EQ(given(5.038).parts[2], ACommand().tau_ff) << "19 ms since it was heard";
  const NumberedParts damping = given(5.040);
  EXPECT_TRUE(adapter.stopped());
  EXPECT_EQ(damping.number, 4U);
  for (const std::size_t zero : {1U, 2U, 3U}) EXPECT_EQ(damping.parts[zero].norm(), 0.0) << zero;
  EXPECT_EQ(damping.parts[4], ACommand().damping);
  robot.Send(to, RowOf(StateOf(4, 0.3)));
  EXPECT_TRUE(adapter.Exchange(5.041, ACommand(), kUntilItComes));
  robot.Receive(kUntilItComes);
  EXPECT_EQ(given(5.042).parts[3].norm(), 0.0) << "a robot that is heard again does not start by itself";
}

/// Sends a command to a stand-in and lets it serve that.
void Give(StandInRobot& robot, const LoopbackSocket& from, std::uint64_t number, const JointCommand& c) {
  from.Send(robot.port(), RowOf({number, {c.q, c.v, c.tau_ff, c.stiffness, c.damping}}));
  robot.Serve(kUntilItComes);
}

TEST(HardwareAdapterExample, TheStandInMovesByItsLawAndItsAnswersSayWhere) {
  const LoopbackSocket controller;
  StandInRobot robot(VectorX::Zero(2), {.step_s = 0.002, .inertia_kg_m2 = 0.1, .load_error = 0.1});
  Give(robot, controller, 0, ACommand());
  // v = h (kp q_d + kd v_d - 0.1 tau) / (I + h kd + h^2 kp)
  const double v = 0.002 * (30.0 + 1.0 - 0.8) / (0.1 + 0.02 + 0.0004);
  EXPECT_NEAR(robot.v()[0], v, 1e-12);
  const NumberedParts state = PartsOf(controller.Receive(kUntilItComes).value().row, 2, 2).value();
  EXPECT_EQ(state.number, 0U);
  EXPECT_NEAR(state.parts[0][1], 0.002 * v, 1e-12);
  EXPECT_EQ(state.parts[1], robot.v());
  Give(robot, controller, 0, ACommand());
  EXPECT_NEAR(robot.v()[0], v, 1e-12) << "an old command is none";

  JointCommand damping = ACommand();
  damping.v.setZero(), damping.tau_ff.setZero(), damping.stiffness.setZero();
  for (std::uint64_t k = 1; k <= 50; ++k) Give(robot, controller, k, damping);
  EXPECT_NEAR(robot.v()[0], v * std::pow(0.1 / 0.12, 50), 1e-12) << "it comes to rest";
}

/// Two joints that are held for 1 s against 8 N m.
MotionPlan Holding() {
  MotionPlan plan;
  plan.whole_body.step_s = 0.5;
  for (int k = 0; k < 3; ++k) {
    plan.whole_body.q.push_back((VectorX(9) << 0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0, 0.4, -0.2).finished());
    plan.whole_body.v.push_back(VectorX::Zero(8));
    plan.whole_body.a.push_back(VectorX::Zero(8));
    plan.whole_body.tau.push_back(VectorX::Constant(2, 8.0));
    plan.whole_body.wrenches.emplace_back();
  }
  return plan;
}

/// Streams Holding() to a stand-in on another thread, in steps of 2 ms that take as long as they take.
StreamReport Streamed(const StandInOptions& options, double patience_s) {
  StandInRobot robot(Holding().whole_body.q.front().tail(2), options);
  const std::jthread runs([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) robot.Serve(0.01);
  });
  HardwareAdapter adapter(robot.port(), 0.0205);
  StreamOptions stream;
  stream.patience_s = patience_s;
  stream.wait_until = [](double until_s) { return until_s; };
  return StreamPlan(Holding(), {ACommand().stiffness, ACommand().damping}, adapter, stream);
}

TEST(HardwareAdapterExample, JointsSagByWhatTheFeedForwardLacks) {
  const StreamReport report = Streamed({.load_error = 0.1}, kUntilItComes);
  EXPECT_EQ(report.sent, 501U);
  EXPECT_EQ(report.lost, 0U);
  EXPECT_FALSE(report.stopped);
  EXPECT_NEAR(report.rate_hz, 500.0, 1e-6);
  EXPECT_NEAR(report.largest_error, 0.1 * 8.0 / 100.0, 2e-6);  // load_error tau / kp
  EXPECT_LT(Streamed({.load_error = 0.0}, kUntilItComes).largest_error, 1e-12);
}

// The first of the periods that end later than 20.5 ms after the last state is the eleventh; ten dampings are sent.
TEST(HardwareAdapterExample, ARobotThatFallsSilentIsDampedTenTimes) {
  const StreamReport never_heard = Streamed({.loses_every = 1}, 0.0);
  EXPECT_TRUE(never_heard.stopped);
  EXPECT_EQ(never_heard.sent, 21U);
  EXPECT_EQ(never_heard.lost, 21U);
  const StreamReport heard_once = Streamed({.silent_after = 1}, 0.0);  // within the first eleven, if in time
  EXPECT_TRUE(heard_once.stopped);
  EXPECT_GE(heard_once.sent, 21U);
  EXPECT_LE(heard_once.sent, 31U);
  EXPECT_LE(heard_once.sent - heard_once.lost, 1U);
}

TEST(HardwareAdapterExample, StreamsAWalk) {
  StreamOptions stream;
  stream.patience_s = kUntilItComes;
  stream.wait_until = [](double until_s) { return until_s; };
  const StreamReport report = StreamToStandIn("a1", {}, stream);
  EXPECT_FALSE(report.stopped);
  EXPECT_EQ(report.lost, 0U);
  EXPECT_GT(report.sent, 500U) << "over a second";
  EXPECT_GT(report.largest_error, 1e-4) << "loads are not as planned";
  EXPECT_LT(report.largest_error, 0.01);
  EXPECT_THROW(StreamToStandIn("a2", {}, stream), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::examples
