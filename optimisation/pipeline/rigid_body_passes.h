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

/// Plans the stages after the footsteps as the motion of a single rigid body, for gaits that leave the ground and
/// speeds at which a pendulum is none. The first pass takes the robot for one stiff body; each one after that reckons
/// with the momentum that the legs had against it, with how the feet rolled, and with where body and upper legs came
/// too near to the ground, in the pass before, until the motors and contacts of the whole robot give the motion and it
/// is clear.
class RigidBodyPasses {
 public:
  explicit RigidBodyPasses(const MotionTask& task, const Crouch* crouch = nullptr);

  /// Passes until what the whole body needs and its contacts do not give is small. `error_m` of the pass is that, the
  /// greater of force over m g [1] and moment over m g [m].
  Result<MotionPass> Run(int& passes);

 private:
  /// First footholds are free. Then they are held, and motions found by the quicker interior-point method, each a
  /// little off the least costly one. Where those differ too much for the legs' momentum to settle, the method asked
  /// for goes on from them.
  enum class Stage { kFree, kQuick, kExact };

  Result<MotionPass> MakePass();
  RigidBodyOptions Options() const;
  std::vector<ReachSide> ReachAt(int foot, double time_s) const;
  Result<RigidBodyPlan> PlanClear(const RigidBodyOptions& options);
  /// The footholds of a motion.
  FootstepPlan FootstepsOf(const RigidBodyMotion& motion) const;
  void SetCentroidal(const std::vector<RigidBodySample>& samples, MotionPass& pass) const;
  bool StaysPastLimits(const MotionPass& pass, int passes);
  void HoldFootholds(const FootstepPlan& footsteps);
  void Learn(const MotionPass& pass);
  void LearnInnerMotion(const WholeBodyTrajectory& rows, DynamicsScratch& scratch);
  void LearnSwings(const std::vector<SwingTrajectory>& swings);
  MotorLimits MotorsOf(const MotionPass& pass, int foot, std::size_t row, DynamicsScratch& scratch) const;

  const MotionTask task_;
  const RobotModel& model_;
  const StandingBody body_;
  BodyClearance clearance_;
  const FlightSwings shapes_;
  RigidBodyProblem problem_;
  RigidBodyMotion motion_;  // of the last pass
  Stage stage_ = Stage::kFree;
  std::string method_;                       // the one asked for until it gives up
  std::optional<RigidBodyNumbers> numbers_;  // of the last motion with footholds held
  std::vector<RigidBodySample> samples_;     // of it, by row of the grid
  std::vector<Vector3> off_;                 // inner momentum that came back, less what went in, of the last pass
  double past_limits_ = 0.0;                 // of the last pass, TotalExcess
  double step_ = 1.0;                        // of that, how much was taken
  std::vector<Vector3> expected_roll_;       // by foothold
  std::vector<Vector3> roll_;                // by foothold, over its stance
};

}  // namespace gaitwright
