// SPDX-License-Identifier: BSD-3-Clause
// The demonstrated walks of the two main robots, in full length: with robot.yaml and from the URDF alone.
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

struct Walk {
  std::string name, robot, gait, controller;
  WalkCommand command;
};

WalkCommand Forward(double speed_m_s, double distance_m) {
  WalkCommand command;
  command.speed_m_s = speed_m_s;
  command.distance_m = distance_m;
  return command;
}

WalkCommand Sideways(double speed_m_s, double distance_m) {
  WalkCommand command;
  command.speed_m_s = 0.0;
  command.lateral_speed_m_s = speed_m_s;
  command.distance_m = distance_m;
  return command;
}

WalkCommand Turn(double rate_rad_s) {
  WalkCommand command;
  command.speed_m_s = 0.0;
  command.yaw_rate_rad_s = rate_rad_s;
  command.extent = Extent::kGoal;
  command.goal_yaw_rad = std::numbers::pi / 2.0;
  return command;
}

WalkCommand Goal(double x_m, double y_m, double yaw_rad) {
  WalkCommand command;
  command.extent = Extent::kGoal;
  command.goal_x_m = x_m;
  command.goal_y_m = y_m;
  command.goal_yaw_rad = yaw_rad;
  return command;
}

WalkCommand Steps(int steps, double length_m) {
  WalkCommand command;
  command.extent = Extent::kSteps;
  command.steps = steps;
  command.step_length_m = length_m;
  return command;
}

/// A robot with its robot.yaml, or from its URDF alone; loaded once.
const RobotModel& Robot(const std::string& name, bool yaml) {
  static std::map<std::pair<std::string, bool>, RobotModel> robots;
  const auto key = std::make_pair(name, yaml);
  if (!robots.contains(key)) {
    const RobotModel named = *LoadNamedRobot(name);
    robots.emplace(key, yaml ? named : *LoadRobotFromText(named.urdf_text, "", name));
  }
  return robots.at(key);
}

PlannedWalk Planned(const RobotModel& model, const Walk& walk) {
  WalkRequest request;
  request.gait = walk.gait;
  request.command = walk.command;
  Result<PlannedWalk> planned = PlanWalk(model, request);
  EXPECT_TRUE(planned.ok()) << planned.failure().message;
  return *planned;
}

MotionPlan PlanOf(const RobotModel& model, const Walk& walk) {
  const PlannedWalk planned = Planned(model, walk);
  EXPECT_TRUE(planned.audit.pass()) << AuditText(planned.audit);
  return planned.motion.plan;
}

double Value(const StabilityReport& report, const std::string& key) {
  for (const Metric& metric : report.metrics) {
    if (metric.key == key) return metric.value.value_or(std::nan(""));
  }
  ADD_FAILURE() << "no metric " << key;
  return std::nan("");
}

double PlannedValue(const StabilityReport& report, const std::string& key) {
  for (const Metric& metric : report.metrics) {
    if (metric.key == key) return metric.planned.value_or(std::nan(""));
  }
  return std::nan("");
}

StabilityReport Played(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request) {
  const Result<PlayedWalk> played = PlayWalk(model, plan, request);
  EXPECT_TRUE(played.ok());
  return played->report;
}

class Demonstration : public testing::TestWithParam<bool> {
 protected:
  StabilityReport Show(const Walk& walk) {
    const RobotModel& model = Robot(walk.robot, GetParam());
    const MotionPlan plan = PlanOf(model, walk);
    PlayRequest request;
    request.controller = walk.controller;
    StabilityReport report = Played(model, plan, request);
    EXPECT_TRUE(report.pass) << walk.name << ": " << report.reason;
    EXPECT_LE(Value(report, "torque_use_max"), 1.0);
    RecordProperty(walk.name + "_score", fmt::format("{:.1f}", report.score));
    return report;
  }

  /// Pushes from eight directions, 0.1 s each, at kTimes times of a cycle, in sets of four times a quarter cycle apart.
  /// @return the smallest number of passes among the 32 plays of a set, over all sets.
  int PushAround(const Walk& walk, double force_n, double from_s, double cycle_s) {
    constexpr int kTimes = 8, kQuarters = 4;
    const RobotModel& model = Robot(walk.robot, GetParam());
    const MotionPlan plan = PlanOf(model, walk);
    std::array<int, kTimes / kQuarters> passed{};
    for (int time = 0; time < kTimes; ++time) {
      for (int direction = 0; direction < 8; ++direction) {
        const double angle = direction * std::numbers::pi / 4.0;
        PlayRequest request;
        request.play.push_force_W = force_n * Vector3(std::cos(angle), std::sin(angle), 0.0);
        request.play.push_at_s = from_s + time * cycle_s / kTimes;
        request.play.push_for_s = 0.1;
        const StabilityReport report = Played(model, plan, request);
        passed.at(static_cast<std::size_t>(time % (kTimes / kQuarters))) += report.pass ? 1 : 0;
        if (!report.pass) fmt::print("time {} direction {} deg: {}\n", time, 45 * direction, report.reason);
      }
    }
    fmt::print("{}: {} of 32 pass\n", walk.name, fmt::join(passed, " and "));
    RecordProperty(walk.name + "_pushes_passed", fmt::format("{}", fmt::join(passed, " ")));
    return *std::min_element(passed.begin(), passed.end());
  }
};

