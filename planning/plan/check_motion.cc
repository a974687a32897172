// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/check_motion.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// Checks that the column has as many rows as q, each of `size`.
template <class Row>
void CheckColumn(const RobotModel& model, const WholeBodyTrajectory& motion, const char* name,
                 const std::vector<Row>& rows, int size) {
  if (rows.size() != motion.q.size()) {
    throw InvalidArgument(fmt::format("the plan has {} rows of q, but {} of {}", motion.q.size(), rows.size(), name));
  }
  for (const Row& row : rows) {
    if (static_cast<int>(row.size()) == size) continue;
    throw InvalidArgument(
        fmt::format("the plan's {} has {} entries; robot '{}' needs {}", name, row.size(), model.name, size));
  }
}

}  // namespace

void CheckMotion(const RobotModel& model, const WholeBodyTrajectory& motion, const MotionColumns& needed) {
  if (motion.size() == 0) throw InvalidArgument("the plan has no whole-body rows; one or more are needed");
  CheckColumn(model, motion, "q", motion.q, model.nq());
  CheckColumn(model, motion, "v", motion.v, model.nv());
  CheckColumn(model, motion, "a", motion.a, model.nv());
  if (needed.torques || !motion.tau.empty()) CheckColumn(model, motion, "tau", motion.tau, model.num_dofs());
  if (needed.wrenches || !motion.wrenches.empty())
    CheckColumn(model, motion, "wrenches", motion.wrenches, static_cast<int>(model.feet.size()));
}

}  // namespace gaitwright
