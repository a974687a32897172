// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "optimisation/centroidal/zmp_problem.h"
#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/pipeline/support_regions.h"
#include "optimisation/swing/former_motion.h"
#include "optimisation/whole_body/body_path.h"
#include "optimisation/whole_body/solve_whole_body.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// One pass of the fixed-point iteration, with the distance of its ZMP from the reference.
///
/// A pass has converged if the rolling of the feet, and the lean of the base over planar legs, equal those assumed by
/// the pass. Otherwise its footholds and swings use outdated rolls and its motion does not end correctly, so a
/// converged pass is preferred. Among unconverged passes the latest is best; among converged ones that with the
/// smallest ZMP error. A pass of a rigid body has converged if it is clear of the ground.
struct MotionPass {
  CentroidalTrajectory centroidal;
  std::vector<SwingTrajectory> swings;
  FootstepPlan footsteps;
  WholeBodySolution solution;
  double error_m = std::numeric_limits<double>::infinity();
  double violation = 0.0;  ///< beyond joint limits, summed in shares of the limits
  double outside_m =
      0.0;  ///< distance of the multibody ZMP outside supports with area; for a line support, see the error
  double lacks_m = 0.0;  ///< missing clearance of the body from the ground, if checked
  bool settled = false;

  /// Whether this pass is better.
  bool BetterThan(const MotionPass& former) const {
    if (settled != former.settled) return settled;
    return !settled || error_m < former.error_m;
  }
};

/// Height, lean and preferred ZMP of the body.
struct BodyStrategy {
  double com_height_m = 0.0;  ///< above the ground under the body
  double zmp_inward = 0.0;    ///< see SupportRegions
  bool in_reach = false;      ///< temporarily higher or lower if legs do not reach otherwise
  double lean_rad = 0.0;      ///< forward
};

/// Shared data of all passes; must outlive them.
struct MotionTask {
  const RobotModel& model;
  const Terrain& terrain;
  const FootstepSkeleton& skeleton;
  const MotionOptions& options;
  const BodyPath& body;
  double cycle_s;  ///< of the gait; the longest one of several gaits
};

/// Repeats the planning stages after the footsteps, with feedback from the multibody motion.
class MotionPasses {
 public:
  MotionPasses(const MotionTask& task, const BodyStrategy& strategy);

  /// One pass without corrections, which is sufficient to check limits.
  Result<MotionPass> RunOnce() { return MakePass(); }

  /// Runs passes until the ZMP reaches its reference; stops early if the first ones exceed limits by more than
  /// `infeasible`.
  Result<MotionPass> Run(int& passes, double infeasible);

 private:
  double Outside(const MotionPass& pass) const;
  void FollowGround(CentroidalTrajectory& motion) const;
  FormerMotion Former(const CentroidalTrajectory& motion) const;
  void KeepInReach(MotionPass& pass);
  Result<MotionPass> MakePass();
  Result<WholeBodySolution> SolveBody(MotionPass& pass);
  bool UpdateRolls(const WholeBodySolution& solution);
  bool UpdateLeans(const MotionPass& pass);
  void EndAsStanding();
  void UpdateOffset(const MotionPass& pass, double gain);

  const MotionTask task_;
  const RobotModel& model_;
  BodyPath body_;
  const bool in_reach_, level_;
  bool adapts_ = false;        // the body's height is still being adapted
  std::vector<Bounds> reach_;  // bounds from reach for the height of the body, by knot
  FormerMotion former_;        // over ground that is not level
  FootstepPlan footsteps_;
  std::vector<std::optional<Vector3>> planes_;  // planes of legs that cannot leave them
  bool is_planar_ = false;                      // true if there are such legs
  FormerMotion leans_by_;                       // assumed motion for their swings, from the previous pass
  std::vector<Vector3> expected_roll_;
  ZmpProblem problem_;
  SupportInputs support_;
};

}  // namespace gaitwright
