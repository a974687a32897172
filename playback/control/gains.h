// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Tuning
///   sags, sways or drifts from the plan under load    raise stance_frequency
///   stamps; contact forces ring at touch-down         lower stance_frequency or raise stance_damping
///   swing legs or arms ring                           raise stance_damping, free_damping
///   explicit torque control is unstable at lift-off   set explicit_step_s
///   overshoots where joints turn back, buzzes at rest lower loss_feed_forward or raise friction_speed_rad_s
struct GainOptions {
  double stance_frequency = 4.0;
  double stance_damping = 0.7;
  double free_frequency_rad_s = 40.0;
  double free_damping = 1.0;
  double explicit_step_s = 0.0;
  double stiffness_scale = 1.0, damping_scale = 1.0;
  double loss_feed_forward = 1.0;
  double friction_speed_rad_s = 0.1;

  OptionFields Fields() {
    return WithBasics(
        {"stance_frequency", "stance_damping", "stiffness_scale", "damping_scale"},
        {{"stance_frequency", &stance_frequency, "1", 0.1, 30.0,
          "Natural frequency of a leg joint under its share of the robot's weight, in units of sqrt(g / leg length)."},
         {"stance_damping", &stance_damping, "1", 0.0, 5.0,
          "Damping ratio of a leg joint under its share of the robot's weight."},
         {"free_frequency_rad_s", &free_frequency_rad_s, "rad/s", 1.0, 1000.0,
          "Natural frequency of a joint that belongs to no leg."},
         {"free_damping", &free_damping, "1", 0.0, 5.0, "Damping ratio of a joint that belongs to no leg."},
         {"explicit_step_s", &explicit_step_s, "s", 0.0, 0.1,
          "Time step at which gains must be stable under explicit PD; 0 uses the playback's step plus sensor delay "
          "with play.actuation=torque, else no limit."},
         {"stiffness_scale", &stiffness_scale, "1", 0.0, 100.0, "Factor on the stiffness of all joints."},
         {"damping_scale", &damping_scale, "1", 0.0, 100.0, "Factor on the damping of all joints."},
         {"loss_feed_forward", &loss_feed_forward, "1", 0.0, 1.0,
          "Share of known joint damping, dry friction and rotor inertia (from robot.yaml or URDF) that feed-forward "
          "compensates."},
         {"friction_speed_rad_s", &friction_speed_rad_s, "rad/s", 1e-4, 100.0,
          "Planned joint speed above which feed-forward compensates most dry friction; prismatic joints multiply it by "
          "the leg length."}});
  }
};

/// Stiffness and damping by independent joint.
struct Gains {
  VectorX stiffness;  ///< [N m/rad] or [N/m]
  VectorX damping;    ///< [N m s/rad] or [N s/m]
};

/// Joint gains derived from the effective inertia that each joint moves, without constants tuned for a robot.
///
///   in a leg of length L, n legs:  I = m L^2 / n, the leg's share of the robot at a leg's length,
///       kp = I w^2,  w = stance_frequency sqrt(g / L),  kd = 2 stance_damping I w;
///       for a prismatic joint m / n in place of I
///   elsewhere:  I = 1 / (M^-1)_jj in the standing posture, floating, or 4 / w^2 of gravity's pull on upright parts,
///       kp = I w^2,  w = free_frequency,  kd = 2 free_damping I w, not above the leg's gains
///   bound for explicit control with step h:  kd <= 0.5 I_j / h, kp <= 0.25 I_j / h^2,
///       I_j = 1 / lambda, the row sum of |M^-1|: Gershgorin's bound on coupled joints
/// A rotor's inertia counts with the rest: it is on the diagonal of M, and is added to a leg joint's I.
/// RobotModel::stiffness and damping take precedence where they are not zero. `stiffness_scale` and `damping_scale`
/// multiply the result, before the bound.
///
/// Feed-forward carries the weight, so the gains only correct deviations from the plan: a1 gets about 230 N m/rad and
/// 16 N m s/rad, nao 100 and 6. They are for implicit motors, which no gain makes unstable; damping this high is what
/// lets a trot, unstable about the line between two feet, settle from step to step without feedback.
/// @throws InvalidArgument for an option out of its range.
Gains DeriveGains(const RobotModel& model, const GainOptions& options = {});

}  // namespace gaitwright
