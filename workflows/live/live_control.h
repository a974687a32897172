// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// The controller of a running robot whose plan changes. If the selected controller refuses a plan ('recovering'
/// accepts only plans that stand from start to end), 'stabilised' executes it.
class LiveControl {
 public:
  /// The model must outlive this object. @throws InvalidArgument that lists the controllers. Failure: as of
  /// PlanRecovery, if it is needed.
  static Result<LiveControl> Make(const RobotModel& model, const PlayRequest& request);

  /// Switches to another plan.
  /// @param lately  recent states of the robot, which initialise the new controller.
  /// @return why the selected controller does not execute this plan, if it executed the previous one.
  /// @throws InvalidArgument for inputs that no controller accepts; the present plan then stays active.
  std::optional<std::string> Follow(const MotionPlan& plan, const PlayRequest& request,
                                    const std::deque<ControlInput>& lately);

  /// Joint commands, as of Controller.
  JointCommand Update(const ControlInput& input) { return controller_->Update(input); }
  const MotionPlan& plan() const { return *followed_; }
  /// Whether a controller other than the selected one is active.
  bool stood_in_for() const { return stood_in_for_; }
  /// Whether the robot may take recovery steps away from its plan.
  bool recovers() const { return recovery_ && !stood_in_for_; }

 private:
  explicit LiveControl(const RobotModel& model) : model_(&model) {}

  const RobotModel* model_;
  std::optional<RecoveryPlans> recovery_;  ///< made once, because it takes long
  std::unique_ptr<MotionPlan> followed_;
  std::unique_ptr<Controller> controller_;
  bool stood_in_for_ = false;
};

/// Mean distance of the stance feet from their planned positions.
Vector3 FootOffset(const RobotModel& model, const MotionPlan& plan, const ControlInput& now);

}  // namespace gaitwright
