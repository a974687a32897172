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

/// Two links that are not held against each other, and why.
struct LeftOutPair {
  std::string link_a, link_b;
  bool adjacent = false;  ///< a joint joins them; else they touch as the robot stands
  std::string reason;     ///< "adjacent: ...", "always touching: ..." or "touching in the standing posture: ..."

  bool operator==(const LeftOutPair&) const = default;
};

/// Finds parts of a robot that touch each other. Pairs that say nothing are left out: shapes of one body, of bodies
/// that a joint joins (or joints whose axes meet in one point, or bodies without shapes between them), and pairs that
/// already touch in the standing posture, whether or not they do so wherever the joints may be.
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

  /// The pair that is nearest of all, if nearer than `within_m` by a tenth of a millimetre, as links without names
  /// otherwise; its depth is negative by how far they are apart. Pairs that cannot be are passed over as by Overlaps.
  Overlap Nearest(const DynamicsScratch& scratch, double within_m);

  /// Meshes without vertices; for people.
  const std::vector<std::string>& notes() const;
  /// Pairs of links left out, by the order of the model's shapes; links of one body are not listed.
  const std::vector<LeftOutPair>& left_out() const;
  int num_pairs() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace gaitwright
