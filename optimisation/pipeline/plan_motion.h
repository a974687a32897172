// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/centre_of_mass.h"
#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/centroidal/timing_options.h"
#include "optimisation/swing/plan_swings.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/footsteps/plan_sequence.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Tuning
///   multibody ZMP too far from its reference    more max_passes
///   knees too straight or too bent              give com_height_m
struct PipelineOptions {
  double grid_step_s = 0.005;
  int max_passes = 6;
  int max_body_passes = 12;
  double zmp_tolerance_m = 0.001;
  double zmp_inward = 0.08;
  static constexpr double kMostInward = 0.4;
  double com_height_m = 0.0;
  bool end_as_standing = false;
  bool allow_limits = false;

  OptionFields Fields() {
    return WithBasics(
        {"grid_step_s", "com_height_m", "zmp_inward", "allow_limits"},
        {{"grid_step_s", &grid_step_s, "s", 0.001, 0.01, "Time step of the plan's uniform grid."},
         {"max_passes", &max_passes, "1", 1.0, 20.0,
          "Maximum number of passes that correct the multibody ZMP; up to twice as many while the error still falls "
          "and would fail the audit."},
         {"max_body_passes", &max_body_passes, "1", 1.0, 50.0,
          "Maximum number of passes that alternate between the rigid-body plan and the leg motions; one is usual, and "
          "more are made over uneven ground or for clearance."},
         {"zmp_tolerance_m", &zmp_tolerance_m, "m", 1e-6, 0.1,
          "Largest distance between the multibody ZMP and its reference at which the passes end."},
         {"com_height_m", &com_height_m, "m", 0.0, 5.0,
          "Height of the centre of mass above the ground; 0 uses the standing height, lowered if the legs or flights "
          "need it."},
         {"zmp_inward", &zmp_inward, "1", 0.0, kMostInward,
          "Inward offset of the preferred ZMP in single support, as a share of the sole's width; doubled if joints "
          "would exceed their limits."},
         {"end_as_standing", &end_as_standing, "1", 0.0, 1.0,
          "Places the last footholds so that rolling feet end in the standing posture, ready for a following motion. "
          "Applies to pendulum plans that end on level ground."},
         {"allow_limits", &allow_limits, "1", 0.0, 1.0,
          "Returns a plan that exceeds limits or fails its audit, with warnings, for inspection."}});
  }
};

/// Whole-body trajectory optimisation of a plan (FinishMotion).
///
/// Tuning
///   the motion strays far from the plan        raise near
///   motors are near their limits               raise effort, timing=optimised, footholds=free
///   the motion costs too much energy           raise power, timing=optimised
///   feet slip between knots of a fast motion   lower knot_step_s
struct TrajectoryOptions {
  std::string method = "as-needed";
  double knot_step_s = 0.01;
  double residual = 1e-3;
  int max_solves = 6;
  int max_iterations = 60;
  double near = 1.0;
  double effort = 0.3;
  double power = 0.0;
  std::string timing = "fixed";
  double most_change = 0.25;
  std::string footholds = "fixed";
  double most_shift_m = 0.05;
  std::string swings = "as-needed";
  double clearance_m = 0.0;
  double heel_off_rad = 0.0;
  double heel_off_share = 1.0;
  double self_distance_m = 0.004;
  std::string cycles = "free";

  /// Whether each plan is finished by the optimisation of the whole body.
  bool finishes_all() const { return method == "whole-body" || cycles == "periodic"; }

  OptionFields Fields();
  /// The fields that FollowMotion uses: knots, residual, bounds of solves and distance of links.
  OptionFields FollowFields();
};

/// All options that shape a motion. The same keys are used in YAML, in `--set` and in the plan's provenance.
///
/// Tuning
///   motors near their limits, or hot, in a gait with flight         timing=optimised
///   a gait with flight has no plan over stones, slopes or steps     footholds=free
///   motors of legs near their limits in swings                      trajectory.swings=free
struct MotionOptions {
  FootstepOptions footsteps;
  CentreOfMassOptions centre_of_mass;
  RigidBodyOptions rigid_body = {.method = "ceres", .swing_lead_s = 0.02, .tolerance = 1e-3, .max_refinements = 0};
  std::string footholds = "as-needed";
  std::string timing = "fixed";
  TimingOptions timing_bounds;
  SwingOptions swing;
  WholeBodyOptions whole_body;
  TrajectoryOptions trajectory;
  PipelineOptions pipeline;

