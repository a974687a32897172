// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/contact_split.h"
#include "playback/control/footing.h"
#include "playback/control/momentum_gains.h"
#include "playback/control/situation.h"
#include "playback/control/stabilised.h"

namespace gaitwright {

/// The part of `stabilised` that looks ahead over a plan with flights: a stance there is too short to settle, and gives
/// what its feet can; the rest is left to the next ones, and to where they are put down.
class MomentumFeedback {
 public:
  MomentumFeedback(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options);

  /// Whether the plan has flights.
  bool active() const { return !gains_.rows.empty(); }

  /// Takes note of how far the robot is from its plan.
  void Update(const Situation& now, const Footing& footing);

  /// The wrench of the feet that shall stand, about the measured centre of mass. Only where it is active; update first.
  PointWrench Wanted(const Situation& now) const;

  /// Where the next foothold of a foot is to be, against its plan [m]. Likewise.
  Vector2 Step(int foot) const;

 private:
  const RobotModel& model_;
  const MomentumGains gains_;
  const MomentumGains::Row* row_ = nullptr;
  VectorX error_;
};

}  // namespace gaitwright
