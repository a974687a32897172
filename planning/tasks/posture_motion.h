// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {

/// Posture of the body at one time, relative to standing, with the feet fixed.
struct PostureKey {
  double after_s = 0.0;                ///< time since the previous key
  Vector3 shift = Vector3::Zero();     ///< of the centre of mass: forward, left, up [m]
  Vector3 turn_rad = Vector3::Zero();  ///< of the base: roll, pitch and yaw, R = Rz Ry Rx
  VectorX joints = VectorX();          ///< all independent joints, size n; used for the joints outside of the legs
  double cruise = 0.0;                 ///< share of the time at constant speed before this key (SmoothStep)
};

/// A foot that is lifted and put down at the same place.
struct FootLift {
  int foot = 0;
  std::size_t from_key = 0, to_key = 0;  ///< keys at which it leaves the ground and touches it again
  double height_m = 0.0;
};

/// A support link (an entry of RobotModel::feet after those of the legs) that is on the ground from one key to another.
struct RestStay {
  int rest = 0;
  std::size_t from_key = 0, to_key = 0;
};

/// A group of consecutive keys that is one action.
struct PostureSection {
  std::string name;          ///< such as "squat"
  std::size_t last_key = 0;  ///< its end; it begins at the end of the previous section
  bool waits = false;        ///< the plan waits at its end for a measured condition (PlanGate)
};

/// A motion without walking: the body moves from key to key with the feet fixed and is at rest at each key. Between
/// keys, everything follows the minimum-jerk step (SmoothStep).
struct PostureMotion {
  std::string name;                           ///< name of the motion, such as "squat"
  std::vector<PostureKey> keys;               ///< two or more; the first one at time 0
  std::vector<FootLift> lifts = {};           ///< in ascending order of keys
  std::vector<RestStay> rests = {};           ///< in ascending order of keys
  std::vector<PostureSection> sections = {};  ///< in order; empty for one section with the motion's name
  OptionTexts options = {};                   ///< its parameters, for the plan's provenance

  double duration_s() const;
  /// Time at which a key is reached, from the start [s].
  double TimeOf(std::size_t key) const;
};

/// A posture motion at one time, with its derivatives.
struct PostureSample {
  std::array<Motion1, 3> shift, turn;
  VectorX q, v, a;  ///< joints, size n
};

/// Samples the motion at a time; before and after the motion, its ends.
void SampleAt(const PostureMotion& motion, double time_s, PostureSample& sample);

/// The motion with each move `factor` times as long, rounded up to whole steps of a grid.
PostureMotion Stretched(PostureMotion motion, double factor, double grid_step_s);

/// Joins motions into one; each becomes at least one section. Each must begin with the last key of the previous one.
/// @throws InvalidArgument if `motions` is empty.
PostureMotion Chained(const std::vector<PostureMotion>& motions);

/// @throws InvalidArgument for fewer than two keys, another number of joints than the robot's, a time that is negative
/// or not finite, other numbers that are not finite, and lifts or support contacts outside of the keys or of unknown
/// feet.
void CheckPostureMotion(const RobotModel& model, const PostureMotion& motion);

}  // namespace gaitwright
