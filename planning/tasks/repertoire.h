// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/tasks/posture_motion.h"

namespace gaitwright {

/// The standing posture, with which each motion plan starts.
PostureKey StandingKey(const RobotModel& model);

// Each of these motions begins with the key `from` (its time is not used). The parameters set the size. Durations look
// natural for the robot's size; the caller stretches the motion (Stretched) if motors or balance need more time.

/// Keeps the posture.
PostureMotion Hold(const PostureKey& from, double duration_s);

/// Goes to another key and stays there.
PostureMotion GoTo(const RobotModel& model, const std::string& name, const PostureKey& from, const PostureKey& to);

/// Bends the legs and straightens them again, `times` times; stays low for hold_s each time.
PostureMotion Squat(const RobotModel& model, const PostureKey& from, double depth_m, int times, double hold_s);

/// Pitches the body forward and comes up again. The centre of mass stays over the same place and is lowered by
/// `lower_m`.
PostureMotion Bow(const RobotModel& model, const PostureKey& from, double angle_rad, double lower_m, int times);

/// The key of a quadruped that sits as a dog does: tipped back, its hind legs bent.
PostureKey SittingKey(const RobotModel& model, double angle_rad, double lower_m);

/// Nods with the head, or with the body if the robot has no head.
PostureMotion Nod(const RobotModel& model, const PostureKey& from, int times);

/// The arms that a motion uses.
struct Sides {
  bool left = false, right = false;
};

/// Raises arms and leaves them up. Failure kBadInput `no_arm` if the robot does not have that arm; failures of
/// RaisedArm.
Result<PostureMotion> RaiseArms(const RobotModel& model, const PostureKey& from, Sides sides);

/// Returns arms to their standing posture. Failure kBadInput `no_arm`.
Result<PostureMotion> LowerArms(const RobotModel& model, const PostureKey& from, Sides sides);

/// Raises arms, waves to both sides `times` times and returns to `from`. Failures as for RaiseArms and WaveOf.
Result<PostureMotion> WaveArms(const RobotModel& model, const PostureKey& from, Sides sides, int times);

/// Stands on one foot for a while, with the other one lifted, and then on both again. The centre of mass moves over the
/// middle of the foot's sole, or inward of it by a share of the distance between the feet. Failure kBadInput `two_feet`
/// unless the robot has exactly two feet with soles.
/// @param on  the foot that stays on the ground.
Result<PostureMotion> BalanceOn(const RobotModel& model, const PostureKey& from, int on, double inward, double hold_s);

/// Lowers the body quickly and stays low, when a fall is certain.
PostureMotion Brace(const RobotModel& model, const PostureKey& from, double depth_m, double hold_s);

}  // namespace gaitwright
