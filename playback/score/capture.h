// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Longest step of a robot, foot to foot [m]. Both legs have `stretch` of their full length, from hips at the height h
/// of the standing posture: l = 2 sqrt((stretch L)^2 - h^2), at least 0.2 L, averaged over the legs.
double StepReach(const RobotModel& model, double stretch);

/// Times of touch-down after the schedule's start, in order.
std::vector<double> TouchdownTimes(const ContactSchedule& schedule);

/// A time interval with constant stance feet before the next touch-down.
struct CaptureStage {
  double duration_s = 0.0;
  FootSet stance = 0;
};

/// The stages of the schedule from `time_s` to the next touch-down, for example double support, then single support.
/// After the last touch-down, the final stance is held for the mean interval between touch-downs of the last gait, or
/// half its cycle.
std::vector<CaptureStage> StagesToNextTouchdown(const MotionPlan& plan, double time_s);

/// Signed distance of the DCM to the one-step capturable set of the coming supports [m]; nothing if no stage has a foot
/// on the ground.
///
/// While the ZMP stays at a point p for a time t, the DCM moves from xi to p + (xi - p) exp(omega t). Stages i with
/// supports S_i and durations t_i last until the next touch-down at T = sum t_i. The DCM can then reach every point
/// within the distance l of S_last exactly from the set
///   C = sum_i (exp(-omega T_i) - exp(-omega T_i+1)) S_i  +  exp(-omega T) (S_last + disc of radius l),
/// with T_i the start of stage i and Minkowski sums. A step puts a copy of S_last under the DCM, at most l further.
/// With one stage, C is S inflated by l exp(-omega T). After Koolen et al., Int. J. Robotics Research 31(9) 2012, with
/// the step times of the plan instead of the smallest possible ones. @pre ForwardKinematics of `scratch`.
std::optional<double> CaptureMargin(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain,
                                    const std::vector<CaptureStage>& stages, const MotionSample& sample,
                                    double reach_m);

}  // namespace gaitwright
