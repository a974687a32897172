// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Finds pairs of links that touch in a motion, and links that touch the ground but belong to no foot, and lets a
/// BodyProblem keep them apart. Links that never touch cost nothing in the problem.
class ApartPairs {
 public:
  /// The model must outlive this. @param margin_m  distance that links are to keep at knots; at most half of what they
  /// have in the standing posture. @param ground  solids that links are to keep from as well.
  /// @throws InvalidArgument unless it is positive.
  ApartPairs(const RobotModel& model, double margin_m, FixedSolids ground = {});

  /// Looks at a motion every `step_s`. Each pair that comes nearer there than a quarter of its margin is listed in the
  /// problem (BodyKnot::apart) at all knots near which its links are close; a pair that is listed at all of these knots
  /// already is to keep a larger distance. Where the problem pins its first posture, and the links are nearer there
  /// than their margin, their distance may rise to the margin over a short time.
  /// @return whether any pair comes nearer than a quarter of its margin.
  bool Watch(const WholeBodyTrajectory& motion, BodyProblem& problem, double step_s = 1e-3);

  /// Takes all pairs out of a problem.
  static void Clear(BodyProblem& problem);

  /// Whether any pair was listed.
  bool lists() const { return !wanted_m_.empty(); }
  /// The links of the pairs that were listed, in the order of the model's shapes.
  std::vector<std::string> Listed() const;

 private:
  /// The smallest distances of pairs that come nearer than a quarter of their margin.
  std::map<int, double> Touching(const WholeBodyTrajectory& motion, double step_s);
  std::vector<bool> CloseAt(int pair, const WholeBodyTrajectory& motion, const std::vector<double>& times_s);
  bool ListAt(int pair, const std::vector<bool>& close, BodyProblem& problem);
  double MarginOf(int pair) const { return std::min(margin_m_, 0.5 * distances_.standing_m(pair)); }
  double RampedMargin(int pair, const BodyProblem& problem, double time_s);

  const RobotModel& model_;
  const double margin_m_;
  LinkDistances distances_;
  DynamicsScratch scratch_;
  std::map<int, double> wanted_m_;  // of listed pairs
};

}  // namespace gaitwright
