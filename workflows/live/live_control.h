// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// The controller of a robot whose plan becomes another while it goes on. One that refuses a plan, as 'recovering' does
/// all that do not stand from start to end, lets 'stabilised' follow that.
class LiveControl {
 public:
  /// The model must outlive it. @throws InvalidArgument listing the controllers there are.
  /// Failure: as of PlanRecovery, where that is needed.
  static Result<LiveControl> Make(const RobotModel& model, const PlayRequest& request);

  /// Follows another plan from now on.
  /// @param lately  what the robot did, which the new controller is shown.
  /// @return why the controller that was asked for does not, where it followed the plan before.
  /// @throws InvalidArgument for what no controller takes; then it goes on with what it had.
  std::optional<std::string> Follow(const MotionPlan& plan, const PlayRequest& request,
                                    const std::deque<ControlInput>& lately);

  /// What the joints are told, as of Controller.
  JointCommand Update(const ControlInput& input) { return controller_->Update(input); }
  const MotionPlan& plan() const { return *followed_; }
  /// Whether another one than was asked for has the robot.
  bool stood_in_for() const { return stood_in_for_; }
  /// Whether the robot may step by itself, away from where its plan stands.
  bool recovers() const { return recovery_ && !stood_in_for_; }

 private:
  explicit LiveControl(const RobotModel& model) : model_(&model) {}

  const RobotModel* model_;
  std::optional<RecoveryPlans> recovery_;  ///< made once, since that takes long
  std::unique_ptr<MotionPlan> followed_;
  std::unique_ptr<Controller> controller_;
  bool stood_in_for_ = false;
};

/// How far the feet that stand are from where a plan has them, in the mean.
Vector3 FootOffset(const RobotModel& model, const MotionPlan& plan, const ControlInput& now);

}  // namespace gaitwright
