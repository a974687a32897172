// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_terms.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// Five uniform places in an interval, and weights that integrate a polynomial of degree four exactly over the interval
/// and over its first half.
constexpr std::size_t kPlaces = 5;
constexpr std::array<double, kPlaces> kWhole = {7.0 / 90, 32.0 / 90, 12.0 / 90, 32.0 / 90, 7.0 / 90};
constexpr std::array<double, kPlaces> kHalf = {29.0 / 360, 124.0 / 360, 24.0 / 360, 4.0 / 360, -1.0 / 360};

/// Rotation rows, in local indices of the unknowns.
struct TurningTerm {
  struct Carried {
    FootPlace place;
    AffineVector from, to;
    Vector3 moves;  // displacement of the contact point over the interval
  };

  Matrix3 inverse_B;    // of the inertia over its mean
  double h, per_force;  // per_force: m g over the mean inertia
  AffineVector angles_from, angles_to, momentum_from, momentum_to;
  std::array<AffineVector, kPlaces> com;
  AffineVector whole_from, whole_to;
  std::vector<Carried> carried;
  Vector3 lost_by_half, lost;     // momentum given to the legs, until the middle and the end
  std::array<Vector3, 3> unseen;  // corrections at start, middle and end for the rest of the interval

  /// For a force that is linear from `from` to `to`: integral over the first part of an interval, over its length,
  ///   from * from_share + to * to_share,
  /// and the integral of the same times the elapsed share of the interval.
  struct Shares {
    double from, to, from_moved, to_moved;
  };

  /// Adds the impulse until the middle or the end, by `weights`, to `value` with its derivatives.
  void AddImpulse(const VectorX& x, const std::array<double, kPlaces>& weights, const Shares& share, Vector3& value,
                  MatrixX* J) const {
    const double unit = h * per_force;
    if (carried.empty()) return;
    for (const Carried& c : carried) {
      const Vector3 p = c.place.At(x), from = c.from.At(x), to = c.to.At(x);
      const Vector3 f = share.from * from + share.to * to;
      value += unit * (p.cross(f) + c.moves.cross(share.from_moved * from + share.to_moved * to));
      if (J == nullptr) continue;
      c.from.AddTo(Matrix3(unit * Skew(share.from * p + share.from_moved * c.moves)), *J, 0);
      c.to.AddTo(Matrix3(unit * Skew(share.to * p + share.to_moved * c.moves)), *J, 0);
      c.place.AddTo(Matrix3(-unit * Skew(f)), *J, 0);
    }
    const Vector3 F_from = whole_from.At(x), F_to = whole_to.At(x);
    Matrix3 by_from = Matrix3::Zero(), by_to = Matrix3::Zero();
    for (std::size_t q = 0; q < kPlaces; ++q) {
      const double u = static_cast<double>(q) / (kPlaces - 1), w = unit * weights[q];
      const Vector3 p = com[q].At(x), F = (1.0 - u) * F_from + u * F_to;
      value -= w * p.cross(F);
      if (J == nullptr) continue;
      by_from -= w * (1.0 - u) * Skew(p);
      by_to -= w * u * Skew(p);
      com[q].AddTo(Matrix3(w * Skew(F)), *J, 0);
    }
    if (J == nullptr) return;
    whole_from.AddTo(by_from, *J, 0);
    whole_to.AddTo(by_to, *J, 0);
  }

  static constexpr Shares kWholeShares = {1.0 / 2, 1.0 / 2, 1.0 / 6, 1.0 / 3};
  static constexpr Shares kHalfShares = {3.0 / 8, 1.0 / 8, 1.0 / 12, 1.0 / 24};

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    const Vector3 from = angles_from.At(x), to = angles_to.At(x), l_from = momentum_from.At(x),
                  l_to = momentum_to.At(x);
    Vector3 gained = -lost, l_mid = l_from - lost_by_half;
    MatrixX by_gained, by_mid;
    if (J != nullptr) {
      by_gained = by_mid = MatrixX::Zero(3, J->cols());
      momentum_from.AddTo(Matrix3::Identity(), by_mid, 0);
    }
    AddImpulse(x, kWhole, kWholeShares, gained, J != nullptr ? &by_gained : nullptr);
    AddImpulse(x, kHalf, kHalfShares, l_mid, J != nullptr ? &by_mid : nullptr);
    const AnglesBetween middle(inverse_B, h, 0.5, {from, l_from + unseen[0]}, {to, l_to + unseen[2]});
    const TurningRate rate = TurningRateOf(inverse_B, middle.value, l_mid + unseen[1]);
    value.resize(6);
    value.head<3>() = l_to - l_from - gained;
    value.tail<3>() = to - from - h / 6.0 * (middle.rate_from.rate + 4.0 * rate.rate + middle.rate_to.rate);
    if (J == nullptr) return;
    J->topRows(3) = -by_gained;
    momentum_to.AddTo(Matrix3::Identity(), *J, 0);
    momentum_from.AddTo(-Matrix3::Identity(), *J, 0);
    J->bottomRows(3) = -h * 4.0 / 6.0 * rate.by_momentum * by_mid;
    const Matrix3 by_mid_angles = 4.0 * rate.by_angles;
    angles_to.AddTo(Matrix3(Matrix3::Identity() - h / 6.0 * (by_mid_angles * middle.by_to + middle.rate_to.by_angles)),
                    *J, 3);
    angles_from.AddTo(
        Matrix3(-Matrix3::Identity() - h / 6.0 * (by_mid_angles * middle.by_from + middle.rate_from.by_angles)), *J, 3);
    momentum_to.AddTo(Matrix3(-h / 6.0 * (by_mid_angles * middle.by_l_to + middle.rate_to.by_momentum)), *J, 3);
    momentum_from.AddTo(Matrix3(-h / 6.0 * (by_mid_angles * middle.by_l_from + middle.rate_from.by_momentum)), *J, 3);
  }
};

