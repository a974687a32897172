// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/pipeline/body_clearance.h"
#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/flight_swings.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/robot_body.h"

namespace gaitwright {

/// Plans the stages after the footsteps as the motion of a single rigid body, for gaits with flight and for speeds at
/// which the pendulum model fails. The first pass treats the robot as one rigid body; each later pass includes the leg
/// angular momentum, the rolling of the feet, and the places where body and upper legs came too close to the ground in
/// the previous pass. FinishMotion then makes motion and forces of the whole robot agree.
///
/// With free footholds (HasFreeFootholds), constraints that stay violated let stances change to other patches
/// (PlanOverChoice). If feet touch solids in the air after the passes, more passes include the rolling of the feet in
/// their swings; if they still do, their swings are planned together with the body (WithSwingsAlong).
class RigidBodyPasses {
 public:
  explicit RigidBodyPasses(const MotionTask& task, const Crouch* crouch = nullptr);

  /// Runs one pass, over uneven ground three, and more until the body is clear of the ground. `error_m` of a pass is
  /// the larger of unbalanced force / m g [1] and moment / m g [m].
  Result<MotionPass> Run(int& passes);

 private:
  /// What is done about feet in the air that touch solids: nothing yet; swings include the rolling of the feet in the
  /// pass before; they were planned together with the body.
  enum class Mending { kNone, kRolling, kAlong };

  Result<MotionPass> MakePass();
  RigidBodyOptions Options() const;
  std::vector<ReachSide> ReachAt(int foot, double time_s) const;
  Result<RigidBodyPlan> PlanClear(const RigidBodyOptions& options);
  Result<RigidBodyPlan> PlanFree(const RigidBodyOptions& options, RigidBodyPlan& last);
  /// The footholds of a motion.
  FootstepPlan FootstepsOf(const RigidBodyMotion& motion) const;
  void SetCentroidal(const std::vector<RigidBodySample>& samples, MotionPass& pass) const;
  void HoldFootholds(const FootstepPlan& footsteps);
  bool MendSwings();
  void Learn(const MotionPass& pass);
  void UpdateLegMotion(const WholeBodyTrajectory& rows, DynamicsScratch& scratch);
  void LearnSwings(const std::vector<SwingTrajectory>& swings);

  const MotionTask task_;
  const RobotModel& model_;
  const StandingBody body_;
  BodyClearance clearance_;
  const FlightSwings shapes_;
  RigidBodyProblem problem_;
  const bool uneven_;  // the ground is not flat
  const bool free_;    // footholds move on their patches and to other ones
  Mending mending_;
  std::vector<int> patches_;                 // by stance; -1 if it is fixed
  FormerMotion former_;                      // of the last pass, over uneven ground
  RigidBodyMotion motion_;                   // of the last pass
  bool holds_ = false;                       // footholds are those of the second pass
  std::optional<RigidBodyNumbers> numbers_;  // of the last motion with fixed footholds
  std::vector<RigidBodySample> samples_;     // samples of that motion, by row of the grid
  std::vector<Vector3> expected_roll_;       // by foothold
  std::vector<Vector3> roll_;                // by foothold, over its stance
};

}  // namespace gaitwright
