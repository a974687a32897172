// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A ball in the base's frame.
struct Ball {
  Vector3 centre_B = Vector3::Zero();
  double radius_m = 0.0;
};

/// Balls inside the shapes of a leg, those of its foot apart: what stands for thigh and shank where many poses are held
/// against the ground.
///
/// A shape is filled by the box around it along its own axes: balls of half the box's least edge, at most a twentieth
/// of the leg apart or as far as they are wide. So they are never beyond a box, and for a long shape leave out its
/// edges alone.
class LegBalls {
 public:
  LegBalls(const RobotModel& model, int leg);

  /// Centres in B at positions of the dofs of LegChain, appended in an order that is always the same.
  void CentresAt(const VectorX& coordinates, std::vector<Vector3>& centres_B) const;

  std::size_t size() const { return balls_.size(); }
  double radius_m(std::size_t i) const { return balls_[i].radius_m; }

 private:
  struct LinkBall {
    std::size_t link = 0;  // of the chain, that carries it
    Vector3 centre_B;      // at joint positions zero
    double radius_m = 0.0;
  };

  void Fill(const Shape& shape, const Pose& X_BS, std::size_t link);

  LegChain chain_;
  double spacing_m_;
  std::vector<LinkBall> balls_;  // by link, base first
};

}  // namespace gaitwright
