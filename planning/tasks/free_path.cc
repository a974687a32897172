// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/free_path.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/dof_units.h"

namespace gaitwright {

PathCheck::PathCheck(const RobotModel& model, const VectorX& q_base)
    : model_(model), scratch_(model), collision_(model), q_(q_base) {}

std::optional<Overlap> PathCheck::FirstMeeting(const VectorX& from, const VectorX& to) {
  double pieces = 1.0;
  for (int d = 0; d < model_.num_dofs(); ++d)
    pieces = std::max(pieces, std::abs(to[d] - from[d]) / (Slides(model_, d) ? 1e-3 : 1e-2));
  const int count = static_cast<int>(std::ceil(pieces));
  for (int k = 0; k <= count; ++k) {
    if (auto meeting = MeetingAt(from + static_cast<double>(k) / count * (to - from))) return meeting;
  }
  return std::nullopt;
}

std::optional<Overlap> PathCheck::MeetingAt(const VectorX& joints) {
  q_.tail(model_.num_dofs()) = joints;
  ForwardKinematics(model_, q_, scratch_);
  const std::vector<Overlap>& overlaps = collision_.Overlaps(scratch_);
  if (overlaps.empty()) return std::nullopt;
  return overlaps.front();
}

}  // namespace gaitwright
