// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "workflows/repair/repair_options_internal.h"

namespace gaitwright {

/// The posture nearest to a given one in which the feet are at given places:
///   min |W e|^2   subject to   rows of feet (e) = 0, joints within their ranges,
/// e being the change of base position, base rotation (rotation vector in W) and joints. Gauss-Newton; joints at an end
/// of their range are held there.
class NearestPosture {
 public:
  NearestPosture(const RobotModel& model, const RepairOptions& options);

  /// @param X_WF  by foot of a leg: its contact frame. @param q  receives the posture; its value is not used.
  /// @return the largest distance of a foot from its place [m].
  double Solve(const VectorX& q_given, const std::vector<Pose>& X_WF, VectorX& q);

 private:
  void Assemble(const std::vector<Pose>& X_WF);
  void Move(const VectorX& q_given, VectorX& q);
  double Distance(const std::vector<Pose>& X_WF) const;

  const RobotModel& model_;
  DynamicsScratch scratch_;
  std::vector<std::array<bool, 6>> rows_;
  VectorX give_,
      e_;  // by velocity coordinate: inverse of the squared weight; change so far (also the next first guess)
  std::vector<bool> held_;
  MatrixX J_, foot_J_;
  VectorX error_;
};

}  // namespace gaitwright
