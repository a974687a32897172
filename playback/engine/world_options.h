// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The physics of a playback, and what is unlike the plan.
///
/// Tuning
///   slow                              fewer solver_iterations; locked_dofs; a larger step_s
///   feet sink in                      lower contact_cfm
///   contact forces rattle at rest     raise contact_cfm tenfold
///   is it the motors or the plan?     joint_losses, motor_curve, thermal_limit off, one at a time
struct WorldOptions {
  std::string engine = "bullet";
  double step_s = 0.001;
  int solver_iterations = 50;
  double contact_cfm = 1e-5;
  std::string actuation = "implicit-pd";
  std::string sole_contact = "auto";
  double friction = 0.0;
  double mass_scale = 1.0;
  double inertia_scale = 1.0;
  double com_shift_x_m = 0.0, com_shift_y_m = 0.0, com_shift_z_m = 0.0;
  double motor_strength = 1.0;
  double ground_slope_deg = 0.0;
  double ground_slope_direction_deg = 0.0;
  double ground_bumps_m = 0.0;
  double bump_wavelength_m = 0.4;
  double bump_free_radius_m = 0.0;
  int seed = 0;
  bool joint_losses = true;
  bool motor_curve = true;
  bool thermal_limit = true;
  double joint_friction_nm = 0.0;
  double rotor_inertia_kg_m2 = 0.0;
  double torque_scale = 1.0;

  /// Independent joints that are held at their first position without a motor, as if welded.
  std::vector<int> locked_dofs = {};
  /// Bumps reach this far in plan view [m]; beyond there is no bumpy ground. Play takes it from the plan.
  Vector2 bumps_from_W = Vector2(-5.0, -5.0), bumps_to_W = Vector2(5.0, 5.0);

  /// All of them, by name.
  OptionFields Fields() { return Joined({PhysicsFields(), ActuatorFields()}); }

  /// Those of the time step, the contacts and the ground.
  OptionFields PhysicsFields() {
    return {
        {"engine", &engine, "", 0.0, 0.0, "Physics engine: bullet or mujoco.", {"bullet", "mujoco"}},
        {"step_s", &step_s, "s", 1e-5, 0.01, "Time step.", {}},
        {"solver_iterations", &solver_iterations, "1", 1, 10000, "Iterations of the contact solver per step.", {}},
        {"contact_cfm",
         &contact_cfm,
         "m/(N s)",
         0.0,
         1.0,
         "Softness of a contact over the time step; a foot sinks in by cfm times force times step over 0.2.",
         {}},
        {"actuation",
         &actuation,
         "",
         0.0,
         0.0,
         "implicit-pd: stable for every gain; torque: feed-forward plus PD of the state at the start of the step, with "
         "gains that must know the step.",
         {"implicit-pd", "torque"}},
        {"sole_contact",
         &sole_contact,
         "",
         0.0,
         0.0,
         "What of a sole touches: spheres of 2 mm at its corners, or its whole plate too, for edges under it; auto: "
         "the "
         "plate where the ground has edges, and spheres all over it on height fields.",
         {"auto", "corners", "plate"}},
        {"friction", &friction, "1", 0.0, 10.0, "Coefficient everywhere; 0 for the terrain's own.", {}},
        {"mass_scale", &mass_scale, "1", 0.1, 10.0, "Factor on all masses and inertias, unknown to the plan.", {}},
        {"inertia_scale", &inertia_scale, "1", 0.1, 10.0, "Factor on all moments of inertia besides, likewise.", {}},
        {"com_shift_x_m", &com_shift_x_m, "m", -1.0, 1.0, "Moves the base's own centre of mass ahead, likewise.", {}},
        {"com_shift_y_m", &com_shift_y_m, "m", -1.0, 1.0, "The same, to the left.", {}},
        {"com_shift_z_m", &com_shift_z_m, "m", -1.0, 1.0, "The same, upward.", {}},
        {"motor_strength", &motor_strength, "1", 0.01, 10.0, "Factor on the effort limits of all joints.", {}},
        {"ground_slope_deg",
         &ground_slope_deg,
         "deg",
         -45.0,
         45.0,
         "The whole ground turned about a level axis through the start point, unknown to the plan; positive is uphill "
         "ahead, or in ground_slope_direction_deg.",
         {}},
        {"ground_slope_direction_deg",
         &ground_slope_direction_deg,
         "deg",
         -360.0,
         360.0,
         "Where that slope goes uphill: 0 is the x axis, 90 the y axis.",
         {}},
        {"ground_bumps_m",
         &ground_bumps_m,
         "m",
         0.0,
         0.5,
         "Amplitude of bumps unknown to the plan: heights between minus and plus this, zero under the start.",
         {}},
        {"bump_wavelength_m",
         &bump_wavelength_m,
         "m",
         0.02,
         10.0,
         "Twice the distance between neighbouring bumps.",
         {}},
        {"bump_free_radius_m",
         &bump_free_radius_m,
         "m",
         0.0,
         10.0,
         "Level ground about the start point, before bumps rise over half a wavelength; 0 takes in the feet at the "
         "start.",
         {}},
        {"seed", &seed, "1", 0, 2147483647, "Of the bumps.", {}}};
  }

  /// Those of the motors and joints.
  OptionFields ActuatorFields() {
    return {
        {"joint_losses",
         &joint_losses,
         "",
         0.0,
         0.0,
         "Whether the robot's joint damping, dry friction and rotor inertia act: true or false.",
         {}},
        {"motor_curve", &motor_curve, "", 0.0, 0.0, "Whether its torque-speed curves do.", {}},
        {"thermal_limit",
         &thermal_limit,
         "",
         0.0,
         0.0,
         "Whether its motors are held to their continuous effort once they are warm.",
         {}},
        {"joint_friction_nm",
         &joint_friction_nm,
         "N m",
         0.0,
         1000.0,
         "Dry friction added to every joint with a motor, unknown to the controller; N for one that slides.",
         {}},
        {"rotor_inertia_kg_m2",
         &rotor_inertia_kg_m2,
         "kg m^2",
         0.0,
         100.0,
         "Rotor inertia added to every motor as felt at its joint, likewise; kg for one that slides.",
         {}},
        {"torque_scale", &torque_scale, "1", 0.01, 2.0, "Share of each motor's torque that reaches its joint.", {}}};
  }
};

}  // namespace gaitwright
