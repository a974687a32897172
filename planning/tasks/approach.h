// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/audit/audit.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Longest approach [s], and largest number of its rows at the plan's time step.
inline constexpr double kLongestApproach = 600.0;
inline constexpr double kMostApproachRows = 120000.0;

/// Speeds and limits of the motion to the first posture.
struct ApproachOptions {
  double speed_share = 0.1;
  double speed_rad_s = 0.5;
  double speed_m_s = 0.05;
  double limit_share = 0.8;
  double least_s = 1.0;

  OptionFields Fields() {
    return WithBasics(
        {"speed_share", "least_s"},
        {{"speed_share", &speed_share, "1", 0.001, 1.0,
          "Largest share of the joints' speed limits in the motion to the first posture."},
         {"speed_rad_s", &speed_rad_s, "rad/s", 0.001, 100.0,
          "Largest speed of a revolute joint in the motion to the first posture."},
         {"speed_m_s", &speed_m_s, "m/s", 0.0001, 10.0,
          "Largest speed of a prismatic joint in the motion to the first posture."},
         {"limit_share", &limit_share, "1", 0.01, 1.0,
          "Largest share of the limits of torque, acceleration and jerk in the motion to the first posture."},
         {"least_s", &least_s, "s", 0.1, 60.0, "Shortest duration of each move."}});
  }
};

/// A motion to the first posture of a plan.
struct Approach {
  MotionPlan plan;            ///< one part with a hanging base (HangingGait); passes its audit
  bool via_standing = false;  ///< true if the direct motion is not collision-free
  std::string farthest;       ///< the joint that moves farthest
  double farthest_by = 0.0;   ///< distance that it moves [rad] or [m]
};

/// Whether an approach is needed: a joint is farther from the plan's first posture than the audit accepts
/// (`start_tolerance_rad`, `_m`). Also true if the plan or the posture has other joints than the robot; PlanApproach
/// refuses these.
bool NeedsApproach(const RobotModel& model, const MotionPlan& plan, const StartPosture& from,
                   const AuditOptions& audit);

/// A safe motion from the measured joints to the first posture of a plan: all joints move together from rest to rest by
///   q(t) = q0 + (q1 - q0) (10 u^3 - 15 u^4 + 6 u^5),  u = t / T,
/// This is the motion of least jerk (Flash and Hogan, J. Neuroscience 5(7), 1985). Its speed, acceleration and jerk are
/// at most 1.875 |q1 - q0| / T, 5.7735 |q1 - q0| / T^2 and 60 |q1 - q0| / T^3, so T follows from the limits.
///
/// The robot hangs: its base is held in the air, as on a stand, with the measured tilt (level if unknown), so that feet
/// may move freely. Afterwards it is set down and the plan starts. The straight line in joint space is checked for
/// self-collision. If it is not free, the motion via the standing posture is tried; if that is not free either, the
/// failure names the two links. The motion is slowed down until torques are within limits. It is audited like any plan
/// with the derating of `audit`; where the shares of `audit` are smaller than those of `options`, they apply to the
/// approach.
///
/// Failure kBadInput: sizes that disagree, positions that are not finite, a self-collision at one of the two ends.
/// kInfeasible: no collision-free motion; a motion of more than kLongestApproach or kMostApproachRows (checked before
/// rows are made); a motor too weak to hold what hangs from it (named with its torque and limit); a failed check of the
/// audit.
/// @throws InvalidArgument for options out of range.
Result<Approach> PlanApproach(const RobotModel& model, const MotionPlan& plan, const StartPosture& from,
                              const ApproachOptions& options = {}, const AuditOptions& audit = {});

}  // namespace gaitwright
