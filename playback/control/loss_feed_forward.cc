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
  for (const Transmission& t : model.transmissions) {
    const MatrixX inertia = share * t.RotorInertia();
    if (!inertia.isZero(0.0)) shared_.push_back({t.dofs, inertia});
  }
}

void LossFeedForward::AddInertia(const Eigen::Ref<const VectorX>& a, VectorX& tau) const {
  for (const Loss& loss : losses_) tau[loss.dof] += loss.losses.rotor_inertia * a[loss.dof];
  for (const auto& [dofs, inertia] : shared_) {
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      for (std::size_t j = 0; j < dofs.size(); ++j)
        tau[dofs[i]] += inertia(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * a[dofs[j]];
    }
  }
}

void LossFeedForward::AddDrag(const VectorX& v, VectorX& tau) const {
  for (const auto& [dof, losses, friction_speed] : losses_) {
    tau[dof] += losses.damping * v[dof] + losses.friction * std::tanh(v[dof] / friction_speed);
  }
}

}  // namespace gaitwright
