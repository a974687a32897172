// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Longest step of a robot, foot to foot [m]: both legs stretched to `stretch` of their length, from hips at the height
/// h of the standing posture: l = 2 sqrt((stretch L)^2 - h^2), at least 0.2 L, averaged over the legs.
double StepReach(const RobotModel& model, double stretch);

/// Time from `time_s` to the next scheduled touch-down after it; after the last one, the mean interval between those
/// that were, or the gait's half cycle.
double TimeToNextTouchdown(const MotionPlan& plan, double time_s);

/// A touch-down of the schedule, and the feet that then stand until the next one ("the support to come").
struct Touchdown {
  double time_s = 0.0;
  FootSet stance = 0;
};

/// All of them after the schedule's start. Where no foot stands all the way to the next, the feet that come down.
std::vector<Touchdown> TouchdownsOf(const ContactSchedule& schedule);

/// Signed distance of the DCM to the one-step capturable set of a support [m].
///
/// With the ZMP held at a point p of S for the time T, the DCM goes to p + (xi - p) exp(omega T). A step puts a copy of
/// S at most l further, so it can come under the DCM exactly when |xi - p| <= l exp(-omega T) for some p of S: the set
/// is S inflated by l exp(-omega T). After Koolen et al., Int. J. Robotics Research 31(9) 2012, with the step time of
/// the plan in place of the smallest possible one. @pre the support is not empty.
double CaptureMargin(const Support& support, const MotionSample& sample, double reach_m, double time_s);

}  // namespace gaitwright
