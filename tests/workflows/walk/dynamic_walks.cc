// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/dynamic_walks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"

namespace gaitwright {

void PrintTo(const DynamicWalk& walk, std::ostream* out) { *out << walk.gait << ' ' << walk.speed_m_s << " m/s"; }

WalkRequest OneLeap(const std::string& terrain, double length_m) {
  WalkRequest request;
  request.gait = "jump";
  request.terrain = terrain;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = length_m / request.command.steps;
  return request;
}

void ExpectToFly(const WalkRequest& request) { ExpectToFly(LoadNamedRobot("a1").value(), request); }

void ExpectToFly(const RobotModel& model, const WalkRequest& request) {
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const MotionPlan& plan = planned->motion.plan;
  EXPECT_TRUE(std::any_of(plan.schedule.phases.begin(), plan.schedule.phases.end(),
                          [](const ContactPhase& phase) { return phase.stance == 0; }));
  ASSERT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, plan, {});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  testing::Test::RecordProperty("score", std::to_string(played->report.score));
}

void ExpectToFly(const DynamicWalk& walk) {
  WalkRequest request;
  request.gait = walk.gait;
  request.gait_options.duty_factor = walk.duty_factor;
  request.command.speed_m_s = walk.speed_m_s;
  request.command.distance_m = walk.distance_m;
  ExpectToFly(request);
}

}  // namespace gaitwright
