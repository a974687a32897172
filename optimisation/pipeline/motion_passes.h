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

/// One pass: what was tried and how far its ZMP is from its reference.
///
/// A pass is settled when the feet rolled, and the base leaned over planar legs, as the pass itself had taken them to.
/// One that is not has footholds and swings aimed with rolls that are not its own, so that its motion does not end
/// where it should, whatever its ZMP does: any settled pass is better. Among unsettled ones the newest is, being aimed
/// with the freshest rolls; among settled ones that whose ZMP is nearest to its reference. One of a rigid body is
/// settled when it is clear of the ground.
struct MotionPass {
  CentroidalTrajectory centroidal;
  std::vector<SwingTrajectory> swings;
  FootstepPlan footsteps;
  WholeBodySolution solution;
  double error_m = std::numeric_limits<double>::infinity();
  double excess = 0.0;     ///< past limits of joints, summed in shares of the limits
  double outside_m = 0.0;  ///< of supports with area, by the multibody ZMP; on a line its error is all there is
  double lacks_m = 0.0;    ///< of the least clearance of the body from the ground, as far as that is looked after
  bool settled = false;

  /// Whether this one is rather to be kept.
  bool BetterThan(const MotionPass& former) const {
    if (settled != former.settled) return settled;
    return !settled || error_m < former.error_m;
  }
};

/// How the body is carried.
struct Carriage {
  double com_height_m = 0.0;  ///< over the ground under the body
  double zmp_inward = 0.0;    ///< see SupportRegions
  bool in_reach = false;      ///< higher or lower for a while where legs do not reach otherwise
  double lean_rad = 0.0;      ///< forward
};

/// What all passes share; outlives them.
struct MotionTask {
  const RobotModel& model;
  const Terrain& terrain;
  const FootstepSkeleton& skeleton;
  const MotionOptions& options;
  const BodyPath& body;
  double cycle_s;  ///< of the gait, the longest of several
};

/// Plans the stages after the footsteps again and again, feeding back what the multibody did.
class MotionPasses {
 public:
  MotionPasses(const MotionTask& task, const Carriage& carriage);

  /// One pass without corrections, enough to see which limits are kept.
  Result<MotionPass> RunOnce() { return MakePass(); }

  /// Passes until the ZMP is on its reference; where the first ones are farther past limits than `hopeless`, no more.
  Result<MotionPass> Run(int& passes, double hopeless);

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
  bool adapts_ = false;        // the body's height is still sought
  std::vector<Bounds> reach_;  // of the ground under the body, by its knots
  FormerMotion former_;        // over ground that is not level
  FootstepPlan footsteps_;
  std::vector<std::optional<Vector3>> planes_;  // of legs that cannot leave theirs
  bool is_planar_ = false;                      // there are such legs
  FormerMotion leans_by_;                       // their swings, of the pass before
  std::vector<Vector3> expected_roll_;
  ZmpProblem problem_;
  SupportInputs support_;
};

}  // namespace gaitwright
