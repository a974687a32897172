// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/step_limits.h"

#include <algorithm>
#include <cmath>

#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

constexpr double kFar = 100.0;  // [m]

/// Level ground across a heading, between two distances along it.
TerrainPatch Band(double heading_rad, double from_m, double to_m, double height_m) {
  TerrainPatch patch;
  patch.name = "band";
  patch.X_WT.linear() = Eigen::AngleAxisd(heading_rad, Vector3::UnitZ()).toRotationMatrix();
  patch.X_WT.translation().z() = height_m;
  patch.outline_T = {{from_m, -kFar}, {to_m, -kFar}, {to_m, kFar}, {from_m, kFar}};
  return patch;
}

}  // namespace

StepLimits::StepLimits(const RobotModel& model, const FootstepQuery& query, const FootholdOptions& footholds,
                       const FootstepSearchOptions& options, double heading_rad)
    : model_(&model), query_(query), footholds_(footholds), options_(options), heading_rad_(heading_rad) {
  constexpr int kExpansions = 1500;
  options_.max_expansions = std::min(options.max_expansions, kExpansions);
  options_.improving_expansions = 0;
  query_.body_free = nullptr;
  for (const Pose& X_BF : StandingFeet(model)) spread_m_ = std::max(spread_m_, X_BF.translation().head<2>().norm());
  spread_m_ += 0.5 * model.leg_length_m();
}

bool StepLimits::Passes(double gap_m, double rise_m) const {
  FootstepQuery query = query_;
  const double length = 2.0 * spread_m_ + gap_m;
  query.route = RouteAlong({length * std::cos(heading_rad_), length * std::sin(heading_rad_), 0.0}, 0.0);
  Terrain terrain;
  terrain.patches = {Band(heading_rad_, -kFar, spread_m_, 0.0),
                     Band(heading_rad_, spread_m_ + gap_m, spread_m_ + kFar, rise_m)};
  return FootstepsExist(*model_, terrain, query, footholds_, options_);
}

template <class Test>
double StepLimits::Largest(double most_m, const Test& passes) const {
  double low = 0.0, high = most_m;
  while (high - low > 0.01 * model_->leg_length_m()) {
    const double middle = 0.5 * (low + high);
    (passes(middle) ? low : high) = middle;
  }
  return low;
}

double StepLimits::WidestGap(double most_m) const {
  return Largest(most_m, [this](double gap) { return Passes(gap, 0.0); });
}

double StepLimits::HighestStep(double most_m, bool up) const {
  return Largest(most_m, [this, up](double rise) { return Passes(0.0, up ? rise : -rise); });
}

}  // namespace gaitwright
