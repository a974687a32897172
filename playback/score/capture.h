// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Longest step of a robot, foot to foot [m]: both legs stretched to `stretch` of their length, from hips at the height
/// h of the standing posture: l = 2 sqrt((stretch L)^2 - h^2), at least 0.2 L, averaged over the legs.
double StepReach(const RobotModel& model, double stretch);

/// Times at which some foot comes down after the schedule's start, in order.
std::vector<double> TouchdownTimes(const ContactSchedule& schedule);

/// Some feet standing for some time on the way to the next touch-down.
struct CaptureStage {
  double duration_s = 0.0;
  FootSet stance = 0;
};

/// The stages of the schedule from `time_s` to the next touch-down after it: both feet, then one, say. After the last
/// touch-down the final stance is held for the mean interval between touch-downs of the last gait, or its half cycle.
std::vector<CaptureStage> StagesToNextTouchdown(const MotionPlan& plan, double time_s);

/// Signed distance of the DCM to the one-step capturable set of the support to come [m]; nothing when no stage has a
/// foot on the ground.
///
/// While the ZMP is held at a point p for a time t, the DCM goes from xi to p + (xi - p) exp(omega t). Over the stages
/// i of the support S_i and the duration t_i up to the next touch-down, at T = sum t_i, it can be brought to every
/// point within reach l of S_last exactly from the set
///   C = sum_i (exp(-omega T_i) - exp(-omega T_i+1)) S_i  +  exp(-omega T) (S_last + disc of radius l),
/// T_i the start of stage i and sums those of Minkowski; a step puts a copy of S_last at most l further, under the DCM.
/// With one stage C is S inflated by l exp(-omega T). After Koolen et al., Int. J. Robotics Research 31(9) 2012, with
/// the step times of the plan in place of the smallest possible ones. @pre ForwardKinematics of `scratch`.
std::optional<double> CaptureMargin(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain,
                                    const std::vector<CaptureStage>& stages, const MotionSample& sample,
                                    double reach_m);

}  // namespace gaitwright
