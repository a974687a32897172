// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/tasks/posture_motion.h"

namespace gaitwright {

/// How the robot stands at the start of everything: its standing posture.
PostureKey StandingKey(const RobotModel& model);

// Each of these begins with the key `from`, whose time is not looked at, and says what it is sized by. Times are those
// that look natural at the robot's size; where motors or balance ask for more, the motion is stretched (Stretched).

/// Stays as it is.
PostureMotion Hold(const PostureKey& from, double duration_s);

/// Goes to another key and stays there.
PostureMotion GoTo(const RobotModel& model, const std::string& name, const PostureKey& from, const PostureKey& to);

/// Bends the legs and straightens them again, some times; stays low for a while each time.
PostureMotion Squat(const RobotModel& model, const PostureKey& from, double depth_m, int times, double hold_s);

/// Tips the body ahead and comes up again, the centre of mass over the same place and lower by `lower_m` meanwhile.
PostureMotion Bow(const RobotModel& model, const PostureKey& from, double angle_rad, double lower_m, int times);

/// The key of a quadruped that sits as a dog does: tipped back, its hind legs bent.
PostureKey SittingKey(const RobotModel& model, double angle_rad, double lower_m);

/// Nods with its head, or with its body where it has none.
PostureMotion Nod(const RobotModel& model, const PostureKey& from, int times);

/// Which arms do something.
struct Sides {
  bool left = false, right = false;
};

/// Raises arms and leaves them up. Failure kBadInput `no_arm` for an arm that there is not, or as of RaisedArm.
Result<PostureMotion> RaiseArms(const RobotModel& model, const PostureKey& from, Sides sides);

/// Brings arms back to where they are in standing. Failure kBadInput `no_arm`.
Result<PostureMotion> LowerArms(const RobotModel& model, const PostureKey& from, Sides sides);

/// Raises arms, waves to both sides some times and goes back to `from`. Failures as of RaiseArms and WaveOf.
Result<PostureMotion> WaveArms(const RobotModel& model, const PostureKey& from, Sides sides, int times);

/// Stands on one foot for a while, the other one lifted, and on both again. The centre of mass goes over the middle of
/// the foot's sole, or by a share of the feet's distance inward of it. Failure kBadInput `two_feet` for a robot that
/// has not two feet with soles.
/// @param on  the foot that stays on the ground.
Result<PostureMotion> BalanceOn(const RobotModel& model, const PostureKey& from, int on, double inward, double hold_s);

/// Gets low quickly, and stays so: what is left to do where a fall is certain.
PostureMotion Brace(const RobotModel& model, const PostureKey& from, double depth_m, double hold_s);

}  // namespace gaitwright
