// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "optimisation/pipeline/press_soles_internal.h"

namespace gaitwright {
namespace {

constexpr double kSoleFrictionShare = 0.25;  // share of soles' friction that is used if possible

}  // namespace

PressingByKnot PressingOf(const BodyProblem& problem) {
  PressingByKnot pressing;
  for (const BodyKnot& knot : problem.knots) pressing.push_back(knot.pressing);
  return pressing;
}

void KeepFromEdges(const SoleMargin& margin, BodyProblem& problem) {
  for (BodyKnot& knot : problem.knots) {
    for (PressingFoot& foot : knot.pressing) {
      std::vector<Vector3>& points = foot.contact.points_F;
      Vector3 low = points.front(), high = low;
      for (const Vector3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
      const Vector3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
      for (Vector3& p : points) {
        for (Eigen::Index i = 0; i < 2; ++i) {
          const double share = half[i] > 0.0 ? std::min(margin.share, margin.distance_m / half[i]) : 0.0;
          p[i] = middle[i] + (p[i] - middle[i]) * (1.0 - share);
        }
      }
    }
  }
}

bool MayLowerSoleFriction(const RobotModel& model, const MotionPlan& plan, double friction_use) {
  constexpr double kLoaded = 0.3;  // of the weight: with a smaller load no direction matters
  constexpr double kLess = 0.5;    // of the horizontal force
  if (!std::ranges::any_of(model.feet, [](const Foot& foot) { return foot.has_sole(); })) return false;
  double friction = std::numeric_limits<double>::infinity();
  for (const Foothold& foothold : plan.footsteps.footholds)
    friction = std::min(friction, kSoleFrictionShare * friction_use * FrictionOf(plan.terrain, foothold.patch));
  return std::ranges::all_of(plan.whole_body.wrenches, [&](const std::vector<ContactWrench>& wrenches) {
    Vector3 sum_W = Vector3::Zero();
    for (const ContactWrench& wrench : wrenches) sum_W += wrench.force_W;
    return sum_W.z() < kLoaded * model.weight_n() || kLess * sum_W.head<2>().norm() <= friction * sum_W.z();
  });
}

void LowerSoleFriction(BodyProblem& problem) {
  constexpr std::size_t kSole = 3;  // points
  for (BodyKnot& knot : problem.knots) {
    for (PressingFoot& foot : knot.pressing) {
      if (foot.contact.points_F.size() >= kSole) foot.friction *= kSoleFrictionShare;
    }
  }
}

}  // namespace gaitwright