/// The legs' angular momentum l varies faster within an interval than the three places of the rule resolve. Rates of
/// angles are linear in momentum, and the angles' part is quadratic over the interval. The contribution of l is
/// therefore exact if l is replaced at the three places by its integrals with Lagrange's polynomials divided by their
/// weights. The result is the correction to be added to the body's momentum (the total minus l) at these places:
std::array<Vector3, 3> UnseenOf(const LegMomentum& inner, double start_s, double h) {
  constexpr double kStep = 2.5e-3;  // [s]
  constexpr std::array<double, 3> kWeights = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  std::array<Vector3, 3> means = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  const int steps = inner.empty() ? 0 : 2 * std::max(1, static_cast<int>(std::ceil(0.5 * h / kStep - 1e-9)));
  for (int k = 0; k <= steps && steps > 0; ++k) {
    const double u = static_cast<double>(k) / steps;
    const double simpson = (k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) / (3.0 * steps);
    const std::array<double, 3> basis = {(1.0 - u) * (1.0 - 2.0 * u), 4.0 * u * (1.0 - u), u * (2.0 * u - 1.0)};
    const Vector3 l = inner.At(start_s + u * h);
    for (std::size_t i = 0; i < 3; ++i) means[i] += simpson * basis[i] / kWeights[i] * l;
  }
  for (std::size_t i = 0; i < 3; ++i) means[i] = inner.At(start_s + 0.5 * static_cast<double>(i) * h) - means[i];
  return means;
}

}  // namespace

Constraint RigidBodyTerms::Turning(std::size_t interval) const {
  const std::vector<double>& nodes = unknowns_.nodes_s();
  SeenUnknowns seen;
  TurningTerm term;
  term.inverse_B = unknowns_.mean_inertia() * problem_.inertia_B.inverse();
  term.h = nodes[interval + 1] - nodes[interval];
  term.per_force = problem_.mass_kg * kGravity / unknowns_.mean_inertia();
  term.angles_from = seen.See(unknowns_.Angles(interval));
  term.angles_to = seen.See(unknowns_.Angles(interval + 1));
  term.momentum_from = seen.See(unknowns_.Momentum(interval));
  term.momentum_to = seen.See(unknowns_.Momentum(interval + 1));
  if (!unknowns_.Forces(interval).empty()) {
    for (std::size_t q = 0; q < kPlaces; ++q) {
      const double u = static_cast<double>(q) / (kPlaces - 1);
      term.com[q] = seen.See(unknowns_.CentreOfMass(nodes[interval] + u * term.h));
    }
    term.whole_from = seen.See(unknowns_.WholeForce(interval));
    term.whole_to = seen.See(unknowns_.WholeForce(interval + 1));
  }
  for (const ContactForce& force : unknowns_.Forces(interval)) {
    const RigidStance& stance = problem_.stances[force.stance];
    FootPlace place = unknowns_.ContactPoint(force.stance, force.point);
    const Vector3 moved = stance.MovedAt(nodes[interval]);
    place.constant += moved;
    term.carried.push_back(
        {place.SeenBy(seen), seen.See(force.from), seen.See(force.to), stance.MovedAt(nodes[interval + 1]) - moved});
  }
  const Vector3 at_start = inner_.At(nodes[interval]);
  term.lost_by_half = (inner_.At(nodes[interval] + 0.5 * term.h) - at_start) / unknowns_.mean_inertia();
  term.lost = (inner_.At(nodes[interval + 1]) - at_start) / unknowns_.mean_inertia();
  term.unseen = UnseenOf(inner_, nodes[interval], term.h);
  for (Vector3& l : term.unseen) l /= unknowns_.mean_inertia();
  return OfKind(RigidBodyRowKind::kTurning, {fmt::format("turning from {:.3f} s on", nodes[interval]), term,
                                             VectorX::Zero(6), VectorX::Zero(6), seen.variables()});
}

