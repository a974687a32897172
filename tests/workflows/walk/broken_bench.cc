// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/broken_bench.h"

#include <algorithm>
#include <bit>
#include <map>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "tests/workflows/walk/restaged_plan.h"

namespace gaitwright {
namespace {

double StandingHeight(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return CentreOfMass(model, scratch).z();
}

Bench Make(const std::string& robot) {
  const RobotModel model = *LoadNamedRobot(robot);
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 2 * static_cast<int>(model.feet.size());
  request.command.step_length_m = 0.12 * model.leg_length_m();
  if (model.feet.front().has_sole()) request.gait_options.cycle_s = 1.0;  // phases long enough to fall in
  request.motion.pipeline.com_height_m = 0.95 * StandingHeight(model);
  return {model, PlanWalk(model, request)->motion.plan};
}

}  // namespace

const Bench& BenchOf(const std::string& robot) {
  static std::map<std::string, Bench> benches;
  const auto found = benches.find(robot);
  return found != benches.end() ? found->second : benches.emplace(robot, Make(robot)).first->second;
}

std::vector<Law> BrokenLaws(const RobotModel& model, const MotionPlan& plan) {
  std::vector<Law> laws;
  const AuditReport report = Audit(model, plan, {}).value();
  for (const Violation& violation : report.violations) {
    if (laws.empty() || laws.back() != violation.law) laws.push_back(violation.law);
  }
  return laws;
}

PlayedWalk Played(const RobotModel& model, const MotionPlan& plan, const std::string& controller) {
  PlayRequest request;
  request.controller = controller;
  return PlayWalk(model, plan, request).value();
}

bool Says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int MiddleSwingPhase(const MotionPlan& plan) {
  const auto& phases = plan.schedule.phases;
  int fewest = 64;
  for (const ContactPhase& phase : phases) fewest = std::min(fewest, std::popcount(phase.stance));
  std::size_t i = phases.size() / 2;
  while (std::popcount(phases[i].stance) != fewest) ++i;
  return static_cast<int>(i);
}

std::size_t MiddleFoothold(const MotionPlan& plan) {
  const auto& footholds = plan.footsteps.footholds;
  const auto at = std::find_if(footholds.begin(), footholds.end(),
                               [&](const Foothold& f) { return f.touchdown_s > 0.4 * plan.duration_s(); });
  return static_cast<std::size_t>(at - footholds.begin());
}

MotionPlan WithSwingsThroughTheGround(const Bench& bench, int foot) {
  MotionPlan plan = bench.plan;
  for (SwingTrajectory& swing : plan.swings) {
    if (swing.foot != foot) continue;
    swing.lift_m *= -0.25;
    swing.detour_W.clear();
  }
  return WithMotionAnew(bench.model, plan);
}

}  // namespace gaitwright
