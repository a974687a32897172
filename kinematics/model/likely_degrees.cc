// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/likely_degrees.h"

#include <algorithm>
#include <numbers>

#include "kinematics/model/dof_units.h"

namespace gaitwright {

std::optional<PastLimit> LikelyDegrees(const RobotModel& model, const std::vector<VectorX>& rows) {
  constexpr double kFar = 0.5, kNear = 0.1, kDegree = std::numbers::pi / 180.0;  // [rad]
  std::optional<PastLimit> farthest;
  double most = kFar;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (Slides(model, dof)) continue;
    const double lower = model.dof_lower(dof), upper = model.dof_upper(dof);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double q = rows[row][dof];
      if (q * kDegree < lower - kNear || q * kDegree > upper + kNear) return std::nullopt;
      const double past = std::max(lower - q, q - upper);
      if (past > most) most = past, farthest = PastLimit{static_cast<int>(row), dof};
    }
  }
  return farthest;
}

}  // namespace gaitwright
