// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A ball in the frame of the base.
struct Ball {
  Vector3 centre_B = Vector3::Zero();
  double radius_m = 0.0;
};

/// Balls inside the shapes of a leg, except its foot. They represent thigh and shank for fast collision checks of many
/// poses with the ground.
///
/// The bounding box of a shape along its own axes is filled with balls. Their radius is half of the smallest edge, and
/// their spacing is at most a twentieth of the leg's length, or their diameter if it is larger. So balls are inside the
/// box, and for a long shape they leave out only its edges.
class LegBalls {
 public:
  LegBalls(const RobotModel& model, int leg);

  /// Appends the centres in B at positions of the dofs of LegChain, always in the same order.
  void CentresAt(const VectorX& coordinates, std::vector<Vector3>& centres_B) const;

  std::size_t size() const { return balls_.size(); }
  double radius_m(std::size_t i) const { return balls_[i].radius_m; }

 private:
  struct LinkBall {
    std::size_t link = 0;  // link of the chain that carries it
    Vector3 centre_B;      // at joint positions zero
    double radius_m = 0.0;
  };

  void Fill(const Shape& shape, const Pose& X_BS, std::size_t link);

  LegChain chain_;
  double spacing_m_;
  std::vector<LinkBall> balls_;  // by link, base first
};

}  // namespace gaitwright
