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

/// Two links that are not checked for collision, with the reason.
struct LeftOutPair {
  std::string link_a, link_b;
  bool adjacent = false;  ///< a joint joins them; else they touch as the robot stands
  std::string reason;     ///< "adjacent: ...", "always touching: ..." or "touching in the standing posture, ..."

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
