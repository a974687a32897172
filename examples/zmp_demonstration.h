// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/motion_series.h"

namespace gaitwright::examples {

/// What came of shifting the body. Margins are the least distances of the zero-moment point (ZMP) from the edge of the
/// support [m], positive inside.
///
/// = Notation =  W world, C centre of mass, Z zero-moment point
struct ShownShift {
  double duration_s = 0.0;
  double margin_planned_m = 0.0;   ///< below 0 where the ground would have to pull
  double margin_measured_m = 0.0;  ///< it cannot: never below 0, as long as the soles are level
  double lead_m = 0.0;             ///< the farthest that Z was from under C, until the plan's Z leaves the support
  double off_formula_m = 0.0;      ///< the farthest that it was from `formula_W`
  double tilt_rad = 0.0;           ///< of the base against its plan, the largest
  bool fell = false;
  MotionSeries series;             ///< planned and measured, not low-passed
  std::vector<Vector2> formula_W;  ///< c - (z / g) c'' of C as measured, from the second sample on, as long as that
};

/// The classic demonstration of the zero-moment point: a robot that stands shifts its body and stops again, by joint PD
/// and feed-forward alone. The ground's force acts at
///   Z = C - (z / g) C'',
/// z being the height of C, if all mass is in C. A slow shift has no C'' to speak of, and Z stays under C. In a quick
/// one it first runs back and then ahead of C, four times as far where the shift takes half the time. Where it comes to
/// the edge of the soles there is nothing beyond to push with, and the robot tips about that edge.
/// Legs are not in C, and they turn: their angular momentum makes the rest, a fifth of the way from C to Z for nao.
/// Kajita et al., ICRA 2003, doi:10.1109/ROBOT.2003.1241826 (the cart on its table).
/// @param shift_m  of C, ahead and to the left.   @param duration_s  which it takes, more than 0.
/// @throws InvalidArgument with the reason, for a shift that the legs do not reach.
ShownShift ShiftBody(const RobotModel& model, const Vector2& shift_m, double duration_s);

}  // namespace gaitwright::examples
