// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Physics of a playback, and its differences from the plan.
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
  double contact_softness = 1.0;
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

  /// Independent joints that stay at their first position without a motor, as if welded.
  std::vector<int> locked_dofs = {};
  /// Extent of the bumps in plan view [m]; outside there are no bumps. Play sets it from the plan.
  Vector2 bumps_from_W = Vector2(-5.0, -5.0), bumps_to_W = Vector2(5.0, 5.0);

  /// ControlInput::lead_steps of this actuation.
  double lead_steps() const { return actuation == "torque" ? 0.0 : 1.0; }

  /// All options, by name.
  OptionFields Fields() { return Joined({PhysicsFields(), ActuatorFields()}); }

  /// Options of the time step, the contacts and the ground.
  OptionFields PhysicsFields() {
    return WithBasics(
        {"engine", "step_s", "actuation", "friction", "mass_scale", "motor_strength", "ground_slope_deg",
         "ground_slope_direction_deg", "ground_bumps_m", "bump_wavelength_m", "seed"},
        {{"engine",
          &engine,
          "",
          0.0,
          0.0,
          "Physics engine that plays the plan; both plays in each, and passes if both pass.",
          {"bullet", "mujoco", "both"}},
         {"step_s", &step_s, "s", 1e-5, 0.01, "Time step of the physics."},
         {"solver_iterations", &solver_iterations, "1", 1, 10000,
          "Iterations of the contact solver in each time step."},
         {"contact_softness", &contact_softness, "1", 0.01, 1000.0,
          "Factor on the compliance of all contacts; the depth to which a foot at rest sinks in is proportional to "
          "it."},
         {"contact_cfm", &contact_cfm, "m/(N s)", 0.0, 1.0,
          "Contact softness divided by the time step (CFM); a foot sinks in by CFM x force x step / 0.2."},
         {"actuation",
          &actuation,
          "",
          0.0,
          0.0,
          "Joint drive: implicit-pd is stable for every gain; torque adds explicit PD, whose gains must suit the time "
          "step, to feed-forward.",
          {"implicit-pd", "torque"}},
         {"sole_contact",
          &sole_contact,
          "",
          0.0,
          0.0,
          "Contact shape of a sole: 2 mm spheres at its corners, or also its plate; auto chooses by the ground.",
          {"auto", "corners", "plate"}},
         {"friction", &friction, "1", 0.0, 10.0,
          "Friction coefficient of the whole ground; 0 uses the terrain's coefficients."},
         {"mass_scale", &mass_scale, "1", 0.1, 10.0,
          "Factor on all masses and inertias, which the plan does not know."},
         {"inertia_scale", &inertia_scale, "1", 0.1, 10.0,
          "Additional factor on all moments of inertia, which the plan does not know."},
         {"com_shift_x_m", &com_shift_x_m, "m", -1.0, 1.0,
          "Forward shift of the base link's centre of mass, which the plan does not know."},
         {"com_shift_y_m", &com_shift_y_m, "m", -1.0, 1.0,
          "Shift of the base link's centre of mass to the left, which the plan does not know."},
         {"com_shift_z_m", &com_shift_z_m, "m", -1.0, 1.0,
          "Upward shift of the base link's centre of mass, which the plan does not know."},
         {"motor_strength", &motor_strength, "1", 0.01, 10.0, "Factor on the effort limits of all joints."},
         {"ground_slope_deg", &ground_slope_deg, "deg", -45.0, 45.0,
          "Slope of the whole ground about the start point, which the plan does not know; positive rises in "
          "ground_slope_direction_deg."},
         {"ground_slope_direction_deg", &ground_slope_direction_deg, "deg", -360.0, 360.0,
          "Uphill direction of ground_slope_deg: 0 is the x axis, 90 the y axis."},
         {"ground_bumps_m", &ground_bumps_m, "m", 0.0, 0.5,
          "Amplitude of ground bumps that the plan does not know: heights lie within +- this value and are zero at the "
          "start."},
         {"bump_wavelength_m", &bump_wavelength_m, "m", 0.02, 10.0,
          "Wavelength of the ground bumps: twice the distance between neighbouring bumps."},
         {"bump_free_radius_m", &bump_free_radius_m, "m", 0.0, 10.0,
          "Radius of level ground around the start, before bumps rise over half a wavelength; 0 uses the extent of the "
          "feet."},
         {"seed", &seed, "1", 0, 2147483647, "Random seed of the ground bumps."}});
  }

  /// Options of the motors and joints.
  OptionFields ActuatorFields() {
    return WithBasics(
        {"joint_losses", "motor_curve", "thermal_limit"},
        {{"joint_losses", &joint_losses, "", 0.0, 0.0, "Simulates joint damping, dry friction and rotor inertia."},
         {"motor_curve", &motor_curve, "", 0.0, 0.0, "Limits motor torque by the torque-speed curves."},
         {"thermal_limit", &thermal_limit, "", 0.0, 0.0, "Limits warm motors to their continuous torque."},
         {"joint_friction_nm", &joint_friction_nm, "N m", 0.0, 1000.0,
          "Dry friction added to every motorised joint, which the controller does not know; in N for prismatic "
          "joints."},
         {"rotor_inertia_kg_m2", &rotor_inertia_kg_m2, "kg m^2", 0.0, 100.0,
          "Reflected rotor inertia added to every motorised joint, which the controller does not know; in kg for "
          "prismatic joints."},
         {"torque_scale", &torque_scale, "1", 0.01, 2.0, "Share of each motor's torque that reaches its joint."}});
  }
};

}  // namespace gaitwright
