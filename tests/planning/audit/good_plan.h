// SPDX-License-Identifier: BSD-3-Clause
// Shared by the tests of the audit: robots, good plans of them, and functions that inspect both.
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

/// A short walk straight forward by distance, in the robot's default gait. Made once for each robot.
const GoodPlan& GoodPlanOf(const std::string& robot);

/// The plan of a command. @throws std::logic_error if there is no plan.
MotionPlan PlanOf(const RobotModel& model, const std::string& gait, const WalkCommand& command,
                  const GaitOptions& options = {});

/// The violations with the default options of the audit.
std::vector<Violation> ViolationsOf(const RobotModel& model, const MotionPlan& plan);

/// The checks of violations, without duplicates, in their order.
std::vector<Law> LawsOf(const std::vector<Violation>& violations);

/// The violation at a place. @throws InvalidArgument that lists all violations.
const Violation& At(const std::vector<Violation>& violations, const std::string& where);

/// Row of the grid in the middle of the first swing of foot 0.
std::size_t MidSwingRow(const MotionPlan& plan);
double TimeOf(const MotionPlan& plan, std::size_t row);

/// The plan's state at a time, with its kinematics.
struct Moment {
  Moment(const RobotModel& model, const MotionPlan& plan, double time_s);

  WholeBodySample sample;
  DynamicsScratch scratch;
};

/// Times of the audit's samples [s].
std::vector<double> SampleTimes(const MotionPlan& plan);

}  // namespace gaitwright
