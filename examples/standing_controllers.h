// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"

namespace gaitwright::examples {

/// The classics of standing, from the least that a controller can do to the most:
///
///   joint-pd    holds each joint where it is in standing, and knows of nothing else
///   ankle       moves the ZMP by the ankles: p_Z = p_Z0 + k_p (p_C - p_C0) + k_d v_C / omega, inside the soles
///   ankle-dcm   the same by the divergent component of motion: p_Z = p_Z0 + k (xi - xi_0), xi = p_C + v_C / omega
///   hip         bends the hips with the fall, which turns the trunk and pushes the feet back (Horak and Nashner,
///               J. Neurophysiology 55(6), 1986); the ankles do as above
///   whole-body  what the program walks with: attitude, height and DCM over all contact forces inside their cones
const std::vector<std::string>& StandingStrategies();

/// The controller of that name for a plan of standing still, which must outlive it like the model.
/// @throws InvalidArgument listing those there are.
std::unique_ptr<Controller> MakeStandingController(const std::string& strategy, const RobotModel& model,
                                                   const MotionPlan& plan);

}  // namespace gaitwright::examples
