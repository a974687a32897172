// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the audit share: robots, good plans of them, and looks into both.
#pragma once

#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {

struct GoodPlan {
  RobotModel model;
  MotionPlan plan;
};

/// A short walk straight ahead by distance, in the robot's own gait. Made once for each robot.
const GoodPlan& GoodPlanOf(const std::string& robot);

/// The plan of a command. @throws std::logic_error when there is none.
MotionPlan PlanOf(const RobotModel& model, const std::string& gait, const WalkCommand& command,
                  const GaitOptions& options = {});

/// The violations at the audit's own options.
std::vector<Violation> ViolationsOf(const RobotModel& model, const MotionPlan& plan);

/// The laws of violations, each once, in their order.
std::vector<Law> LawsOf(const std::vector<Violation>& violations);

/// The violation of a place. @throws InvalidArgument that lists what there is.
const Violation& At(const std::vector<Violation>& violations, const std::string& where);

/// Row of the grid in the middle of the first swing of foot 0.
std::size_t MidSwingRow(const MotionPlan& plan);
double TimeOf(const MotionPlan& plan, std::size_t row);

/// The plan's state at a time, with the kinematics of it.
struct Moment {
  Moment(const RobotModel& model, const MotionPlan& plan, double time_s);

  WholeBodySample sample;
  DynamicsScratch scratch;
};

/// Times of the audit's samples [s].
std::vector<double> SampleTimes(const MotionPlan& plan);

}  // namespace gaitwright
