// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "planning/plan/motion_plan.h"
#include "playback/engine/controller.h"
#include "playback/sensing/leg_odometry.h"
#include "playback/sensing/sensing_options.h"

namespace gaitwright {

/// A controller behind sensors: the inner controller gets measured or estimated states, and its commands are delayed.
/// The motors' own loops are not delayed: the drive closes stiffness and damping of a JointCommand on its own encoder.
/// Its only error is the zero offset, which the controller's readings have too, so that a drive holds its target minus
/// that offset. With `drive_loop` "sensed", this controller closes the loops on the sensed state and commands a torque:
///   tau_ff + stiffness (q - q_sensed) + damping (v - v_sensed).
///
///   true       the true state
///   measured   joints from encoders, contacts and vertical forces from the feet, the true base
///   estimated  as measured, but the base from LegOdometry, which starts at the plan's first pose
/// With sensors, wrenches contain only the vertical force.
class SensingController : public Controller {
 public:
  /// @param inner  the controller itself. Model and plan must outlive this object. @throws InvalidArgument for an
  /// option out of its range, or if state is "estimated" and the plan has no motion.
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
  void SendBase();

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

/// The controller with sensors and delays; the controller itself if there are none.
std::unique_ptr<Controller> BehindSensors(const RobotModel& model, const MotionPlan& plan,
                                          std::unique_ptr<Controller> controller, const SensingOptions& options);

}  // namespace gaitwright
