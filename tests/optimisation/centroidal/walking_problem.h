// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright::synthetic {

/// A rectangle around a point.
inline Polygon Sole(const Vector2& centre, const Vector2& half) {
  return {centre - half, centre + Vector2(half.x(), -half.y()), centre + half, centre + Vector2(-half.x(), half.y())};
}

inline void AddPhase(ZmpProblem& problem, double duration_s, const Polygon& from, const Polygon& to) {
  const double start_s = problem.phases.empty() ? problem.start_s : problem.phases.back().end_s;
  problem.phases.push_back({start_s, start_s + duration_s, from, to, Centroid(from), Centroid(to)});
}

/// Sets the number of samples. At changes of support and at the ends, preferred points move between their neighbours.
inline void Finish(ZmpProblem& problem) {
  auto& phases = problem.phases;
  problem.samples = 1 + static_cast<int>(std::lround((phases.back().end_s - problem.start_s) / problem.step_s));
  problem.zmp_offset.assign(static_cast<std::size_t>(problem.samples), Vector2::Zero());
  for (std::size_t i = 0; i < phases.size(); i += 2) {
    phases[i].preferred_start = i == 0 ? problem.start_W : phases[i - 1].preferred_end;
    phases[i].preferred_end = i + 1 == phases.size() ? problem.end_W : phases[i + 1].preferred_start;
  }
}

/// A biped with soles of 0.2 x 0.1 m that takes `steps` steps forward: 0.6 s on one foot, 0.2 s on both.
inline ZmpProblem Biped(int steps, double step_length_m = 0.25, double stand_s = 0.8) {
  ZmpProblem problem;
  problem.omega_rad_s = std::sqrt(kGravity / 0.8);
  problem.com_height_m = 0.8;
  const Vector2 half(0.1, 0.05);
  Vector2 foot[2] = {{0.0, 0.1}, {0.0, -0.1}};
  const auto both = [&] {
    Polygon corners = Sole(foot[0], half);
    const Polygon other = Sole(foot[1], half);
    corners.insert(corners.end(), other.begin(), other.end());
    return ConvexHull(corners);
  };
  const auto stand = [&](double duration_s) { AddPhase(problem, duration_s, both(), both()); };
  stand(stand_s);
  for (int i = 0; i < steps; ++i) {
    const int stance = i % 2;
    AddPhase(problem, 0.6, Sole(foot[stance], half), Sole(foot[stance], half));
    foot[1 - stance].x() = foot[stance].x() + (i + 1 < steps ? step_length_m : 0.0);
    stand(i + 1 < steps ? 0.2 : stand_s);
  }
  problem.end_W = 0.5 * (foot[0] + foot[1]);
  Finish(problem);
  return problem;
}

/// Diagonal pairs of point feet whose contacts roll by `roll_m` in each stance, with all four feet on the ground in
/// between.
inline ZmpProblem Trot(int steps, double advance_m = 0.05, double roll_m = 0.01) {
  ZmpProblem problem;
  problem.omega_rad_s = std::sqrt(kGravity / 0.28);
  problem.com_height_m = 0.28;
  // Left fore, right fore, left hind, right hind. A pair, and its contacts at the start of its stance.
  std::vector<Vector2> foot = {{0.18, 0.13}, {0.18, -0.13}, {-0.18, 0.13}, {-0.18, -0.13}};
  const int pairs[2][2] = {{0, 3}, {1, 2}};
  const auto all = [&](double duration_s) {
    const Polygon hull = ConvexHull(foot);
    AddPhase(problem, duration_s, hull, hull);
  };
  all(0.6);
  for (int i = 0; i < steps; ++i) {
    const int *stance = pairs[i % 2], *swing = pairs[1 - i % 2];
    const Polygon before = {foot[static_cast<std::size_t>(stance[0])], foot[static_cast<std::size_t>(stance[1])]};
    for (int k = 0; k < 2; ++k) {
      foot[static_cast<std::size_t>(stance[k])].x() += roll_m;
      foot[static_cast<std::size_t>(swing[k])].x() += i + 1 < steps ? advance_m : 0.0;
    }
    AddPhase(problem, 0.2, before,
             {foot[static_cast<std::size_t>(stance[0])], foot[static_cast<std::size_t>(stance[1])]});
    all(i + 1 < steps ? 0.04 : 0.6);
  }
  problem.end_W = Centroid(ConvexHull(foot));
  Finish(problem);
  return problem;
}

}  // namespace gaitwright::synthetic
