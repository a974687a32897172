// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Two links that touch, with the distance that separates them again.
struct Overlap {
  std::string link_a, link_b;
  double depth_m = 0.0;
};

/// Two links that are not checked for collision, with the reason.
struct LeftOutPair {
  std::string link_a, link_b;
  bool adjacent = false;  ///< a joint connects them; otherwise they touch in the standing posture
  std::string reason;     ///< "adjacent: ...", "always touching, ..." or "touching in the standing posture, ..."

  bool operator==(const LeftOutPair&) const = default;
};

/// Finds self-collisions of a robot. These pairs are not checked: shapes of one body, bodies that are connected by a
/// joint (or by joints whose axes meet in one point, or by bodies without shapes), and pairs that already touch in the
/// standing posture.
class CollisionChecker {
 public:
  explicit CollisionChecker(const RobotModel& model);
  ~CollisionChecker();
  CollisionChecker(CollisionChecker&&) noexcept;
  CollisionChecker& operator=(CollisionChecker&&) noexcept;

  /// All pairs that touch at the scratch's pose, with their depths. For motions: a pair is checked again only when its
  /// parts may have moved by their distance, so small changes of the pose are cheap; the result does not depend on
  /// this. Needs ForwardKinematics. Conservative advancement: Mirtich, Impulse-based Dynamic Simulation, 1996, section
  /// 2.3.
  const std::vector<Overlap>& Overlaps(const DynamicsScratch& scratch);

  /// The nearest pair, if its distance is less than `within_m` by a tenth of a millimetre or more; otherwise a pair
  /// without names. Its depth is the negative distance. Pairs that cannot be the nearest are skipped as in Overlaps.
  Overlap Nearest(const DynamicsScratch& scratch, double within_m);

  /// Notes about meshes without vertices, for the user.
  const std::vector<std::string>& notes() const;
  /// Pairs of links that are not checked, in the order of the model's shapes; links of one body are not listed.
  const std::vector<LeftOutPair>& left_out() const;
  int num_pairs() const;
  /// The checked pairs, as indices of the model's collision shapes.
  const std::vector<std::pair<int, int>>& pairs() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace gaitwright
