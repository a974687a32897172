// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Two links that touch, and how far one would have to move for them to part.
struct Overlap {
  std::string link_a, link_b;
  double depth_m = 0.0;
};

/// Finds parts of a robot that touch each other. Pairs that say nothing are left out: shapes of one body, of bodies
/// that a joint joins (or joints whose axes meet in one point, or bodies without shapes between them), and pairs that
/// already touch in the standing posture.
class CollisionChecker {
 public:
  explicit CollisionChecker(const RobotModel& model);
  ~CollisionChecker();
  CollisionChecker(CollisionChecker&&) noexcept;
  CollisionChecker& operator=(CollisionChecker&&) noexcept;

  /// All pairs that touch at the scratch's pose, with their depths. Meant for motions: a pair is looked at again only
  /// once its parts may have moved as far as they were apart, so poses that differ little cost little; the answer does
  /// not depend on it. Needs ForwardKinematics.
  /// Conservative advancement: Mirtich, Impulse-based Dynamic Simulation, 1996, section 2.3.
  const std::vector<Overlap>& Overlaps(const DynamicsScratch& scratch);

  /// Pairs left out because they touch in the standing posture, and meshes without vertices; for people.
  const std::vector<std::string>& notes() const;
  int num_pairs() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace gaitwright
