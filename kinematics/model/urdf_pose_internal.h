// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/pose.h>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

inline Pose FromUrdf(const urdf::Pose& pose) {
  Pose X = Pose::Identity();
  X.translation() = Vector3(pose.position.x, pose.position.y, pose.position.z);
  X.linear() =
      Quaternion(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z).normalized().toRotationMatrix();
  return X;
}

}  // namespace gaitwright
