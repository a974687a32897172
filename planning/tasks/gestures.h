// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/upper_body.h"

namespace gaitwright {

/// Joints with which an arm's end is as high as possible. Each joint of the arm in turn goes to its best value, until
/// no joint gains height; a radian of motion costs as much as a tenth of a leg's length of height. Joints keep a margin
/// of 5 % of their range to their limits. The straight line in joint space is free of self-collision; if only a first
/// part of it is free, the arm goes to the end of that part.
/// @param from  all independent joints, size n; where the arm starts.
/// Failure kInfeasible `self_collision` if the arm gains less than a quarter of the leg's length of height on a free
/// line; names the two links.
Result<VectorX> RaisedArm(const RobotModel& model, const Limb& arm, const VectorX& from);

/// The two ends of a wave, from joints with the arm raised. The joint that moves the arm's end sideways most goes 0.35
/// rad to each side, or less where its limits or a self-collision end the motion.
struct Wave {
  VectorX out, in;  ///< all independent joints, size n
};
/// Failure kInfeasible `no_wave` if no joint of the arm moves it sideways.
Result<Wave> WaveOf(const RobotModel& model, const Limb& arm, const VectorX& raised);

/// Joints with which a head looks down by an angle (up if negative), within the joint limits.
VectorX NoddedHead(const RobotModel& model, const Limb& head, const VectorX& from, double down_rad);

}  // namespace gaitwright
