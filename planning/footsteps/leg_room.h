// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/ik/leg_workspace.h"
#include "planning/footsteps/ground_index.h"

namespace gaitwright {

/// Checks whether thighs and shanks are clear of the ground in a stance, for example of the edge of a stair under a
/// shank that leans back. The ground is solid below its surfaces. Keeps scratch data, so it is not thread-safe.
class LegRoom {
 public:
  /// @param margin_m  smallest distance of the legs from the ground [m]; near the foot, half of their height above its
  ///                  plane.
  LegRoom(const RobotModel& model, const GroundIndex& ground, double margin_m);

  /// @param workspace  workspace of the leg.
  /// @param X_WF       contact frame of its foot.
  /// @return true also if the leg cannot reach the foothold, which is checked elsewhere.
  bool IsClear(LegWorkspace& workspace, const Foot& foot, const Pose& X_WF, const Pose& X_WB);

  /// Whether ground around the foot is higher than the foot, so that the leg may collide with it.
  bool MayMeet(const Pose& X_WF) const;

 private:
  bool Meets(const Vector3& p_W, double radius_m) const;
  bool MeetsSurface(const GroundSurface& surface, const Vector3& p_W, double radius_m) const;
  bool MeetsField(const Vector3& p_W, double radius_m) const;

  const GroundIndex* ground_;
  double margin_m_, around_m_;
  std::vector<Ball> balls_;
  std::vector<int> near_;
};

}  // namespace gaitwright
