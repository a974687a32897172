// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/loss_feed_forward.h"

#include <cmath>

namespace gaitwright {

LossFeedForward::LossFeedForward(const RobotModel& model, const GainOptions& options) {
  GainOptions checked = options;
  CheckOptions(checked.Fields());
  const double share = options.loss_feed_forward;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    JointLosses losses = LossesOf(model, dof);
    losses = {share * losses.rotor_inertia, share * losses.damping, share * losses.friction};
    const bool slides = model.LeaderOf(dof).is_prismatic() && !model.legs.empty();
    const double speed = options.friction_speed_rad_s * (slides ? model.leg_length_m() : 1.0);
    if (!losses.none()) losses_.push_back({dof, losses, speed});
  }
}

void LossFeedForward::AddInertia(const Eigen::Ref<const VectorX>& a, VectorX& tau) const {
  for (const Loss& loss : losses_) tau[loss.dof] += loss.losses.rotor_inertia * a[loss.dof];
}

void LossFeedForward::AddDrag(const VectorX& v, VectorX& tau) const {
  for (const auto& [dof, losses, friction_speed] : losses_) {
    tau[dof] += losses.damping * v[dof] + losses.friction * std::tanh(v[dof] / friction_speed);
  }
}

}  // namespace gaitwright
