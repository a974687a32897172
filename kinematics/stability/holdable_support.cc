// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/holdable_support.h"

#include <vector>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"

namespace gaitwright {
namespace {

/// Torque of a joint near the ground as a function of the ZMP:  tau = normal_n (1 - share) (across . Z - middle).
struct AnkleTorque {
  int dof;
  double share;
  Vector2 across;
  double middle;
};

void KeepStrip(const Vector2& across, double middle, double most, Polygon& held) {
  const Polygon part = Clipped(Clipped(held, across, middle - most), -across, -middle - most);
  if (part.size() >= 3) held = part;
}

/// Limits the support by a motor of a transmission, whose torque is a sum over its joints.
void KeepSharedStrip(const Actuator& motor, const std::vector<AnkleTorque>& ankles, double normal_n, double use,
                     Polygon& held) {
  Vector2 across = Vector2::Zero();
  double middle = 0.0;
  for (const AnkleTorque& ankle : ankles) {
    for (const Actuator::Term& term : motor.terms) {
      if (term.dof != ankle.dof) continue;
      across += term.by_effort * (1.0 - ankle.share) * ankle.across;
      middle += term.by_effort * (1.0 - ankle.share) * ankle.middle;
    }
  }
  if (across.isZero()) return;
  KeepStrip(across, middle, use * motor.effort_limit / normal_n, held);
}

}  // namespace

Polygon HoldableSupport(const RobotModel& model, const DynamicsScratch& scratch, int foot, const Polygon& support,
                        const FootLoad& load, double use) {
  constexpr double kLow = 0.5;   // largest height of a joint over that of the centre of mass
  constexpr double kFlat = 0.5;  // smallest horizontal part of the axis
  if (support.size() < 3 || foot >= static_cast<int>(model.legs.size())) return support;
  const double ground = ContactFrame(model, scratch, foot).translation().z();
  const double height = load.p_WC.z() - ground;
  Polygon held = support;
  std::vector<AnkleTorque> shared;
  for (const int index : model.legs[static_cast<std::size_t>(foot)].joints) {
    const auto j = static_cast<std::size_t>(index);
    const Joint& joint = model.joints[j];
    const Vector3 p_WJ = scratch.p_WB[j + 1], axis = scratch.axis_W[j];
    const double share = (p_WJ.z() - ground) / height;
    if (joint.is_prismatic() || share > kLow || axis.head<2>().norm() < kFlat) continue;
    // tau = N (a_y (x - p_x) - a_x (y - p_y)), where (x, y) = Z + (C - Z) share is a point on the line of the force.
    const Vector2 across(axis.y(), -axis.x());
    const double middle = across.dot(p_WJ.head<2>() - share * load.p_WC.head<2>()) / (1.0 - share);
    if (model.TransmissionOf(joint.dof) != nullptr) {
      shared.push_back({joint.dof, share, across, middle});
      continue;
    }
    KeepStrip(across, middle, use * model.dof_effort_limit(joint.dof) / (load.normal_n * (1.0 - share)), held);
  }
  for (int dof = 0; !shared.empty() && dof < model.num_dofs(); ++dof) {
    const Actuator motor = ActuatorOf(model, dof);
    if (motor.shared()) KeepSharedStrip(motor, shared, load.normal_n, use, held);
  }
  return held;
}

}  // namespace gaitwright
