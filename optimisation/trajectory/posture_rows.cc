// SPDX-License-Identifier: BSD-3-Clause
// Rows of a knot that depend on the posture alone: feet, distances of links, and points that are to be near places.
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

/// Change of the rotation vector of R when R turns by a small vector in W: the inverse of the left Jacobian of SO(3).
Matrix3 LogDerivative(const Vector3& turn) {
  const double angle = turn.norm();
  const Matrix3 K = Skew(turn);
  constexpr double kSmall = 1e-4;
  const double second = angle < kSmall
                            ? 1.0 / 12.0
                            : (1.0 - 0.5 * angle * std::cos(0.5 * angle) / std::sin(0.5 * angle)) / (angle * angle);
  return Matrix3::Identity() - 0.5 * K + second * K * K;
}

}  // namespace

/// Needs the knot model where the knot is.
void BodyRows::EvaluatePosture(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives) {
  if (knot.posture.size() == 0) return;
  const Index feet = EvaluateFeet(knot, asked, with_derivatives);
  EvaluateApart(knot, asked, with_derivatives, feet);
  EvaluatePoints(knot, asked, with_derivatives, feet + CountOf(knot, asked, kApart));
}

/// @return how many rows these are.
Index BodyRows::EvaluateFeet(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives) {
  Index row = 0;
  MatrixX by_v;
  for (const FootGoal& goal : asked.feet) {
    const Foot& foot = model_.feet[static_cast<std::size_t>(goal.foot)];
    knot_model_.FootAt(goal.foot, with_derivatives != nullptr, foot_);
    const auto index = static_cast<std::size_t>(&goal - asked.feet.data());
    const Vector3 p_W = knot.shift_W.empty() ? goal.p_W : (goal.p_W + knot.shift_W[index]).eval();
    Vector6 off;
    const Vector3 rolled = foot.radius > 0.0 ? RotationLog(foot_.R_WF * goal.R_roll.transpose()) : Vector3::Zero();
    const Vector3 turned = RotationLog(foot_.R_WF * goal.R_W.transpose());
    off << goal.axes_W.transpose() * (foot_.p_WF - p_W - foot.radius * rolled.cross(goal.normal_W)),
        goal.R_W.transpose() * turned;
    if (with_derivatives != nullptr) {
      by_v.resize(6, n_);
      by_v.topRows<3>() =
          goal.axes_W.transpose() *
          (foot_.J.topRows<3>() + foot.radius * Skew(goal.normal_W) * LogDerivative(rolled) * foot_.J.bottomRows<3>());
      by_v.bottomRows<3>() = goal.R_W.transpose() * LogDerivative(turned) * foot_.J.bottomRows<3>();
      by_v.middleCols<3>(3) = (by_v.middleCols<3>(3) * with_derivatives->turn.E).eval();
    }
    for (std::size_t i = 0; i < 6; ++i) {
      if (!goal.rows[i]) continue;
      knot.posture[row] = kFootUnit * off[static_cast<Index>(i)];
      if (with_derivatives != nullptr) knot.J.row(row) = kFootUnit * by_v.row(static_cast<Index>(i));
      ++row;
    }
  }
  return row;
}

void BodyRows::EvaluateApart(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives, Index first) {
  VectorX gradient;
  for (const ApartPair& pair : asked.apart) {
    problem_.distances->PointsAt(pair.pair, knot_model_.kinematics(), apart_points_);
    for (const ConvexDistance& at : apart_points_) {
      knot.posture[first] = kApartUnit * at.distance_m;
      if (with_derivatives != nullptr) {
        gradient.setZero(n_);
        problem_.distances->AddGradient(pair.pair, at, knot_model_.kinematics(), kApartUnit, gradient);
        gradient.segment<3>(3) = (with_derivatives->turn.E.transpose() * gradient.segment<3>(3)).eval();
        knot.J.row(first) = gradient.transpose();
      }
      ++first;
    }
  }
}

void BodyRows::EvaluatePoints(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives, Index first) {
  if (asked.points.empty()) return;
  const DynamicsScratch& s = knot_model_.kinematics();
  MatrixX J(6, n_);
  for (const PointGoal& goal : asked.points) {
    const auto body = static_cast<std::size_t>(goal.body);
    const Vector3 p_WQ = s.p_WB[body] + s.R_WB[body] * goal.p_BQ, from_base_W = p_WQ - s.p_WB[0];
    const Matrix3 R_BW = s.R_WB[0].transpose();
    const Vector3 place = goal.in_base ? Vector3(R_BW * from_base_W) : p_WQ;
    knot.posture.segment<3>(first) = goal.weight * (place - goal.p_W);
    if (with_derivatives != nullptr) {
      J.setZero();
      PointJacobian(model_, s, goal.body, goal.p_BQ, J);
      if (goal.in_base) {  // the base carries the point along, and its axes too
        J.topRows<3>().leftCols<6>().setZero();
        J.topRows<3>() = (R_BW * J.topRows<3>()).eval();
      }
      J.middleCols<3>(3) = (J.middleCols<3>(3) * with_derivatives->turn.E).eval();
      knot.J.middleRows<3>(first) = goal.weight * J.topRows<3>();
    }
    first += 3;
  }
}

}  // namespace gaitwright
