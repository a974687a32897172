// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/reach_height.h"

#include <algorithm>

namespace gaitwright {

ReachHeight::ReachHeight(const RobotModel& model) : model_(model), leg_m_(model.leg_length_m()) {
  for (int leg = 0; leg < static_cast<int>(model.legs.size()); ++leg) {
    const std::vector<int>& dofs = legs_.emplace_back(model, leg).dofs();
    standing_.emplace_back(model.standing_joints(dofs));
  }
}

/// @param near  joints of each leg close to those that are searched; replaced by these if all feet are reached.
bool ReachHeight::AllReach(Pose X_WB, double change_m, const std::vector<Pose>& X_WF,
                           std::vector<VectorX>& near) const {
  X_WB.translation().z() += change_m;
  const Pose X_BW = X_WB.inverse();
  std::vector<VectorX> found;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    const Pose X_BF = X_BW * X_WF[static_cast<std::size_t>(model_.legs[leg].foot)];
    std::optional<VectorX> joints = legs_[leg].SolveNear(X_BF, near[leg]);
    if (!joints) return false;
    found.push_back(std::move(*joints));
  }
  near = std::move(found);
  return true;
}

/// Joints of each leg that reach the feet, from any start; nothing if there are none.
std::optional<std::vector<VectorX>> ReachHeight::Joints(const Pose& X_WB, const std::vector<Pose>& X_WF) const {
  std::vector<VectorX> found;
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    Result<LegIk::Solution> solution =
        legs_[leg].Solve(X_WB.inverse() * X_WF[static_cast<std::size_t>(model_.legs[leg].foot)]);
    if (!solution) return std::nullopt;
    found.push_back(std::move(solution->joints));
  }
  return found;
}

std::optional<Bounds> ReachHeight::Changes(const Pose& X_WB, const std::vector<Pose>& X_WF, double margin) const {
  constexpr double kStep = 0.02;  // of the leg's length
  constexpr int kMost = 12, kHalvings = 4;
  const double step_m = kStep * leg_m_;
  std::vector<VectorX> near = standing_;
  const auto reached = [&](double change_m) { return AllReach(X_WB, change_m, X_WF, near); };
  std::optional<double> least;
  for (int i = 0; i <= 2 * kMost && !least; ++i) {
    const int steps = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2);
    const double change_m = steps * step_m;
    if (reached(change_m)) least = change_m;
  }
  if (!least) {
    std::optional<std::vector<VectorX>> joints = Joints(X_WB, X_WF);  // the standing posture may be far
    if (!joints) return std::nullopt;
    near = std::move(*joints);
    least = 0.0;
  }
  const std::vector<VectorX> at_least = near;
  const auto farthest = [&](double side) {
    near = at_least;
    double in = *least, out = in + side * step_m;
    while (reached(out) && side * out < kMost * step_m) {
      in = out;
      out += side * step_m;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (in + out);
      (reached(middle) ? in : out) = middle;
    }
    return in;
  };
  const Bounds all{farthest(-1.0), farthest(1.0)};
  const double kept = std::min(margin * leg_m_, 0.5 * (all.high - all.low));
  return Bounds{all.low + kept, all.high - kept};
}

}  // namespace gaitwright
