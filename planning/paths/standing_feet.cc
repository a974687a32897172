// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/standing_feet.h"

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {

std::vector<Pose> StandingFeet(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::vector<Pose> feet;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    Pose X_BF = ContactFrame(model, scratch, f);
    X_BF.translation().z() = 0.0;
    X_BF.linear() = YawRotation(YawOf(X_BF.linear()));  // exactly upright, without rounding errors
    feet.push_back(X_BF);
  }
  return feet;
}

Pose Carried(const PlanarPose& base, const Pose& X_BF) {
  Pose X_WB = Pose::Identity();
  X_WB.linear() = YawRotation(base.yaw_rad);
  X_WB.translation() = Vector3(base.x_m, base.y_m, 0.0);
  return X_WB * X_BF;
}

}  // namespace gaitwright
