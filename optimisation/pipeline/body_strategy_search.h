// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/motion_passes.h"

namespace gaitwright {

/// Inputs of the search for a body posture.
struct BodyStrategyProblem {
  double standing_m = 0.0;    ///< height of the centre of mass in standing
  double asked_m = 0.0;       ///< requested height of the centre of mass; 0 if none
  double zmp_inward = 0.0;    ///< preferred value, see SupportRegions
  bool uneven = false;        ///< true unless the ground is one level plane without objects
  bool on_one_sole = false;   ///< the robot stands on a single sole at some time
  bool finishes_all = false;  ///< complete also motions that violate limits, because one of them may be returned
};

/// Functions that plan one walk with a given body posture.
struct BodyStrategyTrials {
  /// Plans the motion. It is not completed if its first limit violation exceeds `infeasible`.
  std::function<Result<MotionPass>(const BodyStrategy&, double infeasible)> plan;
  /// Whether all feet reach their footholds.
  std::function<bool(const BodyStrategy&)> reaches;
  /// Whether the motion of the preferred posture, which violates limits, can be made to keep them by other means. The
  /// search then ends.
  std::function<bool(const MotionPass&)> mends;
};

/// Finds the height, lean and preferred ZMP of the body. The preferred posture is tried first. If it violates limits
/// and cannot be mended, other postures are tried, and each is kept if it reduces the limit violation. On uneven ground
/// the body is temporarily higher or lower. Above single soles it also leans forward, so that the rear hip bends less;
/// on one sole the ZMP moves inward, which helps ankles and hips with small roll ranges. Finally, unless a height is
/// requested, the body is lowered step by step while that brings feet into reach or reduces violations, for example of
/// straight knees. At that height, lean and ZMP are tried again. If no posture keeps all limits, returns the motion
/// with the smallest violation; if no posture reaches all feet, the failure of the first one.
Result<MotionPass> FindBodyStrategy(const BodyStrategyProblem& problem, const BodyStrategyTrials& trials);

}  // namespace gaitwright
