// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "planning/plan/motion_plan.h"
#include "python/bindings/arrays.h"
#include "python/bindings/robot.h"

namespace gaitwright::python {

/// A plan and its robot. Neither changes, so that their arrays can be shared.
class Plan {
 public:
  Plan(SharedRobot robot, MotionPlan motion)
      : robot_(std::move(robot)), motion_(std::make_shared<const MotionPlan>(std::move(motion))) {}
  /// Takes the robot that the plan contains. @throws FailureError if the robot cannot be read.
  explicit Plan(MotionPlan motion);

  const SharedRobot& robot() const { return robot_; }
  const RobotModel& model() const { return *robot_; }
  const MotionPlan& motion() const { return *motion_; }
  const Tables& tables() const { return tables_; }

 private:
  SharedRobot robot_;
  std::shared_ptr<const MotionPlan> motion_;
  Tables tables_;
};

}  // namespace gaitwright::python
