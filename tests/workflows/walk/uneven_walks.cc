// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/uneven_walks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

const Metric& Find(const StabilityReport& report, const std::string& key) {
  for (const Metric& metric : report.metrics) {
    if (metric.key == key) return metric;
  }
  throw InvalidArgument("no metric " + key);
}

}  // namespace

void PrintTo(const UnevenWalk& walk, std::ostream* out) {
  *out << walk.robot << ' ' << walk.gait << ' ' << walk.terrain;
}

void ExpectToWalk(const UnevenWalk& walk) {
  const RobotModel model = LoadNamedRobot(walk.robot).value();
  WalkRequest request;
  request.terrain = walk.terrain;
  request.gait = walk.gait;
  if (walk.distance_m > 0.0) {
    request.command.distance_m = walk.distance_m;
  } else {
    request.command.extent = WalkCommand::Extent::kGoal;
    request.command.goal_x_m = walk.goal_x_m;
    request.command.goal_y_m = walk.goal_y_m;
  }
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  ASSERT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, {});
  ASSERT_TRUE(played.ok());
  const StabilityReport& report = played->report;
  EXPECT_TRUE(report.pass) << report.reason;
  EXPECT_EQ(Find(report, "scuffs").value.value_or(1.0), 0.0);
  EXPECT_LE(Find(report, "penetration_max_m").value.value_or(1.0), 1e-3);
  const Metric& clearance = Find(report, "clearance_min_m");
  const double most_m = model.leg_length_m() < 0.3 ? 2e-3 : 5e-3;
  EXPECT_NEAR(clearance.value.value_or(1.0), clearance.planned.value_or(-1.0), most_m);
  testing::Test::RecordProperty("score", std::to_string(report.score));
}

}  // namespace gaitwright
