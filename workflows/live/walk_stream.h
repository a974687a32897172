// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "planning/plan/steady_stretch.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// Name of the gait for standing still.
inline constexpr char kStanding[] = "stand";

/// A commanded gait and speed, which hold until the next command.
struct WalkPace {
  std::string gait;                                                       ///< as for FindGait, or kStanding
  double speed_m_s = 0.0, lateral_speed_m_s = 0.0, yaw_rate_rad_s = 0.0;  ///< as in WalkCommand; all 0 means standing

  /// Zero speeds count as standing, because a WalkCommand with zero speeds means the robot's default speed.
  bool stands() const {
    return gait == kStanding || (speed_m_s == 0.0 && lateral_speed_m_s == 0.0 && yaw_rate_rad_s == 0.0);
  }
  bool operator==(const WalkPace&) const = default;
};

/// The robot's default speed, with its default gait.
WalkPace UsualPace(const RobotModel& model, const GaitOptions& options);

/// A plan with a periodic part at one speed, between another speed and rest.
struct PacePlan {
  MotionPlan plan;
  std::optional<SteadyStretch> before;  ///< periodic part at the previous speed; nothing if the robot stood
  SteadyStretch stretch;                ///< periodic part at this speed
};

/// A change from one gait and speed to another, with a turn in between.
struct PaceChange {
  WalkPace from, to;
  double turn_rad = 0.0;
  double com_height_m = 0.0;  ///< as in PipelineOptions; 0 for an automatic choice
};

/// The new gait and speed in words, such as "trot at 0.3 m/s, turning at 0.4 rad/s".
std::string TextOf(const PaceChange& change);

/// Plans a walk that changes from one speed to another, keeps the new speed for a while, and stops. It uses the given
/// height, or another height if that one is infeasible. The cycle of a gait is rounded to a whole number of the plan's
/// time steps, so that it can repeat. Failure: as of PlanWalk; kInfeasible `not_steady` if the motion at one of the
/// speeds does not become periodic.
Result<PacePlan> PlanPace(const RobotModel& model, const PaceChange& change, const WalkRequest& usual);

/// A walk without end, made of finite plans. Its plan always ends at rest: without further commands the robot stops and
/// stands.
class WalkStream {
 public:
  /// Starts with standing in the first state of a plan.
  /// @param stand  a plan that begins at rest.
  explicit WalkStream(const MotionPlan& stand);

  /// The plan, from some time before now to rest, on the clock of the stream.
  const MotionPlan& plan() const { return plan_; }
  /// The gait and speed that it keeps or changes to.
  const WalkPace& pace() const { return pace_; }
  /// Whether it comes to rest without continuing.
  bool stops() const { return !source_; }
  /// Heading of the present walk, which is equal in each cycle if the robot does not turn.
  double heading_rad() const;
  /// Start of the periodic part of the present walk, after its transition, such as a turn.
  double steady_from_s() const { return steady_.start_s; }

  /// Changes to another gait and speed at the first suitable time, not before `earliest_s`.
  /// @param next  planned from the present gait and speed. Failure kBadInput `misfit` if it is not, kInfeasible if its
  ///              posture is too far from the present one.
  std::optional<Failure> GoOver(double earliest_s, const WalkPace& pace, const PacePlan& next);
  /// Stops at the first suitable time, not before `earliest_s`. Failure as of JoinedPlans; the walk then continues.
  std::optional<Failure> Stop(double earliest_s);
  /// Extends the present walk if its plan would begin to stop before `until_s`. @return whether it was extended.
  bool GoOn(double until_s);
  /// Removes the rows before a time, except the last one at or before it.
  void Forget(double before_s);
  /// Moves the whole walk, and the assumed position of the ground with it.
  void Shift(const Vector3& by_W);

 private:
  double MomentFrom(double earliest_s) const;
  void Stand(double until_s);

  MotionPlan plan_;
  WalkPace pace_ = {.gait = kStanding};
  std::optional<PacePlan> source_;  ///< plan with which the walk continues; nothing if it stops
  SteadyStretch steady_;            ///< periodic part of plan_, on its clock; no cycles if the robot stands or stops
};

}  // namespace gaitwright