TEST_P(Demonstration, QuadrupedTrots) {
  for (const auto& [speed, distance] : {std::pair{0.3, 3.0}, std::pair{0.8, 5.0}}) {
    const StabilityReport report = Show({"a1_trot", "a1", "trot", "stabilised", Forward(speed, distance)});
    EXPECT_LE(Value(report, "goal_error_m"), 0.02 * distance);
    EXPECT_LE(Value(report, "zmp_error_mean_m"), 0.010);
  }
}

TEST_P(Demonstration, QuadrupedCrawls) {
  const StabilityReport report = Show({"a1_crawl", "a1", "walk", "stabilised", Forward(0.1, 1.0)});
  EXPECT_NEAR(Value(report, "zmp_margin_p05_m"), PlannedValue(report, "zmp_margin_p05_m"), 0.005);
}

TEST_P(Demonstration, QuadrupedGoesSidewaysAndTurns) {
  EXPECT_LE(Value(Show({"a1_sideways", "a1", "trot", "stabilised", Sideways(0.15, 1.0)}), "heading_error_rad"), 0.05);
  EXPECT_LE(Value(Show({"a1_turn", "a1", "trot", "stabilised", Turn(0.5)}), "heading_error_rad"), 0.05);
}

TEST_P(Demonstration, BipedWalksByReplayAlone) {
  for (const auto& [steps, length] : {std::pair{10, 0.04}, std::pair{20, 0.06}}) {
    const StabilityReport report = Show({"nao_walk", "nao", "", "joint-pd", Steps(steps, length)});
    EXPECT_GE(Value(report, "zmp_margin_p05_m"), 0.020);
    EXPECT_LE(Value(report, "zmp_error_rms_m"), 0.006);
    EXPECT_LE(Value(report, "goal_error_m"), 0.010);
  }
  Show({"nao_sideways", "nao", "", "joint-pd", Goal(0.0, 0.2, 0.0)});
  Show({"nao_turn", "nao", "", "joint-pd", Goal(0.0, 0.0, std::numbers::pi / 2.0)});
}

TEST_P(Demonstration, QuadrupedIsPushed) {
  EXPECT_GE(PushAround({"a1_trot", "a1", "trot", "stabilised", Forward(0.3, 3.0)}, 80.0, 5.0, 0.5), 30);
}

TEST_P(Demonstration, BipedIsPushed) {
  EXPECT_GE(PushAround({"nao_walk", "nao", "", "stabilised", Steps(20, 0.04)}, 10.0, 3.5, 0.7), 30);
}

TEST_P(Demonstration, UnannouncedGround) {
  const Walk trot{"a1_trot", "a1", "trot", "stabilised", Forward(0.3, 3.0)};
  const Walk walk{"nao_walk", "nao", "", "stabilised", Steps(10, 0.04)};
  PlayRequest bumps;
  bumps.play.world.ground_bumps_m = 0.01;
  const RobotModel &a1 = Robot("a1", GetParam()), &nao = Robot("nao", GetParam());
  for (const int seed : {0, 1, 2, 3}) {
    bumps.play.world.seed = seed;
    const StabilityReport report = Played(a1, PlanOf(a1, trot), bumps);
    EXPECT_TRUE(report.pass) << "seed " << seed << ": " << report.reason;
  }
  for (const double slope_deg : {-2.0, 2.0}) {
    PlayRequest slope;
    slope.play.world.ground_slope_deg = slope_deg;
    const StabilityReport report = Played(nao, PlanOf(nao, walk), slope);
    EXPECT_TRUE(report.pass) << slope_deg << " deg: " << report.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Demonstration, testing::Bool(),
                         [](const auto& with) { return with.param ? "WithYaml" : "FromUrdfAlone"; });

/// The distance must not depend on the radius of a foot: the plan takes rolling into account.
TEST(FootRadius, DistanceHolds) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  const std::string was = "<sphere radius=\"0.02\"/>";
  ASSERT_NE(a1.urdf_text.find(was), std::string::npos);
  for (const double radius_m : {0.005, 0.02, 0.04}) {
    std::string urdf = a1.urdf_text;
    for (std::size_t at = urdf.find(was); at != std::string::npos; at = urdf.find(was, at + 1))
      urdf.replace(at, was.size(), fmt::format("<sphere radius=\"{}\"/>", radius_m));
    const RobotModel model = *LoadRobotFromText(urdf, a1.yaml_text, "a1");
    EXPECT_NEAR(model.feet.front().radius, radius_m, 1e-12);
    const PlannedWalk planned = Planned(model, {"a1_trot", "a1", "trot", "stabilised", Forward(0.3, 3.0)});
    EXPECT_TRUE(planned.audit.pass()) << AuditText(planned.audit);
    for (const std::string controller : {"stabilised", "joint-pd"}) {
      PlayRequest request;
      request.controller = controller;
      const StabilityReport report = Played(model, planned.motion.plan, request);
      EXPECT_TRUE(report.pass) << radius_m << " " << controller << ": " << report.reason;
      EXPECT_NEAR(Value(report, "distance_m"), 3.0, 0.06);
    }
  }
}

}  // namespace
}  // namespace gaitwright
