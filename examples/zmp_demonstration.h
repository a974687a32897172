// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/motion_series.h"

namespace gaitwright::examples {

/// Result of a shift of the body. A margin is the smallest distance of the zero-moment point (ZMP) from the edge of the
/// support polygon [m], positive inside.
///
/// = Notation =  W world, C centre of mass, Z zero-moment point
struct ShownShift {
  double duration_s = 0.0;
  double margin_planned_m = 0.0;   ///< below 0 if the plan needs the ground to pull
  double margin_measured_m = 0.0;  ///< never below 0 while the soles are level, because the ground cannot pull
  double lead_m = 0.0;             ///< largest horizontal distance of Z from C, until the planned Z leaves the support
  double off_formula_m = 0.0;      ///< largest distance of Z from `formula_W`
  double tilt_rad = 0.0;           ///< largest rotation of the base relative to the plan
  bool fell = false;
  MotionSeries series;             ///< planned and measured, without low-pass filter
  std::vector<Vector2> formula_W;  ///< c - (z / g) c'' of the measured C, from the second sample on, until Z leaves
};

/// The classic demonstration of the zero-moment point: a standing robot shifts its body and stops again, by joint PD
/// and feed-forward alone. If all mass is in C, the ground's force acts at
///   Z = C - (z / g) C'',
/// where z is the height of C. In a slow shift C'' is small, and Z stays below C. In a fast shift Z first moves behind
/// C and then in front of C; its distance from C is four times as large if the shift takes half the time. When Z
/// reaches the edge of the soles, the robot tips about that edge. The mass of the legs is not in C, and the legs
/// rotate. Their angular momentum causes the remaining difference from the formula, for nao a fifth of the distance
/// from C to Z. Kajita et al., ICRA 2003, doi:10.1109/ROBOT.2003.1241826 (cart-table model).
/// @param shift_m  shift of C, forward and to the left.   @param duration_s  duration of the shift, more than 0.
/// @throws InvalidArgument if the legs cannot reach the shift.
ShownShift ShiftBody(const RobotModel& model, const Vector2& shift_m, double duration_s);

}  // namespace gaitwright::examples
