// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/joint_run_internal.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Collects frames of a skeleton as rows of a robot's motion.
///
/// = Notation =
///   S  axes of the skeleton at rest, in which its rotations are given
class SkeletonFrames {
 public:
  /// @param R_BS  axes of the base from those of the skeleton, both at rest.
  SkeletonFrames(const RobotModel& model, MotionFormat format, const Matrix3& R_BS);

  /// Begins a frame: position [m] and rotation of the root, in the axes of the skeleton. Joints without a value stand.
  void Begin(double time_s, const Vector3& p_S, const Matrix3& R_S);
  /// Sets the angles of a run from the rotation of one joint of the skeleton. @param name  of it, for messages.
  void Turn(const std::string& name, const JointRun& run, const Matrix3& R_S);
  void Set(int dof, double value) { table_.q.back()[dof] = value; }

  /// The table, with a note on rotations that the robot's joints cannot do.
  MotionTable Take();

 private:
  struct Left {
    std::string name;
    double most_rad = 0.0, at_s = 0.0;
  };

  const RobotModel& model_;
  const Matrix3 R_BS_;
  MotionTable table_;
  std::vector<Left> left_;  ///< by joint of the skeleton
};

}  // namespace gaitwright
