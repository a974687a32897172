// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"

namespace gaitwright {

/// Tuning
///   sways and does not settle      lower attitude_rad_s or dcm_gain
///   turns away from its heading    raise attitude_rad_s
///   falls sideways after a push    raise step_gain; the feet land too near to the fall
///   steps about without a push     lower step_gain
///   feet touch down early          raise hover
///   standing feet slide            raise stance_damping
///   trembles with noisy sensors    lower sensed_damping, raise stance_creep
struct StabilisedOptions {
  double attitude_rad_s = 10.0;
  double height_rad_s = 10.0;
  double dcm_gain = 1.3;
  double step_gain = 1.0;
  double step_decay = 0.2;
  double step_reach = 0.3;
  double support_use = 0.95;
  double friction_use = 0.9;
  double torque_use = 0.9;
  double swing_stiffness = 1.0;
  double swing_acceleration_m_s2 = 60.0;
  double stance_damping = 1.0;
  double sensed_damping = 0.2;
  double stance_creep = 0.02;
  double settle_s = 0.03;
  double hover = 0.004;
  double search_m_s = 0.6;
  double ahead_error = 0.1;
  double ahead_turn_rad = 0.1;
  double ahead_step = 0.1;

  OptionFields Fields() {
    return WithBasics(
        {"attitude_rad_s", "dcm_gain", "step_gain", "friction_use"},
        {
            {"attitude_rad_s", &attitude_rad_s, "rad/s", 0.0, 50.0,
             "Natural frequency of the attitude controller of the base, critically damped."},
            {"height_rad_s", &height_rad_s, "rad/s", 0.0, 50.0,
             "Natural frequency of the height controller of the centre of mass, critically damped."},
            {"dcm_gain", &dcm_gain, "1", 1.0, 10.0,
             "Gain from the DCM error to the shift of the ZMP, within the support; values above 1 converge."},
            {"step_gain", &step_gain, "1", 0.0, 2.0,
             "Gain of the foothold shift that reduces the DCM error to the share step_decay over the next step; 0 "
             "shifts no foothold."},
            {"swing_stiffness", &swing_stiffness, "1", 1.0, 50.0,
             "Factor on the joint stiffness of a swing leg; its damping is multiplied by the square root."},
            {"step_decay", &step_decay, "1", 0.0, 1.0,
             "Share of a DCM error that remains one step later; 0 removes the error, 1 keeps it."},
            {"step_reach", &step_reach, "1", 0.0, 1.0,
             "Largest shift of a foothold relative to the base, as a share of the leg length."},
            {"swing_acceleration_m_s2", &swing_acceleration_m_s2, "m/s^2", 1.0, 1000.0,
             "Largest acceleration of a swing foot towards a shifted foothold."},
            {"stance_damping", &stance_damping, "1", 0.0, 1.0,
             "Factor on the joint damping of a stance leg; this damping keeps the foot from sliding."},
            {"sensed_damping", &sensed_damping, "1", 0.0, 1.0,
             "Additional factor on stance-leg damping if the state comes from sensors, because measured speeds are "
             "noisy."},
            {"stance_creep", &stance_creep, "1", 0.0, 1.0,
             "Speed of a stance foot below which its motion counts as noise and is not damped, in units of sqrt(g x "
             "leg length)."},
            {"torque_use", &torque_use, "1", 0.1, 1.0,
             "Share of an ankle's effort limit that shifting the ZMP may use."},
            {"settle_s", &settle_s, "s", 0.001, 0.2,
             "Time before touch-down during which the foothold is no longer shifted and the foot is lowered."},
            {"hover", &hover, "1", 0.0, 0.1,
             "Height of a swing foot above its plan until it settles, as a share of the leg length, which avoids early "
             "touch-down."},
            {"search_m_s", &search_m_s, "m/s", 0.0, 2.0,
             "Downward speed of a foot that should be on the ground but has no contact."},
            {"support_use", &support_use, "1", 0.0, 1.0,
             "Share of the distance from the planned ZMP to the support's edge that the ZMP may shift; below 1, every "
             "foot stays loaded."},
            {"friction_use", &friction_use, "1", 0.1, 1.0,
             "Share of the friction coefficient that the commanded contact forces may use."},
            {"ahead_error", &ahead_error, "1", 0.001, 100.0,
             "In plans with flight: position error [leg lengths] or velocity error [sqrt(g x leg length)] that costs "
             "as much as changing each contact force by its planned load."},
            {"ahead_turn_rad", &ahead_turn_rad, "rad", 0.001, 100.0,
             "In plans with flight: attitude error, or rate error [sqrt(g / leg length)], that costs as much as "
             "changing each contact force by its planned load."},
            {"ahead_step", &ahead_step, "1", 0.001, 100.0,
             "In plans with flight: foothold shift [leg lengths] that costs as much as changing each contact force by "
             "its planned load; larger values shift footholds more."},
        });
  }
};

/// Feed-forward and PD replay with feedback of base attitude, height and DCM through the stance feet, and footholds
/// moved to where the DCM can be caught.
///
///   attitude, height:  M = I (k^2 e_R + 2 k e_w),  F_z = m (k^2 e_z + 2 k e_vz)
///   DCM:               the ZMP is moved by dcm_gain times the error xi - xi_planned, as a horizontal force on C
///   ground:            a plane through the contact points of the soles gives height and slope of the ground for the
///                      next foothold; the base stays upright
///   split:             planned wrench plus feedback over the feet in stance, inside their cones;
///                      tau -= J^T (f - f_planned)
///   soles:             turn onto the ground that they find: ankles have almost no damping
///   standing legs:     tau += M J^+ a, the torque for their inertia under the vertical acceleration beyond the plan's
///   foot placement:    the DCM error predicted for touch-down, e^{w t} (dxi - dp) + dp, is corrected by a foothold
///                      shift of (e^{w T} - lambda) / (e^{w T} - 1) times it, T the next stance plus the flight after
///                      it.
///   plans with flights: wrench and foot placement by the feedback of MomentumGains instead
/// Englsberger et al., T-RO 31(2), 2015; Pratt et al., Virtual Model Control, IJRR 20(2), 2001;
/// Khadiv et al., Walking control based on step timing adaptation, T-RO 36(3), 2020.
/// @param gains  of the joints, as for JointPd.
/// @throws InvalidArgument for an option out of its range, or a plan without motion of this robot's size, torques,
/// contact forces or contact schedule. Model and plan must outlive the controller.
std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan,
                                           const StabilisedOptions& options, const GainOptions& gains = {});

}  // namespace gaitwright
