// SPDX-License-Identifier: BSD-3-Clause
// Bounds and names of the rows of a whole body's trajectory.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

constexpr double kToMargin = 0.3;    // [s] in which joints that stand at the end of their range come to its margin
constexpr double kOfLanding = 0.18;  // of the distance from the standing posture: largest margin for landings

}  // namespace

/// The pair of a row of distances.
const ApartPair& BodyRows::PairOf(const BodyKnot& asked, Index apart_row) const {
  for (const ApartPair& pair : asked.apart) {
    apart_row -= problem_.distances->num_points(pair.pair);
    if (apart_row < 0) return pair;
  }
  throw InvalidArgument("BodyRows: no pair of links has this row");
}

RowBounds BodyRows::BoundsOf(Index row) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), row,
                                      [](Index r, const Knot& knot) { return r < knot.row[kDynamics]; });
  const Knot& knot = *(above - 1);
  if (row >= knot.row[kEffortLimit] && row < knot.row[kRange]) return {-1.0, 1.0};
  if (row >= knot.row[kJerk] && row < knot.row[kKinds]) return {-1.0, 1.0};
  if (row >= knot.row[kRange] && row < knot.row[kCone]) {
    const int dof = ranged_[static_cast<std::size_t>(row - knot.row[kRange])];
    if (problem_.StaysStill(dof)) {
      const double place = problem_.knots.front().reference.x[6 + dof];
      return {place, place};
    }
    const double lower = model_.dof_lower(dof), upper = model_.dof_upper(dof);
    const double standing = std::clamp(model_.standing_joints[dof], lower, upper);
    const double margin = std::min(problem_.use.range_margin, 0.25 * (upper - lower));
    const auto margin_to = [&](double end) {
      return std::max(margin, std::min(problem_.use.landing_margin, kOfLanding * std::abs(end - standing)));
    };
    const double now_s = problem_.time_s[static_cast<std::size_t>(&knot - knots_.data())];
    const double ramp = std::min(1.0, std::min(now_s - problem_.start_s(), problem_.end_s() - now_s) / kToMargin);
    const double low = lower + margin_to(lower), high = upper - margin_to(upper);
    return {low + (1.0 - ramp) * std::min(0.0, standing - low), high + (1.0 - ramp) * std::max(0.0, standing - high)};
  }
  if (row >= knot.row[kFeet] && row < knot.row[kEffortLimit]) {
    const RowBounds& bounds = knot.of_feet[static_cast<std::size_t>(row - knot.row[kFeet])];
    return {kFootUnit * bounds.lower, kFootUnit * bounds.upper};
  }
  if (row >= knot.row[kCone] && row < knot.row[kApart]) return {-kNone, -problem_.use.cone_margin};
  if (row >= knot.row[kApart] && row < knot.row[kPinnedPlace]) {
    const BodyKnot& asked = Asked(static_cast<std::size_t>(&knot - knots_.data()));
    return {kApartUnit * problem_.use.apart * PairOf(asked, row - knot.row[kApart]).least_m, kNone};
  }
  return {0.0, 0.0};
}

std::string BodyRows::NameOf(Index row) const {
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), row,
                                      [](Index r, const Knot& knot) { return r < knot.row[kDynamics]; });
  const auto k = static_cast<std::size_t>(above - knots_.begin() - 1);
  const Knot& knot = knots_[k];
  const auto at = [&](Kind kind) { return static_cast<std::size_t>(row - knot.row[kind]); };
  const auto motor = [&](int index) { return motors_.motors()[static_cast<std::size_t>(index)].name; };
  const auto within = [&](Kind kind) { return row >= knot.row[kind] && row < knot.row[kind + 1]; };
  std::string what = "start and end";
  if (within(kDynamics)) what = at(kDynamics) < 3 ? "balance of forces" : "balance of moments";
  if (within(kEffortLimit)) what = fmt::format("torque of '{}'", motor(motors_.limited()[at(kEffortLimit)]));
  if (within(kCurve)) {
    const MotorRows::Curve& curve = motors_.curves()[at(kCurve)];
    what = fmt::format("{} of '{}'", curve.by_effort > 0.0 ? "torque at speed" : "speed", motor(curve.motor));
  }
  if (within(kAcceleration)) {
    const int dof = accelerated_[at(kAcceleration)];
    what = fmt::format("acceleration of '{}'", model_.dof_names[static_cast<std::size_t>(dof)]);
  }
  if (within(kJerk)) what = fmt::format("jerk of '{}'", model_.dof_names[static_cast<std::size_t>(jerked_[at(kJerk)])]);
  if (within(kTied)) what = "repetition of the cycle";
  if (within(kRange))
    what = fmt::format("position of '{}'", model_.dof_names[static_cast<std::size_t>(ranged_[at(kRange)])]);
  const auto foot_name = [&](int foot) { return model_.feet[static_cast<std::size_t>(foot)].name; };
  if (within(kFeet)) {
    Index left = row - knot.row[kFeet];
    for (const FootGoal& goal : Asked(k).feet) {
      if (left >= 0 && left < goal.count())
        what = fmt::format("{} of foot '{}'", goal.swings ? "swing" : "foothold", foot_name(goal.foot));
      left -= goal.count();
    }
  }
  if (within(kApart))
    what = fmt::format("distance of {}", problem_.distances->NameOf(PairOf(Asked(k), row - knot.row[kApart]).pair));
  if (within(kCone)) {
    Index left = (row - knot.row[kCone]) / kPyramidSides;
    for (const PressingFoot& foot : Asked(k).pressing) {
      const auto points = static_cast<Index>(foot.contact.points_F.size());
      if (left >= 0 && left < points) what = fmt::format("friction cone of foot '{}'", foot_name(foot.contact.foot));
      left -= points;
    }
  }
  return fmt::format("{} at {:.3f} s", what, problem_.time_s[k]);
}

std::vector<double> BodyRows::TimesUnmet(double tolerance) const {
  std::vector<double> times;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    for (Index row = knots_[k].row[kDynamics]; row < knots_[k].row[kKinds]; ++row) {
      const RowBounds bounds = BoundsOf(row);
      if (value_[row] >= bounds.lower - tolerance && value_[row] <= bounds.upper + tolerance) continue;
      times.push_back(problem_.time_s[k]);
      break;
    }
  }
  return times;
}

}  // namespace gaitwright
