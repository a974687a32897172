// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/upper_body.h"

namespace gaitwright {

/// Joints with which an arm's end is as high as it comes: each joint of the arm in turn goes to where that is highest,
/// a tenth of a leg's length of height being worth a radian, until none gains any more. Joints keep a twentieth of
/// their range from its ends. The straight way there is free of self-collision; where the whole way is not, it is gone
/// as far as it is free.
/// @param from  all independent joints, size n, from where the arm goes.
/// Failure kInfeasible `self_collision` where less than a quarter of the leg's length of height is gained on a free
/// way; names the two links.
Result<VectorX> RaisedArm(const RobotModel& model, const Limb& arm, const VectorX& from);

/// The two ends of a wave, from joints with the arm raised: the joint that moves the arm's end sideways most goes
/// 0.35 rad to each side, as far as its limits let it and no links meet.
struct Wave {
  VectorX out, in;  ///< all independent joints, size n
};
/// Failure kInfeasible `no_wave` if no joint of the arm moves it sideways.
Result<Wave> WaveOf(const RobotModel& model, const Limb& arm, const VectorX& raised);

/// Joints with which a head looks down by an angle, as far as its limits let it, or up for a negative one.
VectorX NoddedHead(const RobotModel& model, const Limb& head, const VectorX& from, double down_rad);

}  // namespace gaitwright
