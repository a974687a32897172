// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "playback/engine/controller.h"
#include "python/bindings/in_use.h"
#include "python/bindings/plan.h"
#include "workflows/walk/walk.h"

namespace gaitwright::python {

/// @throws InvalidArgument if the sizes of the input are not those of the robot, or a value is not finite.
void CheckInput(const RobotModel& model, const ControlInput& input);

/// A built-in controller for a plan, which it keeps alive. Only one thread at a time may use it.
class OwnController : public Controller {
 public:
  /// @throws as MakeController does.
  OwnController(const std::shared_ptr<const Plan>& plan, const PlayRequest& request)
      : plan_(plan), controller_(MakeController(plan->model(), plan->motion(), request)) {}

  /// @throws InvalidArgument if the input does not fit the plan's robot.
  JointCommand Update(const ControlInput& input) override {
    CheckInput(plan_->model(), input);
    const InUse::Turn turn(asked_, "this controller");
    return controller_->Update(input);
  }
  void Reset() override {
    const InUse::Turn turn(asked_, "this controller");
    controller_->Reset();
  }
  const BaseEstimate* Estimate() const override { return controller_->Estimate(); }
  std::string Name() const override { return controller_->Name(); }
  /// Marks that a whole playback uses the controller.
  InUse& played() { return played_; }

 private:
  std::shared_ptr<const Plan> plan_;
  std::unique_ptr<Controller> controller_;
  InUse asked_, played_;
};

}  // namespace gaitwright::python