Constraint RigidBodyTerms::Free(std::size_t at_node) const {
  SeenUnknowns seen;
  VectorFunction rows = AffineRows(unknowns_.WholeForce(at_node), Matrix3::Identity(), Vector3::Zero(), seen);
  return OfKind(RigidBodyRowKind::kFreeFlight, {fmt::format("free flight at {:.3f} s", unknowns_.nodes_s()[at_node]),
                                                rows, Vector3::Zero(), Vector3::Zero(), seen.variables(), true});
}

Constraint RigidBodyTerms::Friction(const BoundForce& force, int sides, double margin) const {
  const RigidStance& stance = problem_.stances[force.stance];
  const double across = std::numbers::pi / sides;
  const double least = stance.friction * std::cos(across);
  MatrixX directions(sides + 1, 3);
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * across;
    directions.row(i) << std::cos(angle), std::sin(angle), -least;
  }
  directions.row(sides) << 0.0, 0.0, 1.0;
  const double most = problem_.feet[static_cast<std::size_t>(stance.foot)].force_max_n / (problem_.mass_kg * kGravity);
  VectorX upper = VectorX::Constant(sides + 1, -margin);
  upper[sides] = most - margin;
  SeenUnknowns seen;
  VectorFunction rows =
      AffineRows(force.force, directions * stance.X_WF.linear().transpose(), VectorX::Zero(sides + 1), seen);
  return OfKind(RigidBodyRowKind::kFriction,
                {fmt::format("friction of foot {} at {:.3f} s", stance.foot, unknowns_.nodes_s()[force.at_node]), rows,
                 VectorX::Constant(sides + 1, -kInfinity), upper, seen.variables(), true});
}

Constraint RigidBodyTerms::Motors(const std::vector<BoundForce>& forces) const {
  const BoundForce& first = forces.front();
  const RigidStance& stance = problem_.stances[first.stance];
  const double time_s = unknowns_.nodes_s()[first.at_node], weight = problem_.mass_kg * kGravity;
  const MotorLimits& limits = *stance.MotorsAt(time_s);
  SeenUnknowns seen;
  std::vector<AffineVector> own;
  for (const BoundForce& force : forces) own.push_back(seen.See(force.force));
  // Divided by the range of the limits, so that all rows have similar scales.
  const VectorX unit = (0.5 * (limits.upper - limits.lower)).cwiseMax(1e-6);
  const MatrixX by_force = weight * unit.cwiseInverse().asDiagonal() * limits.by_force;
  const auto rows = [own, by_force](const VectorX& x, VectorX& value, MatrixX* J) {
    value = VectorX::Zero(by_force.rows());
    for (std::size_t i = 0; i < own.size(); ++i) {
      const MatrixX by_own = by_force.middleCols<3>(static_cast<Eigen::Index>(3 * i));
      value += by_own * own[i].At(x);
      if (J != nullptr) own[i].AddTo(by_own, *J, 0);
    }
  };
  return OfKind(RigidBodyRowKind::kMotors,
                {fmt::format("motors of foot {} at {:.3f} s", stance.foot, time_s), rows,
                 limits.lower.cwiseQuotient(unit), limits.upper.cwiseQuotient(unit), seen.variables(), true});
}

Constraint RigidBodyTerms::Rise(double time_s) const {
  SeenUnknowns seen;
  const VectorX most = VectorX::Constant(1, problem_.rise_max_m_s);
  VectorFunction rows = AffineRows(unknowns_.Velocity(time_s), Vector3::UnitZ().transpose(), VectorX::Zero(1), seen);
  return OfKind(RigidBodyRowKind::kRise,
                {fmt::format("rise at {:.3f} s", time_s), rows, -most, most, seen.variables(), true});
}

Constraint RigidBodyTerms::Region(std::size_t stance) const {
  const std::vector<Vector2>& corners = problem_.stances[stance].region_F;
  const auto n = static_cast<Eigen::Index>(corners.size());
  MatrixX normals(n, 2);
  VectorX upper(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector2& corner = corners[static_cast<std::size_t>(i)];
    const Vector2 along = corners[static_cast<std::size_t>((i + 1) % n)] - corner;
    const Vector2 outward = Vector2(along.y(), -along.x()).normalized();
    normals.row(i) = outward;
    upper[i] = outward.dot(corner);
  }
  const int start = unknowns_.Foothold(stance).parts.front().start;
  const auto rows = [normals](const VectorX& x, VectorX& value, MatrixX* J) {
    value = normals * x;
    if (J != nullptr) *J = normals;
  };
  return OfKind(RigidBodyRowKind::kRegion,
                {fmt::format("region of foot {}'s foothold from {:.3f} s on", problem_.stances[stance].foot,
                             problem_.stances[stance].start_s),
                 rows,
                 VectorX::Constant(n, -kInfinity),
                 upper,
                 {start, start + 1},
                 true});
}

}  // namespace gaitwright
