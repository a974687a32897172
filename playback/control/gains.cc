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

/// Rate at which gravity turns a joint further out of the standing posture, per angle [N m/rad]: the sum of
///   m g z . r_across
/// over the bodies beyond the joint. r_across is the part of r, from the joint to a body's centre, that is
/// perpendicular to the joint's axis, since r'' = -r_across for a turn about the axis. Not positive for hanging bodies.
/// @param scratch  of the standing posture.
double GravityTurns(const RobotModel& model, const DynamicsScratch& scratch, int dof) {
  double turns = 0.0;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.dof != dof || joint.is_prismatic()) continue;
    const Vector3 axis_W = scratch.R_WB[j + 1] * joint.axis_J;
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (!Carries(model, static_cast<int>(j) + 1, static_cast<int>(b))) continue;
      const Vector3 r = scratch.p_WB[b] + scratch.R_WB[b] * model.bodies[b].p_BC - scratch.p_WB[j + 1];
      const Vector3 across = r - axis_W.dot(r) * axis_W;
      turns += joint.multiplier * joint.multiplier * model.bodies[b].mass * kGravity * across.z();
    }
  }
  return turns;
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
    constexpr double kUpright = 4.0;  // times gravity's rate, because several joints may follow each other
    const double upright = kUpright * GravityTurns(model, scratch, dof) / std::pow(options.free_frequency_rad_s, 2);
    const double inertia = std::max(1.0 / mobility(dof, dof), upright);
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
