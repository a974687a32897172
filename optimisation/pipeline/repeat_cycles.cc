// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/repeat_cycles_internal.h"
#include "planning/plan/steady_stretch.h"

namespace gaitwright {
namespace {

constexpr double kSamePlace = 1e-5;  // [m], [rad]

/// The displacement of all feet of legs from around one time to around another; nothing if they are not displaced
/// alike.
std::optional<CycleTie> DisplacementOf(const std::vector<FootCourse>& courses, double from_s, double to_s) {
  constexpr double kAround = 0.01;  // [s]
  std::optional<CycleTie> tie;
  for (const FootCourse& course : courses) {
    for (const double shift_s : {-kAround, 0.0, kAround}) {
      const Pose from = course.At(from_s + shift_s).X_WF, to = course.At(to_s + shift_s).X_WF;
      const double yaw_rad = YawOf(to.linear() * from.linear().transpose());
      const Vector3 move_W = to.translation() - YawRotation(yaw_rad) * from.translation();
      if (!tie) tie = CycleTie{0, yaw_rad, move_W};
      if (std::abs(yaw_rad - tie->yaw_rad) > kSamePlace || (move_W - tie->move_W).norm() > kSamePlace)
        return std::nullopt;
    }
  }
  return tie;
}

}  // namespace

std::vector<RepeatedCycles> CyclesToRepeat(const MotionPlan& plan, const std::vector<FootCourse>& courses) {
  std::vector<RepeatedCycles> all;
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    const std::optional<SteadyStretch> stretch = SteadyStretchOf(plan, part, kNearlySteady);
    if (!stretch || TurnsOver(plan.parts[part].gait)) continue;
    RepeatedCycles longest;
    for (int first = 0; first < stretch->cycles; ++first) {
      RepeatedCycles here;
      for (int i = first; i <= stretch->cycles; ++i) {
        const double time_s = stretch->start_s + i * stretch->cycle_s;
        std::optional<CycleTie> tie = DisplacementOf(courses, stretch->start_s + first * stretch->cycle_s, time_s);
        if (!tie) break;
        tie->cycle = static_cast<int>(all.size());
        here.time_s.push_back(time_s);
        here.displacement.push_back(*tie);
      }
      if (here.count() > longest.count()) longest = here;
    }
    if (longest.count() > 0) all.push_back(longest);
  }
  return all;
}

void TieCycles(const std::vector<RepeatedCycles>& all, BodyProblem& problem) {
  for (const RepeatedCycles& cycles : all) {
    for (std::size_t i = 0; i < cycles.time_s.size(); ++i) {
      const auto nearer = [&](double a, double b) {
        return std::abs(a - cycles.time_s[i]) < std::abs(b - cycles.time_s[i]);
      };
      const auto at =
          static_cast<std::size_t>(std::ranges::min_element(problem.time_s, nearer) - problem.time_s.begin());
      BodyKnot& knot = problem.knots[at];
      knot.tie = cycles.displacement[i];
      if (i == 0) continue;
      // The state decides where feet are, and with their places at the knots beside it their rates and accelerations.
      for (std::size_t k = at - 1; k <= at + 1; ++k) {
        for (FootGoal& goal : problem.knots[k].feet) goal.rows = {};
      }
    }
  }
}

}  // namespace gaitwright
