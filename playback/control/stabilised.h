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
  double lean_s = 0.2;
  double ahead_error = 0.1;
  double ahead_turn_rad = 0.1;
  double ahead_step = 0.1;

  OptionFields Fields() {
    return {
        {"attitude_rad_s",
         &attitude_rad_s,
         "rad/s",
         0.0,
         50.0,
         "Natural frequency of the base attitude, held critically damped through the stance feet.",
         {}},
        {"height_rad_s",
         &height_rad_s,
         "rad/s",
         0.0,
         50.0,
         "Natural frequency of the height of the centre of mass, likewise.",
         {}},
        {"dcm_gain",
         &dcm_gain,
         "1",
         1.0,
         10.0,
         "The ZMP is moved by this many times the error of the DCM, as far as the support allows; above 1 it "
         "converges.",
         {}},
        {"step_gain",
         &step_gain,
         "1",
         0.0,
         2.0,
         "Share of the foot placement that brings the DCM error to step_decay over the next step.",
         {}},
        {"swing_stiffness",
         &swing_stiffness,
         "1",
         1.0,
         50.0,
         "Factor on the stiffness of a leg in its swing; its damping rises with the square root.",
         {}},
        {"step_decay",
         &step_decay,
         "1",
         0.0,
         1.0,
         "What is to be left of a DCM error one step later; 1 keeps the displaced gait where it is.",
         {}},
        {"step_reach",
         &step_reach,
         "1",
         0.0,
         1.0,
         "Farthest that a foothold is moved against the base, as a share of the leg length.",
         {}},
        {"swing_acceleration_m_s2",
         &swing_acceleration_m_s2,
         "m/s^2",
         1.0,
         1000.0,
         "Most that a swing is accelerated on its way to a moved foothold.",
         {}},
        {"stance_damping",
         &stance_damping,
         "1",
         0.0,
         1.0,
         "Factor on the damping of a leg that stands, which keeps its foot from sliding.",
         {}},
        {"sensed_damping",
         &sensed_damping,
         "1",
         0.0,
         1.0,
         "A further factor where the state is sensed: speeds from sensors are noisy, and what damps them trembles.",
         {}},
        {"stance_creep",
         &stance_creep,
         "1",
         0.0,
         1.0,
         "Speed below which a standing foot is not held: what is measured of it is mostly noise; unit sqrt(g leg).",
         {}},
        {"torque_use", &torque_use, "1", 0.1, 1.0, "Share of an ankle's effort limit that moving the ZMP may use.", {}},
        {"settle_s",
         &settle_s,
         "s",
         0.001,
         0.2,
         "Last part of a swing in which its foothold is no longer moved, and it comes down onto it.",
         {}},
        {"hover",
         &hover,
         "1",
         0.0,
         0.1,
         "How far above its plan a swing stays until it settles, as a share of the leg length, so that it does not "
         "touch the ground before its time.",
         {}},
        {"search_m_s",
         &search_m_s,
         "m/s",
         0.0,
         2.0,
         "Speed downwards of a foot that is due on the ground and has not found it.",
         {}},
        {"support_use",
         &support_use,
         "1",
         0.0,
         1.0,
         "How far from the planned ZMP to the edge of the support the ZMP may be moved; below 1 no foot is unloaded.",
         {}},
        {"friction_use",
         &friction_use,
         "1",
         0.1,
         1.0,
         "Share of the ground's friction that the contact forces asked for may use.",
         {}},
        {"lean_s",
         &lean_s,
         "s",
         0.01,
         100.0,
         "Time in which the base leans with soles that stand on ground inclined against the plan.",
         {}},
        {"ahead_error",
         &ahead_error,
         "1",
         0.001,
         100.0,
         "In plans with flights, the error of place, in leg lengths, or of speed, in sqrt(g leg), that is worth "
         "changing "
         "all contact forces by their whole load.",
         {}},
        {"ahead_turn_rad",
         &ahead_turn_rad,
         "rad",
         0.001,
         100.0,
         "The same of the base's attitude, and of its turning by sqrt(g / leg).",
         {}},
        {"ahead_step",
         &ahead_step,
         "1",
         0.001,
         100.0,
         "The same of a foothold's distance from the body, in leg lengths.",
         {}},
    };
  }
};

/// Feed-forward and PD replay with feedback of base attitude, height and DCM through the stance feet, and footholds
/// moved to where the DCM can be caught.
///
///   attitude, height:  M = I (k^2 e_R + 2 k e_w),  F_z = m (k^2 e_z + 2 k e_vz)
///   DCM:               the ZMP is moved by dcm_gain times the error xi - xi_planned, as a horizontal force on C
///   lean:              soles that stand tell the ground's tilt; the base leans with it, so that swings meet the ground
///   split:             planned wrench plus feedback over the feet in stance, inside their cones;
///                      tau -= J^T (f - f_planned)
///   standing legs:     tau += M J^+ a, what their inertia takes for the vertical acceleration asked for beyond the
///                      plan's
///   foot placement:    the error that the DCM will have at touch-down, e^{w t} (dxi - dp) + dp, is met by a foothold
///                      moved by (e^{w T} - lambda) / (e^{w T} - 1) of it, T the stance to come with the flight after
///                      it.
///   plans with flights: wrench and foot placement by the feedback of MomentumGains instead
/// Englsberger et al., T-RO 31(2), 2015; Pratt et al., Virtual Model Control, IJRR 20(2), 2001;
/// Khadiv et al., Walking control based on step timing adaptation, T-RO 36(3), 2020.
/// @param gains  of the joints, as for JointPd.
/// @throws InvalidArgument for an option out of its range, or a plan without motion of this robot's size, without its
/// torques and contact forces, or without contact schedule. Model and plan must outlive it.
std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan,
                                           const StabilisedOptions& options, const GainOptions& gains = {});

}  // namespace gaitwright
