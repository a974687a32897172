// SPDX-License-Identifier: BSD-3-Clause
// Assignment 7: a footstep planner for stairs. See ../README.md. SI units.
//   stairs plan.json    writes the plan over the footsteps, if one exists
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "planning/paths/standing_feet.h"
#include "planning/plan/plan_json.h"
#include "planning/plan/terrain_scale.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/exchange/placed_steps.h"
#include "workflows/walk/walk.h"
#include "workflows/walk/walk_extent.h"

namespace {

using namespace gaitwright;

const std::string kStairs = "stairs:start_m=0.41,rise_m=0.05,tread_m=0.31,count=3,landing_m=2";
constexpr double kGoal = 1.2;    // [m], distance of the goal
constexpr double kSpeed = 0.04;  // [m/s], commanded speed; the walk may take a quarter longer
constexpr double kStride = 0.1;  // [m], maximum advance of the body while each foot makes one step
constexpr std::array<const char*, 4> kOrder = {"RR_foot", "FR_foot", "RL_foot", "FL_foot"};  // rear, front of each side

int FootOf(const RobotModel& model, const std::string& name) {
  for (std::size_t i = 0; i < model.feet.size(); ++i) {
    if (model.feet[i].name == name) return static_cast<int>(i);
  }
  throw InvalidArgument(fmt::format("robot '{}' has no foot '{}'", model.name, name));
}

/// The steps in order, until the body is at the goal. GroundAt(terrain, {x, y}).height_m is the height of the ground.
std::vector<PlacedStep> PlanSteps(const RobotModel& model, const Terrain& /*terrain*/, double goal_m) {
  const std::vector<Pose> standing = StandingFeet(model);
  const int rounds = static_cast<int>(std::ceil(goal_m / kStride));
  std::vector<PlacedStep> steps;
  for (int i = 1; i <= rounds; ++i) {
    for (const char* name : kOrder) {
      const int foot = FootOf(model, name);
      const Vector3 p_WF = standing[static_cast<std::size_t>(foot)].translation();
      steps.push_back({foot, {p_WF.x() + goal_m * i / rounds, p_WF.y(), 0.0}});  // even on an edge
    }
  }
  return steps;
}

/// Plans the rest of the motion over the steps, and sets the command of the plan.
Result<MotionPlan> Planned(const RobotModel& model, const Terrain& terrain) {
  const std::vector<PlacedStep> steps = PlanSteps(model, terrain, kGoal);
  Result<MotionPlan> plan = PlanOverSteps(model, terrain, steps, {.swing_s = 0.4, .pause_s = 0.15});
  if (!plan) return plan.failure();
  WalkCommand& command = plan->parts.front().command;
  command = {};
  command.speed_m_s = kSpeed;
  WalkExtent extent;
  extent.goal = PlanarPose{kGoal, 0.0, 0.0};
  SetExtent(model, extent, command);
  return plan;
}

}  // namespace

int main(int argc, char** argv) {
  const Result<RobotModel> model = ChooseRobot("a1", "");
  if (!model) return 1;
  const Result<Terrain> terrain = LoadTerrain(kStairs, ScaleOf(*model));
  if (!terrain) return 1;
  const Result<MotionPlan> plan = Planned(*model, *terrain);
  if (!plan) {
    fmt::print("no plan: {}\n", plan.failure().message);
    return 0;
  }
  const PlayRequest as_usual;
  const Result<PlayedWalk> played = PlayWalk(*model, *plan, as_usual);
  fmt::print("{}\n", played ? played->report.reason : played.failure().message);
  const Result<std::string> written = SavePlan(*plan, argc > 1 ? argv[1] : "plan.json");
  if (!written) fmt::print(stderr, "stairs: {}\n", written.failure().message);
  return written ? 0 : 1;
}
