// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
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
  double residual = 3e-4;
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
          "Maximum number of passes that alternate between the rigid-body plan and the leg motions."},
         {"zmp_tolerance_m", &zmp_tolerance_m, "m", 1e-6, 0.1,
          "Largest distance between the multibody ZMP and its reference at which the passes end."},
         {"residual", &residual, "1", 1e-6, 0.02,
          "Largest unbalanced force (and moment, in metres) divided by the weight at which the rigid-body passes end."},
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

/// Every option that shapes a motion; the same keys serve YAML, `--set` and the plan's provenance.
///
/// Tuning
///   motors are near their limits, or warm, in a gait with flight    timing=optimised
///   such a gait has no plan over stones, slopes or steps            footholds=free
struct MotionOptions {
  FootstepOptions footsteps;
  CentreOfMassOptions centre_of_mass;
  RigidBodyOptions rigid_body = {.method = "ceres", .swing_lead_s = 0.02};
  std::string footholds = "held";
  std::string timing = "fixed";
  TimingOptions timing_bounds;
  SwingOptions swing;
  WholeBodyOptions whole_body;
  PipelineOptions pipeline;

  OptionFields Fields() {
    return Joined({Prefixed("footsteps", footsteps.Fields()), Prefixed("centre_of_mass", centre_of_mass.Fields()),
                   Prefixed("rigid_body", rigid_body.Fields()), ContactFields(), Prefixed("swing", swing.Fields()),
                   Prefixed("whole_body", whole_body.Fields()), Prefixed("pipeline", pipeline.Fields())});
  }

 private:
  OptionFields ContactFields() {
    return Joined({{{"footholds",
                     &footholds,
                     "",
                     0.0,
                     0.0,
                     "Footholds of rigid-body gaits on uneven ground: 'held' keeps those of the search, 'free' also "
                     "moves them on their patches; feet with soles are held.",
                     {"held", "free"}},
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

/// A plan and how it came about.
struct PlannedMotion {
  MotionPlan plan;
  int passes = 0;                ///< of the ZMP correction
  double zmp_error_max_m = 0.0;  ///< multibody ZMP against its reference, worst; of a pendulum's motion
  double residual = 0.0;         ///< what contacts do not give over m g [1], [m]; of a rigid body's motion
  double limit_excess = 0.0;     ///< past limits of joints, summed in shares of the limits
  std::string summary;           ///< one line
};

/// How a plan came about.
Provenance ProvenanceOf(MotionOptions options);

/// Options of the footsteps for a motion, on its grid. With preview control the plan stands one preview longer at both
/// ends, so that it starts and ends at rest.
FootstepOptions StandingOptions(const MotionOptions& options);

/// From a command to a whole motion: footsteps, centre of mass, swings, whole body. The multibody ZMP of each pass,
/// from its own inverse dynamics, corrects the pendulum of the next until it agrees with its reference; once the feet
/// roll as they were taken to, a pass that does not help is dropped. A plan past limits of joints is given with
/// warnings, its passes cut short unless pipeline.allow_limits is set; PlanWalk refuses it.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                 const WalkCommand& command, const MotionOptions& options);

/// The same of several parts one after the other (PlanSequence), in one motion without seams: where one of them takes
/// the motion of a rigid body, the whole is planned so.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options);

/// The same over footholds, times and a way of the base that are settled already, as where others planned them;
/// options.timing does nothing here.
/// @param cycle_s  time in which every foot steps about once; the body's height and tilt are evened out over it.
Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const FootstepSkeleton& skeleton,
                                 double cycle_s, const MotionOptions& options);

}  // namespace gaitwright
