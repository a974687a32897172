// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/contact_split.h"
#include "playback/control/footing.h"
#include "playback/control/momentum_gains.h"
#include "playback/control/situation.h"
#include "playback/control/stabilised.h"

namespace gaitwright {

/// Predictive part of `stabilised` for plans with flight. A stance is too short to correct all errors: each stance
/// gives the correction that its feet can, and later stances and their footholds correct the rest.
class MomentumFeedback {
 public:
  MomentumFeedback(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options);

  /// Whether the plan has flights.
  bool active() const { return !gains_.rows.empty(); }

  /// Updates the deviation of the robot from its plan.
  void Update(const Situation& now, const Footing& footing);

  /// The wanted wrench of the stance feet about the measured centre of mass. Requires active() and a call of Update.
  PointWrench Wanted(const Situation& now) const;

  /// Wanted shift of a foot's next foothold from its plan [m]. Requires active() and a call of Update.
  Vector2 Step(int foot) const;

 private:
  const RobotModel& model_;
  const MomentumGains gains_;
  const MomentumGains::Row* row_ = nullptr;
  VectorX error_;
};

}  // namespace gaitwright
