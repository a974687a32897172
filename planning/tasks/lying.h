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

/// Looks for the place of the body nearest to that of standing, ahead or behind, at which the rest is on the ground,
/// the legs reach their feet, joints keep off their stops by 3 % of their range and no links meet, nor the ground,
/// there or on the way.
/// @param joints  all independent joints, size n; those of legs are found.
/// Failure kInfeasible `lying` for a robot that has no rest, or whose legs do not fold so far: names what links meet,
/// or the joint that comes nearest to do.
Result<Lying> FindLying(const RobotModel& model, const VectorX& joints);

/// From a key to lying.
PostureMotion LieDown(const RobotModel& model, const PostureKey& from, const Lying& lying);

/// From lying to standing, in phases that each end on a measured condition: `init` takes the load onto the feet, `lift
/// front` tips the body up by an angle, `lift rear` straightens the hind legs, `balance` stands. Moves rise to their
/// speed, hold it and lose it (a trapezoid with smooth corners).
PostureMotion GetUp(const RobotModel& model, const PostureKey& standing, const Lying& lying, double tip_rad);

}  // namespace gaitwright
