// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"

namespace gaitwright::examples {

/// Names of the standing strategies that are compared:
///   soft joints    joint PD with 0.15 of the usual gains
///   stiff joints   joint PD with the usual gains: the robot acts as one block on its soles
///   ankle, ankle and DCM, hip   see Strategy
///   whole body     the controller 'stabilised': a wrench at the centre of mass, distributed over both soles
///   steps          the controller 'recovering': 'stabilised' with recovery steps
const std::vector<std::string>& StandingStrategies();

/// A built-in robot, and a plan in which it stands for 3 s.
struct Stander {
  RobotModel model;
  MotionPlan plan;
};
/// @throws InvalidArgument if the robot does not exist or cannot stand.
Stander MakeStander(const std::string& robot);

/// The stander must outlive the controller. @throws InvalidArgument if `strategy` is not one of StandingStrategies.
std::unique_ptr<Controller> MakeStandingStrategy(const Stander& stander, const std::string& strategy);

/// Whether the robot still stands after a push on its base for 0.1 s.
/// @param direction_deg  0 is forward, 90 is left.
bool StandsPush(const Stander& stander, Controller& controller, double force_n, double direction_deg);

/// Largest push after which the robot still stands, by bisection up to `most_n`, to a hundredth of `most_n` [N].
double LargestPush(const Stander& stander, const std::string& strategy, double direction_deg, double most_n);

/// Largest push of one strategy in each direction.
struct PushesTaken {
  std::string strategy;
  std::vector<double> directions_deg, largest_n;
};
/// SVG picture of the largest pushes by direction, seen from above, with the robot's heading up.
std::string PushPicture(const std::vector<PushesTaken>& taken);

}  // namespace gaitwright::examples
