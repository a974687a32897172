// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/motion_passes.h"

namespace gaitwright {

/// What decides how the body may be carried.
struct CarriageProblem {
  double standing_m = 0.0;    ///< height of the centre of mass in standing
  double asked_m = 0.0;       ///< height that is asked for; 0 for none
  double zmp_inward = 0.0;    ///< preferred, see SupportRegions
  bool uneven = false;        ///< the ground is not level and bare
  bool on_one_sole = false;   ///< the robot stands on one sole alone for a while
  bool finishes_all = false;  ///< motions past limits are finished too, since one of them may be taken
};

/// Motions of one walk with the body carried in different ways.
struct CarriageTrials {
  /// The motion with a carriage; one that is first farther past limits than `hopeless` is not finished.
  std::function<Result<MotionPass>(const Carriage&, double hopeless)> plan;
  /// Whether all feet are reached with a carriage.
  std::function<bool(const Carriage&)> reaches;
};

/// Finds how the body is carried over its feet: as preferred, and where that is past limits by other carriages, each
/// kept where the excess is less. Over uneven ground the body is higher or lower for a while, and over single soles it
/// leans forward too, which bends a hip less that is behind; on one sole the ZMP runs farther inward of its middle, as
/// is needed by ankles and hips that bend sideways. Last, and unless a height is asked for, the body is ever lower
/// while that helps some foot that is out of reach or joints that are past limits, as knees are that straighten; at
/// that height lean and ZMP are tried once more. Where no carriage keeps all limits, the one with the least excess; the
/// failure of the first where none reaches all feet.
Result<MotionPass> FindCarriage(const CarriageProblem& problem, const CarriageTrials& trials);

}  // namespace gaitwright
