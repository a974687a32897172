// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/base_height.h"

#include <algorithm>

namespace gaitwright {

double HipsOverOrigin(const RobotModel& model) {
  double sum = 0.0;
  for (const Leg& leg : model.legs) {
    sum += model.joints[static_cast<std::size_t>(leg.joints.front())].X_PJ.translation().z();
  }
  return model.legs.empty() ? 0.0 : sum / static_cast<double>(model.legs.size());
}

Vector3 HeightPoint(const RobotModel& model) { return {0.0, 0.0, std::max(0.0, HipsOverOrigin(model))}; }

double BaseHeightAtShare(const RobotModel& model, double share) {
  const double over_origin_m = HeightPoint(model).z();
  return share * (model.standing_base_height_m + over_origin_m) - over_origin_m;
}

}  // namespace gaitwright
