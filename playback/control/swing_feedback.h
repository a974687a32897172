// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/trajectory/swing_curve.h"
#include "playback/control/ground_fit_internal.h"
#include "playback/control/leg_targets.h"
#include "playback/control/momentum_feedback.h"
#include "playback/control/situation.h"
#include "playback/control/stabilised.h"
#include "playback/control/stance_feedback.h"

namespace gaitwright {

/// The part of `stabilised` that acts through the feet in the air. Each swing goes to the foothold that stops the DCM,
/// in the world frame. Its sole stays parallel to the ground when the base is displaced or tilted.
class SwingFeedback {
 public:
  SwingFeedback(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options);
  /// Resets the offsets of the feet.
  void Reset();

  /// Offsets of the standing feet, and the ground tilt that they measure.
  const Footing& UpdateFooting(const Situation& now);

  /// Sets the targets of swing legs, and the stance gains of stance legs.
  /// @param predictive  if given and active, it sets the footholds.
  void Update(const Situation& now, const StanceFeedback& stance, JointCommand& command,
              const MomentumFeedback* predictive = nullptr);

 private:
  /// A foot's place relative to its plan, moving.
  struct Offset {
    Vector3 value = Vector3::Zero(), rate = Vector3::Zero(), acceleration = Vector3::Zero();
    Vector3 wanted = Vector3::Zero();
  };

  void RecordGround(const Situation& now, int foot);
  Vector2 WantedStep(const Situation& now, const SwingNow& swing, const StanceFeedback& stance) const;
  double WantedHeight(const Situation& now, int foot) const;
  void MoveOffset(const Situation& now, const SwingNow& swing, Offset& offset) const;
  void SearchGround(const Situation& now, const SwingNow& next, Offset& offset) const;
  Motion1 Hover(const Situation& now, const SwingNow& swing) const;
  FootMotion WantedMotion(int foot, const Motion1& hover) const;
  void CommandStance(const Situation& now, int leg, const StanceFeedback& stance, JointCommand& command);
  void CommandSwing(const Situation& now, int leg, const Motion1& hover, JointCommand& command);

  const RobotModel& model_;
  const MotionPlan& plan_;
  const StabilisedOptions& options_;
  LegTargets legs_;
  Footing footing_;
  GroundFit ground_;
  std::vector<Offset> offsets_;
  WholeBodySample next_;
  DynamicsScratch next_scratch_, mass_scratch_;
  MatrixX mass_;
  VectorX q_, v_;
  std::vector<Vector3> measured_W_, planned_W_;  // contact points of one foot
};

}  // namespace gaitwright
