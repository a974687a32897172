// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planning/plan/motion_plan.h"
#include "playback/engine/controller.h"
#include "playback/sensing/leg_odometry.h"
#include "playback/sensing/sensing_options.h"

namespace gaitwright {

/// A controller behind sensors: the inner controller gets measured or estimated states, and its commands are delayed.
/// The motors' own loops are not delayed: stiffness and damping of a JointCommand are closed in the drive, on its own
/// encoder. Of that only the zero may be off, by the bias that the controller sees too, so that what a drive holds is
/// its target less that bias. With `drive_loop` "sensed" they are closed here instead, on the sensed state, and a
/// torque is commanded:  tau_ff + stiffness (q - q_sensed) + damping (v - v_sensed).
///
///   true       the state as it is
///   measured   joints from encoders, contacts and vertical forces from the feet, the base as it is
///   estimated  the same, and the base from LegOdometry, which starts at the plan's first pose
/// With sensors, wrenches hold the vertical force alone.
class SensingController : public Controller {
 public:
  /// @param inner  what controls. Model and plan must outlive this. @throws InvalidArgument for an option out of its
  /// range, or where state is "estimated" and the plan has no motion.
  SensingController(const RobotModel& model, const MotionPlan& plan, std::unique_ptr<Controller> inner,
                    const SensingOptions& options);
  ~SensingController() override;

  JointCommand Update(const ControlInput& input) override;
  void Reset() override;
  std::string Name() const override { return inner_->Name(); }
  const BaseEstimate* Estimate() const override;

 private:
  struct Instruments;

  void Sense(const ControlInput& input);
  void CloseLoop(JointCommand& command) const;
  void TellBase();

  const RobotModel& model_;
  const MotionPlan& plan_;
  const std::unique_ptr<Controller> inner_;
  SensingOptions options_;
  const StateSource source_;
  const DriveLoop loop_;
  std::unique_ptr<Instruments> instruments_;
  ControlInput sensed_;
  BaseEstimate estimate_;
};

/// The controller behind sensors and delays; the controller itself if there are none.
std::unique_ptr<Controller> BehindSensors(const RobotModel& model, const MotionPlan& plan,
                                          std::unique_ptr<Controller> controller, const SensingOptions& options);

}  // namespace gaitwright
