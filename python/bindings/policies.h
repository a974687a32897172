// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "python/bindings/plan.h"
#include "workflows/walk/prepare_policy_internal.h"

namespace gaitwright::python {

/// A learned policy that fits a robot, with its commands. It never changes.
class Policy {
 public:
  Policy(const SharedRobot& robot, PreparedPolicy prepared)
      : prepared_(std::move(prepared)), plan_(std::make_shared<Plan>(robot, prepared_.plan)) {}

  const PreparedPolicy& prepared() const { return prepared_; }
  /// The commands as a plan.
  const std::shared_ptr<Plan>& plan() const { return plan_; }
  const RobotModel& model() const { return plan_->model(); }

 private:
  PreparedPolicy prepared_;
  std::shared_ptr<Plan> plan_;
};

}  // namespace gaitwright::python
