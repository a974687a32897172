// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"

namespace gaitwright::examples {

/// The ways to keep standing that are compared, from joints alone to the whole body:
///   soft joints    joint PD with 0.15 of the usual gains
///   stiff joints   joint PD: the robot is as one block on its soles
///   ankle, ankle and DCM, hip   see Strategy
///   whole body     the controller 'stabilised': the whole wrench at the centre of mass, split over both soles
///   steps          the controller 'recovering', which is that and steps
const std::vector<std::string>& WaysToStand();

/// A robot that comes with the program, and a plan of it that stands for 3 s.
struct Stander {
  RobotModel model;
  MotionPlan plan;
};
/// @throws InvalidArgument with the reason where there is no such robot or plan.
Stander MakeStander(const std::string& robot);

/// @throws InvalidArgument for a way that there is not. The stander must outlive it.
std::unique_ptr<Controller> MakeWayToStand(const Stander& stander, const std::string& way);

/// Whether it stands after a push at its base for 0.1 s. @param direction_deg  from ahead over the left.
bool StandsPush(const Stander& stander, Controller& controller, double force_n, double direction_deg);

/// The largest such push after which it stands, up to `most_n` and to a hundredth of that, by bisection [N].
double LargestPush(const Stander& stander, const std::string& way, double direction_deg, double most_n);

/// What each way took, by direction, as an SVG picture seen from above with the robot's heading up.
struct PushesTaken {
  std::string way;
  std::vector<double> directions_deg, largest_n;
};
std::string PushPicture(const std::vector<PushesTaken>& taken);

}  // namespace gaitwright::examples
