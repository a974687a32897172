// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright::examples {

/// What came of standing by stiffness alone.
struct StoodByPd {
  double ankles_nm_rad = 0.0;     ///< k: stiffness of all ankles together
  double needed_nm_rad = 0.0;     ///< m g h: of all but the feet, their centre of mass h over the ankles
  double lean_rad = 0.0;          ///< by which the ankles gave way at the end, ahead positive; their mean
  double lean_formula_rad = 0.0;  ///< m g x / (k - m g h), x ahead of them; for k > m g h
  double sag_m = 0.0;             ///< of the base, at the end
  bool stands = false;
};

/// What kp does where joints carry the robot: it stands for some seconds by joint PD with no feed-forward, by the gains
/// of playback/control/gains.h scaled, kd by the root of the scale so that the damping ratio stays.
/// A joint gives way until kp times that carries its load. On its ankles the robot is an inverted pendulum, whose load
/// grows with the lean: k lean = m g (x + h lean). With k not over m g h it falls, however much damping there is; with
/// little more too, where the lean takes the weight past the edge of the soles. Hips and knees that give way ask for
/// more again.
/// @param only_ankles  all other joints are welded: the pendulum of the formula.
/// @throws InvalidArgument for a robot whose legs do not end in a sole below a joint that pitches it, and a scale out
/// of range.
StoodByPd StandByPd(const RobotModel& model, double stiffness_scale, bool only_ankles);

/// The least scale, to 4 %, with which it stays up; 1 where that is not below 1.
double LeastScale(const RobotModel& model, bool only_ankles);

}  // namespace gaitwright::examples
