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

/// A commanded pace, which stays until the next command.
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

/// A plan with a periodic stretch of one pace, between another pace and rest.
struct PacePlan {
  MotionPlan plan;
  std::optional<SteadyStretch> before;  ///< of the previous pace; nothing if that was standing
  SteadyStretch stretch;                ///< of this pace
};

/// A change from one pace to another, with a turn in between.
struct PaceChange {
  WalkPace from, to;
  double turn_rad = 0.0;
  double com_height_m = 0.0;  ///< as of PipelineOptions; 0 for an automatic choice
};

/// A pace in words, such as "trot at 0.3 m/s, turning at 0.4 rad/s".
std::string TextOf(const PaceChange& change);

/// Plans a walk that goes over from one pace into another at the height given, or where that does not serve at another,
/// keeps that for a while, and stops. The cycle of a gait is the nearest whole number of the plan's time steps, so that
/// it can repeat itself. Failure: what PlanWalk refuses; kInfeasible `not_steady` where either pace does not become
/// steady.
Result<PacePlan> PlanPace(const RobotModel& model, const PaceChange& change, const WalkRequest& usual);

/// A walk without an end made of plans that have one. At any time its plan leads to rest: if nothing comes after it
/// the robot stops and stands.
class WalkStream {
 public:
  /// Stands as the first state of a plan does.
  /// @param stand  a plan that begins at rest.
  explicit WalkStream(const MotionPlan& stand);

  /// From some time before now to rest, on the clock of the stream.
  const MotionPlan& plan() const { return plan_; }
  /// The pace that it goes over to or keeps.
  const WalkPace& pace() const { return pace_; }
  /// Whether it comes to rest with nothing after it.
  bool stops() const { return !source_; }
  /// Where the present pace heads, which is the same in each of its cycles where it does not turn.
  double heading_rad() const;
  /// From when the present pace repeats itself: what leads to it, a turn for one, is over.
  double steady_from_s() const { return steady_.start_s; }

  /// Goes over into another pace at the first moment that serves, not before `earliest_s`.
  /// @param next  planned from the present pace. Failure kBadInput `misfit` where it is not,
  /// kInfeasible where its posture is too far from the present one.
  std::optional<Failure> GoOver(double earliest_s, const WalkPace& pace, const PacePlan& next);
  /// Stops at the first moment that serves, not before `earliest_s`. Failure as of JoinedPlans; then it goes on.
  std::optional<Failure> Stop(double earliest_s);
  /// Goes on with the present pace, where its plan would begin to stop before `until_s`. @return whether it did.
  bool GoOn(double until_s);
  /// Forgets what was before a time, but for the row at it or before.
  void Forget(double before_s);
  /// The same elsewhere: all is moved, and with it where the ground is taken to be.
  void Shift(const Vector3& by_W);

 private:
  double MomentFrom(double earliest_s) const;
  void Stand(double until_s);

  MotionPlan plan_;
  WalkPace pace_ = {.gait = kStanding};
  std::optional<PacePlan> source_;  ///< what it goes on with; nothing where it stops
  SteadyStretch steady_;            ///< of plan_, on its clock; of no cycles where it stands or stops
};

}  // namespace gaitwright