  OptionFields Fields() {
    return Joined({Prefixed("footsteps", footsteps.Fields()), Prefixed("centre_of_mass", centre_of_mass.Fields()),
                   Prefixed("rigid_body", rigid_body.Fields()), ContactFields(), Prefixed("swing", swing.Fields()),
                   Prefixed("whole_body", whole_body.Fields()), Prefixed("trajectory", trajectory.Fields()),
                   Prefixed("pipeline", pipeline.Fields())});
  }

 private:
  OptionFields ContactFields() {
    return Joined(
        {{{"footholds",
           &footholds,
           "",
           0.0,
           0.0,
           "Rigid-body gaits on uneven ground: 'held' fixes the footholds, 'free' moves them on and between patches, "
           "'as-needed' frees them if no held plan passes its audit.",
           {"held", "as-needed", "free"}},
          {"timing",
           &timing,
           "",
           0.0,
           0.0,
           "Contact times of rigid-body gaits: 'fixed' keeps those of the gait, 'optimised' finds times "
           "within the cycle that need less torque.",
           {"fixed", "optimised"}}},
         Prefixed("timing", timing_bounds.PhaseFields())});
  }
};

/// How the whole-body trajectory optimisation finished a plan.
struct FinishReport {
  int knots = 0, variables = 0, solves = 0;
  int iterations = 0;            ///< of all solves
  double solve_cpu_s = 0.0;      ///< in these
  double residual_force = 0.0;   ///< at 1 kHz, over the weight
  double residual_moment = 0.0;  ///< at 1 kHz, over the weight times the leg's length
  double residual_at_s = 0.0;
  bool keeps_room = true;               ///< limits keep the room that controllers need for corrections
  double effort_use = 0.0;              ///< largest share of a motor's effort limit
  int cycles = 0;                       ///< that repeat exactly, with `cycles` periodic
  std::vector<std::string> apart = {};  ///< pairs of links that would touch otherwise
  std::string summary;                  ///< one line
};

/// A plan with results of the planner.
struct PlannedMotion {
  MotionPlan plan;
  int passes = 0;                ///< of the ZMP correction or of the rigid body
  double zmp_error_max_m = 0.0;  ///< pendulum: largest distance of the multibody ZMP from its reference
  double residual = 0.0;         ///< rigid body, whole body: unbalanced force / (m g) [1] or moment / (m g) [m]
  double limit_violation = 0.0;  ///< violation of joint limits, summed in shares of the limits
  std::string summary;           ///< one line
  std::optional<FinishReport> finished = {};  ///< whole body
  std::optional<Failure> unfinished = {};     ///< why the motion of the passes, then the plan, could not be finished
};

/// Origin of a plan with these options.
Provenance ProvenanceOf(MotionOptions options);

/// Options of the footsteps for a motion, on its grid. With preview control the plan stands one preview horizon longer
/// at both ends, so that it starts and ends at rest.
FootstepOptions StandingOptions(const MotionOptions& options);

/// Plans a complete motion from a command: footsteps, centre of mass, swings, whole body. After each pass, the
/// multibody ZMP from inverse dynamics corrects the pendulum of the next pass, until it agrees with its reference. Once
/// the rolling of the feet has converged, a pass that does not improve the result is dropped. A plan that violates
/// joint limits is returned with warnings; its passes end early unless pipeline.allow_limits is set. PlanWalk refuses
/// such a plan. With footholds "as-needed" the footholds are held; PlanWalk also frees them.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                 const WalkCommand& command, const MotionOptions& options);

/// PlanMotion for several consecutive parts (PlanSequence), in one motion without seams. If one part needs the motion
/// of a rigid body, all parts are planned in that way.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options);

/// PlanMotion over given footholds, times and base path, for example from another planner; options.timing is ignored.
/// @param cycle_s  time in which every foot steps about once; the body's height and tilt are smoothed over it.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const FootstepSkeleton& skeleton,
                                 double cycle_s, const MotionOptions& options);

}  // namespace gaitwright
