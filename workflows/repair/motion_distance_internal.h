// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Distance of a part of the robot from another motion.
struct GroupDistance {
  std::string group;  ///< "legs", "arms", "torso_and_head": positions of joints; "base", "hands", "feet": places in W
  std::string unit;   ///< "rad" or "m"
  double rms = 0.0;   ///< over all members and times
  double largest = 0.0, largest_s = 0.0;
  std::string largest_where;     ///< joint, foot, or last link of the arm; empty for the base
  std::vector<float> over_time;  ///< by row of the other motion: RMS over all members
};

/// Name of a group in words: "torso and head".
std::string WordsOfGroup(const std::string& group);

/// How far a plan is from a motion. Prismatic joints count with metres as radians.
struct MotionDistance {
  double joint_rms_rad = 0.0, joint_mean_rad = 0.0;  ///< over all joints and times
  double joint_largest_rad = 0.0, joint_largest_s = 0.0;
  std::string joint_largest;  ///< which
  double base_rms_m = 0.0, base_largest_m = 0.0, base_largest_s = 0.0;
  double base_turn_rms_rad = 0.0;
  std::vector<GroupDistance> groups;  ///< only groups that the robot has

  /// The group of that name; null if the robot has none.
  const GroupDistance* Group(const std::string& name) const;
};

/// Compares a plan with a motion at the motion's rows; time 0 of both is equal. Arms are those of FindUpperBody with
/// all joints that they carry; joints that are in neither legs nor arms are those of torso and head. A hand is the
/// centre of mass of an arm's last link; a foot is the origin of its contact frame.
MotionDistance DistanceOf(const RobotModel& model, const EvenMotion& original, const MotionPlan& plan);

}  // namespace gaitwright
