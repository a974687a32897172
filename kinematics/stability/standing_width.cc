// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/standing_width_internal.h"

namespace gaitwright {
namespace {

/// Smallest width of a polygon in any direction; it is perpendicular to one of the edges. An edge of almost no length
/// has an arbitrary direction, so the extents on both sides of each edge are added.
double WidthOf(const Polygon& polygon) {
  if (polygon.size() < 3) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 edge = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
    double low = 0.0, high = 0.0;
    for (const Vector2& p : polygon) {
      const Vector2 r = p - polygon[i];
      const double across = edge.x() * r.y() - edge.y() * r.x();
      low = std::min(low, across);
      high = std::max(high, across);
    }
    least = std::min(least, high - low);
  }
  return least;
}

}  // namespace

double StandingWidth(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::vector<Vector2> corners;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const Vector3& p_W : ContactPoints(model, scratch, foot)) corners.push_back(p_W.head<2>());
  }
  return WidthOf(ConvexHull(std::move(corners)));
}

double LeastStandingWidth(const RobotModel& model) { return 0.01 * model.leg_length_m(); }

bool CanStandStill(const RobotModel& model) { return StandingWidth(model) >= LeastStandingWidth(model); }

}  // namespace gaitwright
