// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/sole_support.h"
#include "planning/plan/support_plane.h"
#include "playback/control/controller.h"

namespace gaitwright {

/// A robot at one time.
struct BodyState {
  explicit BodyState(const RobotModel& model) : scratch(model) {}

  DynamicsScratch scratch;
  VectorX q, v;
  Vector3 p_WC = Vector3::Zero(), v_WC = Vector3::Zero();
  Vector3 l_W = Vector3::Zero();  ///< angular momentum about C [N m s]
  std::vector<Pose> X_WF;         ///< contact frames, by foot

  const Matrix3& R_WB() const { return scratch.R_WB[0]; }
  const Vector3& p_WB() const { return scratch.p_WB[0]; }
  const Vector3& w_WB() const { return scratch.w_WB[0]; }
};

/// The swing of a foot, or its next one.
struct SwingNow {
  double liftoff_s = 0.0;  ///< or the end of the foot's last stance
  double touchdown_s = 0.0;
  double next_liftoff_s = 0.0;  ///< of the next foothold
  double next_support_s = 0.0;  ///< next_liftoff_s, or the end of the flight that follows it
  bool swings = false;

  /// Share of the swing that has passed, from 0 to 1.
  double Progress(double time_s) const;
};

/// The ground under a foot.
struct GroundUnder {
  Vector3 normal_W = Vector3::UnitZ();
  double friction = 0.0;
  bool is_plane = true;                ///< not a height field, where a sole rocks under load
  Polygon support_F;                   ///< part of the foot that is on it, see SupportsOf, or the sole's front edge
  bool on_edge = false;                ///< a sole that stands on its front edge
  Vector3 middle_F = Vector3::Zero();  ///< contact frame's origin, or the middle of the front edge
};

/// The swings of a plan, stored by foot. A search through all footholds at each 1 kHz step would take longer for longer
/// plans.
class Swings {
 public:
  Swings(const RobotModel& model, const MotionPlan& plan);

  /// The swing of a foot at a time. `swings` is false while the foot stands, and in the air before its first or after
  /// its last foothold.
  SwingNow At(int foot, double time_s) const;

  /// The ground under a foot that stands, or the ground on which it stood last.
  const GroundUnder& Under(int foot, double time_s) const;

 private:
  std::size_t StayAt(std::size_t foot, double time_s) const;

  std::vector<std::vector<ContactInterval>> stays_;  // by foot, in the order of the plan
  std::vector<ContactPhase> flights_;                // in order
  std::vector<std::vector<GroundUnder>> grounds_;    // by foot; level if a plan has no footholds for the foot
  /// By foot and stay: after heel-off, from a time.
  std::vector<std::vector<std::pair<double, GroundUnder>>> edges_;
};

/// Measured and planned state at the same time, the input of the feedback.
struct Situation {
  Situation(const RobotModel& model, const MotionPlan& plan)
      : measured(model), planned(model), swings(model, plan), plan_(plan) {}

  /// Resets the state.
  void Reset();
  void Update(const RobotModel& model, const ControlInput& input);

  /// Contact points of a foot at its present pose, or on the ground where it last stood, in W [m].
  void PointsAt(int foot, const BodyState& body, std::vector<Vector3>& points_W) const;

  double time_s = 0.0, step_s = 0.001;
  double lead_s = 0.001;   ///< time until motors compare joint and command, see ControlInput
  WholeBodySample sample;  ///< of the plan
  BodyState measured, planned;
  const Swings swings;                  ///< of the plan
  std::vector<ContactWrench> wrenches;  ///< measured, by foot
  FootSet scheduled = 0;                ///< feet that should stand
  FootSet bearing = 0;                  ///< feet that stand: scheduled or at the end of their swing, and in contact
  GroundPlane support;                  ///< plane of the planned ZMP
  double ground_m = 0.0;     ///< mean height of the planned contacts of the feet that should stand, or last did
  double omega_rad_s = 1.0;  ///< of the planned pendulum

 private:
  void Observe(const RobotModel& model, const VectorX& q, const VectorX& v, BodyState& body) const;
  const MotionPlan& plan_;
  std::vector<double> touched_s_;  // last contact, by foot
  ContactsByFoot contacts_;        // planned
};

}  // namespace gaitwright
