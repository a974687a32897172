// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/gains.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/joint_losses.h"

namespace gaitwright {
namespace {

struct Gain {
  double stiffness = 0.0, damping = 0.0;
};

Gain FromInertia(double inertia, double frequency_rad_s, double damping_ratio) {
  return {inertia * frequency_rad_s * frequency_rad_s, 2.0 * damping_ratio * inertia * frequency_rad_s};
}

Gain LegGain(const RobotModel& model, const Leg& leg, int dof, const GainOptions& options) {
  const double mass = model.total_mass_kg / static_cast<double>(model.legs.size());
  const double share = model.LeaderOf(dof).is_prismatic() ? mass : mass * leg.length_m * leg.length_m;
  const double inertia = share + RotorInertiaAt(model, dof);
  return FromInertia(inertia, options.stance_frequency * std::sqrt(kGravity / leg.length_m), options.stance_damping);
}

}  // namespace

Gains DeriveGains(const RobotModel& model, const GainOptions& options) {
  GainOptions checked = options;
  CheckOptions(checked.Fields());
  DynamicsScratch scratch(model);
  MatrixX M = MatrixX::Zero(model.nv(), model.nv());
  MassMatrix(model, StandingConfiguration(model), scratch, M);
  AddRotorInertia(model, M);
  const MatrixX mobility = M.inverse().bottomRightCorner(model.num_dofs(), model.num_dofs());
  const std::vector<int> leg_of = LegsOfDofs(model);

  Gains gains{VectorX::Zero(model.num_dofs()), VectorX::Zero(model.num_dofs())};
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const auto d = static_cast<std::size_t>(dof);
    const double inertia = 1.0 / mobility(dof, dof);
    Gain gain = FromInertia(inertia, options.free_frequency_rad_s, options.free_damping);
    if (leg_of[d] >= 0) {
      gain = LegGain(model, model.legs[static_cast<std::size_t>(leg_of[d])], dof, options);
    } else if (!model.legs.empty()) {
      const Gain leg = LegGain(model, model.legs.front(), dof, options);
      gain = {std::min(gain.stiffness, leg.stiffness), std::min(gain.damping, leg.damping)};
    }
    if (model.stiffness[dof] > 0.0) gain.stiffness = model.stiffness[dof];
    if (model.damping[dof] > 0.0) gain.damping = model.damping[dof];
    gain = {options.stiffness_scale * gain.stiffness, options.damping_scale * gain.damping};
    if (options.explicit_step_s > 0.0) {
      const double h = options.explicit_step_s, coupled = 1.0 / mobility.row(dof).lpNorm<1>();
      gain.damping = std::min(gain.damping, 0.5 * coupled / h);
      gain.stiffness = std::min(gain.stiffness, 0.25 * coupled / (h * h));
    }
    gains.stiffness[dof] = gain.stiffness;
    gains.damping[dof] = gain.damping;
  }
  return gains;
}

}  // namespace gaitwright
