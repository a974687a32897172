// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/tasks/posture_motion.h"

namespace gaitwright {

/// Posture of lying on the first support link (RobotModel::feet), with the feet at their standing positions.
struct Lying {
  PostureKey lying;  ///< with the support link on the ground
  PostureKey over;   ///< the same posture slightly above the ground
};

/// Searches forward and backward of the standing body for the nearest place at which the support link is on the ground
/// and the legs reach their feet. There and on the motion down, joints keep a margin of 3 % of their range to their
/// limits, and links collide neither with each other nor with the ground.
/// @param joints  all independent joints, size n; those of the legs are solved for.
/// Failure kInfeasible `lying` for a robot without a support link, or whose legs do not fold far enough: names the
/// links that collide, or the joint that limits the motion.
Result<Lying> FindLying(const RobotModel& model, const VectorX& joints);

/// Motion from a key to lying.
PostureMotion LieDown(const RobotModel& model, const PostureKey& from, const Lying& lying);

/// Motion from lying to standing, in phases that each end on a measured condition: `init` takes the load onto the feet,
/// `lift front` pitches the body up by an angle, `lift rear` straightens the hind legs, `balance` stands. Moves have a
/// trapezoidal speed profile with smooth corners.
PostureMotion GetUp(const RobotModel& model, const PostureKey& standing, const Lying& lying, double tip_rad);

}  // namespace gaitwright
