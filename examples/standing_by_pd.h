// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright::examples {

/// Result of standing by stiffness alone.
struct StoodByPd {
  double ankles_nm_rad = 0.0;     ///< k: sum of the stiffness of all ankles
  double needed_nm_rad = 0.0;     ///< m g h: m without the feet, their centre of mass h above the ankles
  double lean_rad = 0.0;          ///< mean deflection of the ankles at the end, forward positive
  double lean_formula_rad = 0.0;  ///< m g x / (k - m g h), x: forward distance of c from the ankles; k > m g h
  double sag_m = 0.0;             ///< downward displacement of the base at the end
  bool stands = false;
};

/// Effect of kp on joints that carry the robot: it stands for 5 s by joint PD without feed-forward. The gains are those
/// of playback/control/gains.h times the scale; kd is multiplied by the square root of the scale, which keeps the
/// damping ratio.
/// A joint deflects until kp times the deflection carries its load. On its ankles the robot is an inverted pendulum,
/// and its load grows with the lean: k lean = m g (x + h lean). If k is at most m g h, the robot falls at any damping.
/// If k is slightly larger, it also falls, because the lean moves the weight beyond the edge of the soles. Hips and
/// knees also deflect, so a robot with all joints free needs a still higher k.
/// @param only_ankles  welds all other joints, as in the pendulum of the formula.
/// @throws InvalidArgument if a leg does not end in a sole below a joint that pitches it, or if the scale is out of
/// range.
StoodByPd StandByPd(const RobotModel& model, double stiffness_scale, bool only_ankles);

/// Smallest scale with which the robot stays up, to 4 %; 1 if no scale below 1 is sufficient.
double LeastScale(const RobotModel& model, bool only_ankles);

}  // namespace gaitwright::examples
