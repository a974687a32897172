// SPDX-License-Identifier: BSD-3-Clause
#include "tests/planning/audit/good_plan.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

GoodPlan Make(const std::string& robot) {
  const RobotModel model = LoadNamedRobot(robot).value();
  WalkCommand command;
  command.distance_m = 0.6 * model.leg_length_m();
  // The passes alone, without the whole body optimised, are sound only for slow walks on soles.
  if (model.feet.front().has_sole()) command.speed_m_s = 0.25 * model.nominal_speed_m_s;
  return {model, PlanOf(model, "", command)};
}

}  // namespace

const GoodPlan& GoodPlanOf(const std::string& robot) {
  static std::map<std::string, GoodPlan> plans;
  const auto found = plans.find(robot);
  return found != plans.end() ? found->second : plans.emplace(robot, Make(robot)).first->second;
}

MotionPlan PlanOf(const RobotModel& model, const std::string& gait, const WalkCommand& command,
                  const GaitOptions& options) {
  const Gait fitted = FindGait(model, gait, CommandedSpeed(model, command), options).value();
  return PlanMotion(model, FlatTerrain(), fitted, command, {}).value().plan;
}

std::vector<Violation> ViolationsOf(const RobotModel& model, const MotionPlan& plan) {
  return Audit(model, plan, {}).value().violations;
}

std::vector<Law> LawsOf(const std::vector<Violation>& violations) {
  std::vector<Law> laws;
  for (const Violation& violation : violations) {
    if (laws.empty() || laws.back() != violation.law) laws.push_back(violation.law);
  }
  return laws;
}

const Violation& At(const std::vector<Violation>& violations, const std::string& where) {
  std::string all;
  for (const Violation& violation : violations) {
    if (violation.where == where) return violation;
    all += "\n  " + LawName(violation.law) + ": " + violation.where;
  }
  throw InvalidArgument("nothing is found at '" + where + "', only at" + all);
}

std::size_t MidSwingRow(const MotionPlan& plan) {
  const auto swing = std::find_if(plan.swings.begin(), plan.swings.end(), [](const auto& s) { return s.foot == 0; });
  const double time_s = 0.5 * (swing->start_s + swing->end_s) - plan.whole_body.start_s;
  return static_cast<std::size_t>(std::lround(time_s / plan.whole_body.step_s));
}

double TimeOf(const MotionPlan& plan, std::size_t row) {
  return plan.whole_body.start_s + static_cast<double>(row) * plan.whole_body.step_s;
}

Moment::Moment(const RobotModel& model, const MotionPlan& plan, double time_s) : scratch(model) {
  SampleWholeBody(plan.whole_body, time_s, sample);
  ForwardKinematics(model, sample.q, scratch);
}

std::vector<double> SampleTimes(const MotionPlan& plan) {
  std::vector<double> times;
  const int count = 1 + static_cast<int>(std::floor(plan.duration_s() / 1e-3 + 1e-6));
  for (int k = 0; k < count; ++k) times.push_back(plan.whole_body.start_s + k * 1e-3);
  return times;
}

}  // namespace gaitwright
