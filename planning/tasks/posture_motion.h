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
  double after_s = 0.0;                ///< time since the key before
  Vector3 shift = Vector3::Zero();     ///< of the centre of mass: forward, to the left, up [m]
  Vector3 turn_rad = Vector3::Zero();  ///< of the base: roll, pitch and yaw, R = Rz Ry Rx
  VectorX joints = VectorX();          ///< of all independent joints, size n; those that no foot needs go there
  double cruise = 0.0;                 ///< share of the time at constant speed before this key (SmoothStep)
};

/// A foot that is lifted off its place and put down there again.
struct FootLift {
  int foot = 0;
  std::size_t from_key = 0, to_key = 0;  ///< it leaves the ground at the one and is down again at the other
  double height_m = 0.0;
};

/// A rest (a foot beyond the legs', see RobotModel::feet) that lies on the ground from one key to another.
struct RestStay {
  int rest = 0;
  std::size_t from_key = 0, to_key = 0;
};

/// A stretch of keys that is one thing done.
struct PostureSection {
  std::string name;          ///< such as "squat"
  std::size_t last_key = 0;  ///< at which it ends; it begins where the one before ends
  bool waits = false;        ///< the plan waits at its end until it is measured to be done (PlanGate)
};

/// Something that is done without walking: the body goes from key to key, at rest at each, on feet that stay where they
/// are. Between keys all goes by the minimum-jerk step (SmoothStep).
struct PostureMotion {
  std::string name;                           ///< of what is done, such as "squat"
  std::vector<PostureKey> keys;               ///< two or more, the first one at time 0
  std::vector<FootLift> lifts = {};           ///< in order
  std::vector<RestStay> rests = {};           ///< in order
  std::vector<PostureSection> sections = {};  ///< in order; none for one of the motion's name
  OptionTexts options = {};                   ///< what it was made of, for the plan's provenance

  double duration_s() const;
  /// When a key is reached, from the start [s].
  double TimeOf(std::size_t key) const;
};

/// A posture motion at one time, with its derivatives.
struct PostureSample {
  std::array<Motion1, 3> shift, turn;
  VectorX q, v, a;  ///< joints, size n
};

/// Where the motion is at a time; on its ends before and after.
void SampleAt(const PostureMotion& motion, double time_s, PostureSample& sample);

/// The same motion, each of its moves so many times as long, in whole steps of a grid.
PostureMotion Stretched(PostureMotion motion, double factor, double grid_step_s);

/// Motions one after the other as one, each a section at the least. Each begins with the key that the one before ends
/// with. @throws InvalidArgument for none.
PostureMotion Chained(const std::vector<PostureMotion>& motions);

/// @throws InvalidArgument for fewer than two keys, joints of another size than the robot's, a time that is negative or
/// not finite, numbers that are not finite, and a lift that is none.
void CheckPostureMotion(const RobotModel& model, const PostureMotion& motion);

}  // namespace gaitwright
