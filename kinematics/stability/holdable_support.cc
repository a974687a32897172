// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/holdable_support.h"

#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright {

Polygon HoldableSupport(const RobotModel& model, const DynamicsScratch& scratch, int foot, const Polygon& support,
                        const Vector3& p_WC, double normal_n, double use) {
  constexpr double kLow = 0.5;   // of the height of the centre of mass
  constexpr double kFlat = 0.5;  // horizontal part of an axis that counts
  if (support.size() < 3 || foot >= static_cast<int>(model.legs.size())) return support;
  const double ground = ContactFrame(model, scratch, foot).translation().z();
  const double height = p_WC.z() - ground;
  Polygon held = support;
  for (const int index : model.legs[static_cast<std::size_t>(foot)].joints) {
    const auto j = static_cast<std::size_t>(index);
    const Joint& joint = model.joints[j];
    const Vector3 p_WJ = scratch.p_WB[j + 1], axis = scratch.axis_W[j];
    const double share = (p_WJ.z() - ground) / height;
    if (joint.is_prismatic() || share > kLow || axis.head<2>().norm() < kFlat) continue;
    // tau = N (a_y (x - p_x) - a_x (y - p_y)) at the point (x, y) = Z + (C - Z) share of the force's line.
    const Vector2 across(axis.y(), -axis.x());
    const double most = use * model.dof_effort_limit(joint.dof) / (normal_n * (1.0 - share));
    const double middle = across.dot(p_WJ.head<2>() - share * p_WC.head<2>()) / (1.0 - share);
    const Polygon part = Clipped(Clipped(held, across, middle - most), -across, -middle - most);
    if (part.size() >= 3) held = part;
  }
  return held;
}

}  // namespace gaitwright
