// SPDX-License-Identifier: BSD-3-Clause
// Time is given by the tests: nothing here depends on how fast the machine is.
#include "examples/hardware_adapter.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "examples/stream_plan.h"
#include "tests/built_paths.h"

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

/// number, then the parts one after the other.
VectorX RowOf(double number, const std::vector<VectorX>& parts) {
  VectorX row(1 + static_cast<Eigen::Index>(parts.size()) * parts.front().size());
  row[0] = number;
  for (std::size_t k = 0; k < parts.size(); ++k) row.segment(1 + static_cast<Eigen::Index>(k) * 2, 2) = parts[k];
  return row;
}
VectorX StateOf(double number, double q) { return RowOf(number, {VectorX::Constant(2, q), VectorX::Zero(2)}); }
VectorX CommandOf(double number, const JointCommand& c) {
  return RowOf(number, {c.q, c.v, c.tau_ff, c.stiffness, c.damping});
}

/// A socket at which the test plays one of the two sides.
class Side {
 public:
  Side() : fd_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in own = At(0);
    socklen_t size = sizeof own;
    EXPECT_EQ(bind(fd_, reinterpret_cast<sockaddr*>(&own), size), 0);
    EXPECT_EQ(getsockname(fd_, reinterpret_cast<sockaddr*>(&own), &size), 0);
    port_ = ntohs(own.sin_port);
  }
  ~Side() { close(fd_); }
  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;

  std::uint16_t port() const { return port_; }
  /// Where the last row came from.
  std::uint16_t heard_from() const { return heard_from_; }

  void Send(std::uint16_t to_port, const VectorX& row, std::size_t cut_bytes = 0) const {
    const sockaddr_in to = At(to_port);
    const std::size_t bytes = static_cast<std::size_t>(row.size()) * sizeof(double) - cut_bytes;
    EXPECT_GE(sendto(fd_, row.data(), bytes, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  /// Waits until one comes.
  VectorX Receive() {
    VectorX row(64);
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const auto bytes = recvfrom(fd_, row.data(), 64 * sizeof(double), 0, reinterpret_cast<sockaddr*>(&from), &size);
    heard_from_ = ntohs(from.sin_port);
    row.conservativeResize(bytes / static_cast<long>(sizeof(double)));
    return row;
  }

 private:
  static sockaddr_in At(std::uint16_t port) { return {AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}}; }

  int fd_;
  std::uint16_t port_ = 0, heard_from_ = 0;
};

TEST(HardwareAdapterExample, NewerStatesCountOnceAndOthersNot) {
  Side robot;
  const Side stranger;
  HardwareAdapter adapter(robot.port());
  EXPECT_FALSE(adapter.Exchange(0.000, ACommand(), 0.0));
  EXPECT_EQ(robot.Receive(), CommandOf(0.0, ACommand()));
  const std::uint16_t to = robot.heard_from();
  double now_s = 0.0;
  const auto hears = [&](const Side& from, const VectorX& row, std::size_t cut_bytes = 0) {
    from.Send(to, row, cut_bytes);
    return adapter.Exchange(now_s += 0.001, ACommand(), &from == &robot ? kUntilItComes : 0.01);
  };
  EXPECT_EQ(hears(robot, StateOf(0, 0.1)).value().number, 0U);
  EXPECT_FALSE(hears(robot, StateOf(0, 0.1))) << "twice";
  const JointState third = hears(robot, StateOf(2, 0.3)).value();
  EXPECT_EQ(third.number, 2U);
  EXPECT_EQ(third.q[1], 0.3);
  EXPECT_FALSE(hears(robot, StateOf(1, 0.2))) << "late";
  EXPECT_FALSE(hears(robot, StateOf(1000, 0.2))) << "to what was never sent";
  EXPECT_FALSE(hears(robot, StateOf(-1, 0.2)));
  EXPECT_FALSE(hears(robot, StateOf(3, std::nan(""))));
  EXPECT_FALSE(hears(robot, StateOf(3, std::numeric_limits<double>::infinity())));
  EXPECT_FALSE(hears(robot, Vector2(3.0, 2.0))) << "not a state";
  EXPECT_FALSE(hears(robot, RowOf(3.0, {Vector2::Zero(), Vector2::Zero(), Vector2::Zero()}))) << "too long";
  EXPECT_FALSE(hears(robot, StateOf(3, 0.4), 3)) << "cut short";
  EXPECT_FALSE(hears(robot, VectorX())) << "empty";
  EXPECT_FALSE(hears(stranger, StateOf(3, 0.4)));
  EXPECT_EQ(hears(robot, StateOf(3, 0.4)).value().number, 3U);
  EXPECT_EQ(adapter.sent(), 15U);
  EXPECT_EQ(adapter.lost(), 12U);
}

TEST(HardwareAdapterExample, WithoutStatesItStopsForGoodAndDamps) {
  Side robot;
  HardwareAdapter adapter(robot.port(), 0.020);
  const auto given = [&](double now_s) {
    adapter.Exchange(now_s, ACommand(), 0.0);
    return robot.Receive();
  };
  const auto answered = [&](double now_s, double number) {
    robot.Send(robot.heard_from(), StateOf(number, 0.3));
    EXPECT_TRUE(adapter.Exchange(now_s, ACommand(), kUntilItComes));
    return robot.Receive();
  };
  given(5.0);
  EXPECT_EQ(given(5.019), CommandOf(1.0, ACommand()));
  EXPECT_FALSE(adapter.stopped());
  answered(5.019, 1);
  EXPECT_EQ(given(5.038), CommandOf(3.0, ACommand())) << "19 ms since it was heard";
  const VectorX none = VectorX::Zero(2);
  const auto damping = [&](double number) {
    return RowOf(number, {ACommand().q, none, none, none, ACommand().damping});
  };
  EXPECT_EQ(given(5.040), damping(4.0));
  EXPECT_TRUE(adapter.stopped());
  EXPECT_EQ(answered(5.041, 4), damping(5.0));
  EXPECT_EQ(given(5.042), damping(6.0)) << "a robot that is heard again does not start by itself";
}

/// Sends a command to a stand-in and lets it serve that.
void Give(StandInRobot& robot, const Side& from, double number, const JointCommand& command) {
  from.Send(robot.port(), CommandOf(number, command));
  EXPECT_TRUE(robot.Serve(kUntilItComes));
}

TEST(HardwareAdapterExample, TheStandInMovesByItsLawAndItsAnswersSayWhere) {
  Side controller;
  StandInRobot robot({.step_s = 0.002, .inertia_kg_m2 = 0.1, .load_error = 0.1});
  EXPECT_FALSE(robot.Serve(0.0));
  JointCommand start = ACommand();
  start.q.setZero(), start.v.setZero(), start.tau_ff.setZero();
  Give(robot, controller, 0, start);
  EXPECT_EQ(controller.Receive(), StateOf(0, 0.0)) << "it stands where the first command wants it";
  Give(robot, controller, 1, ACommand());
  // v = h (kp q_d + kd v_d - 0.1 tau) / (I + h kd + h^2 kp)
  const double v = 0.002 * (30.0 + 1.0 - 0.8) / (0.1 + 0.02 + 0.0004);
  EXPECT_NEAR(robot.v()[0], v, 1e-12);
  EXPECT_NEAR(robot.q()[1], 0.002 * v, 1e-12);
  EXPECT_EQ(controller.Receive(), RowOf(1, {robot.q(), robot.v()}));
  Give(robot, controller, 1, ACommand());
  EXPECT_NEAR(robot.v()[0], v, 1e-12) << "an old command is none";
  for (const VectorX& wrong : {VectorX(VectorX::Zero(16)), VectorX(VectorX::Constant(11, std::nan(""))), VectorX(),
                               VectorX(VectorX::Constant(10, 2.0))}) {
    controller.Send(robot.port(), wrong);
    EXPECT_TRUE(robot.Serve(kUntilItComes));
    EXPECT_NEAR(robot.v()[0], v, 1e-12) << wrong.size() << " numbers";
  }

  JointCommand damping = ACommand();
  damping.v.setZero(), damping.tau_ff.setZero(), damping.stiffness.setZero();
  for (int k = 2; k < 52; ++k) Give(robot, controller, k, damping);
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
  StandInRobot robot(options);
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

TEST(HardwareAdapterExample, StreamsAWalkToAProcessOfItsOwn) {
  StreamOptions stream;
  stream.patience_s = kUntilItComes;
  stream.wait_until = [](double until_s) { return until_s; };
  const StandInProcess stand_in(BuildFolder() + "/stand_in_robot", {});
  const StreamReport report = StreamWalk("a1", stand_in.port(), stream);
  EXPECT_FALSE(report.stopped);
  EXPECT_EQ(report.lost, 0U);
  EXPECT_GT(report.sent, 500U) << "over a second";
  EXPECT_GT(report.largest_error, 1e-4) << "loads are not as planned";
  EXPECT_LT(report.largest_error, 0.01);
  EXPECT_THROW(StreamWalk("a2", stand_in.port(), stream), InvalidArgument);
  EXPECT_THROW(StandInProcess("/none/there", {}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::examples
