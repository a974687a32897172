// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_terms.h"

#include <ceres/jet.h>
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

template <typename T>
Eigen::Matrix<T, 3, 1> RatesOf(const Matrix3& inverse_B, const Eigen::Matrix<T, 3, 1>& angles,
                               const Eigen::Matrix<T, 3, 1>& momentum) {
  using std::cos, std::sin;
  const T sr = sin(angles.x()), cr = cos(angles.x()), sp = sin(angles.y()), cp = cos(angles.y());
  const T sy = sin(angles.z()), cy = cos(angles.z());
  // R^T l, one turn after the other.
  const T ahead = cy * momentum.x() + sy * momentum.y(), left = cy * momentum.y() - sy * momentum.x();
  const T down = sp * ahead + cp * momentum.z();
  const Eigen::Matrix<T, 3, 1> in_body(cp * ahead - sp * momentum.z(), cr * left + sr * down, cr * down - sr * left);
  const Eigen::Matrix<T, 3, 1> w = inverse_B.cast<T>() * in_body;
  const T yaw_rate = (sr * w.y() + cr * w.z()) / cp;
  return {w.x() + sp * yaw_rate, cr * w.y() - sr * w.z(), yaw_rate};
}

/// What a term sees of a FootPlace.
FootPlace SeenPlace(const FootPlace& place, SeenUnknowns& seen) {
  FootPlace own = place;
  for (FootPlace::Part& part : own.parts) part.start = seen.See(part.start, 2);
  return own;
}

template <typename Derived>
void AddPlace(const FootPlace& place, const Eigen::MatrixBase<Derived>& by, MatrixX& J, Eigen::Index row) {
  for (const FootPlace::Part& part : place.parts) J.block(row, part.start, by.rows(), 2) += by * part.axes;
}

/// Angles at a share u of an interval of length h by Hermite's cubic, with derivatives.
struct AnglesBetween {
  AnglesBetween(const Matrix3& inverse_B, double h, double u, const Vector3& from, const Vector3& l_from,
                const Vector3& to, const Vector3& l_to)
      : rate_from(TurningRateOf(inverse_B, from, l_from)), rate_to(TurningRateOf(inverse_B, to, l_to)) {
    const double v = 1.0 - u, of_from = v * v * (1.0 + 2.0 * u), of_to = u * u * (1.0 + 2.0 * v);
    const double of_rate_from = h * u * v * v, of_rate_to = -h * v * u * u;
    value = of_from * from + of_to * to + of_rate_from * rate_from.rate + of_rate_to * rate_to.rate;
    by_from = of_from * Matrix3::Identity() + of_rate_from * rate_from.by_angles;
    by_to = of_to * Matrix3::Identity() + of_rate_to * rate_to.by_angles;
    by_l_from = of_rate_from * rate_from.by_momentum;
    by_l_to = of_rate_to * rate_to.by_momentum;
  }

  TurningRate rate_from, rate_to;
  Vector3 value;
  Matrix3 by_from, by_to, by_l_from, by_l_to;
};

/// Five even places over an interval, and the weights with which a polynomial of degree four there has the integral
/// over all of it and over its first half.
constexpr std::size_t kPlaces = 5;
constexpr std::array<double, kPlaces> kWhole = {7.0 / 90, 32.0 / 90, 12.0 / 90, 32.0 / 90, 7.0 / 90};
constexpr std::array<double, kPlaces> kHalf = {29.0 / 360, 124.0 / 360, 24.0 / 360, 4.0 / 360, -1.0 / 360};

/// Turning, in its own numbers of the unknowns.
struct TurningTerm {
  struct Carried {
    FootPlace place;
    AffineVector from, to;
  };

  Matrix3 inverse_B;    // of the inertia over its mean
  double h, per_force;  // per_force: m g over the mean inertia
  AffineVector angles_from, angles_to, momentum_from, momentum_to;
  std::array<AffineVector, kPlaces> com;
  AffineVector whole_from, whole_to;
  std::vector<Carried> carried;

  /// The change of momentum up to the middle or the end, by `weights`, added to `value` with its derivatives; the
  /// contacts' forces have impulses from_share * from + to_share * to.
  void AddImpulse(const VectorX& x, const std::array<double, kPlaces>& weights, double from_share, double to_share,
                  Vector3& value, MatrixX* J) const {
    const double unit = h * per_force;
    if (carried.empty()) return;
    for (const Carried& c : carried) {
      const Vector3 p = c.place.At(x), f = from_share * c.from.At(x) + to_share * c.to.At(x);
      value += unit * p.cross(f);
      if (J == nullptr) continue;
      const Matrix3 by_force = unit * Skew(p), by_place = -unit * Skew(f);
      c.from.AddTo(Matrix3(from_share * by_force), *J, 0);
      c.to.AddTo(Matrix3(to_share * by_force), *J, 0);
      AddPlace(c.place, by_place, *J, 0);
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

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    const Vector3 from = angles_from.At(x), to = angles_to.At(x), l_from = momentum_from.At(x),
                  l_to = momentum_to.At(x);
    Vector3 gained = Vector3::Zero(), l_mid = l_from;
    MatrixX by_gained, by_mid;
    if (J != nullptr) {
      by_gained = by_mid = MatrixX::Zero(3, J->cols());
      momentum_from.AddTo(Matrix3::Identity(), by_mid, 0);
    }
    AddImpulse(x, kWhole, 0.5, 0.5, gained, J != nullptr ? &by_gained : nullptr);
    AddImpulse(x, kHalf, 0.375, 0.125, l_mid, J != nullptr ? &by_mid : nullptr);
    const AnglesBetween middle(inverse_B, h, 0.5, from, l_from, to, l_to);
    const TurningRate rate = TurningRateOf(inverse_B, middle.value, l_mid);
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

/// Rows n . R^T (p - c) of a workspace, at a share of an interval; at its start or end without what is beyond.
struct ReachTerm {
  MatrixX normals;
  FootPlace place;
  AffineVector com;
  Matrix3 inverse_B;
  double h, share;
  AffineVector angles_from, angles_to, momentum_from, momentum_to;

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    if (share == 0.0) {
      const MatrixX by_angles = Rows(x, angles_from.At(x), value, J);
      if (J != nullptr) angles_from.AddTo(by_angles, *J, 0);
      return;
    }
    const AnglesBetween between(inverse_B, h, share, angles_from.At(x), momentum_from.At(x), angles_to.At(x),
                                momentum_to.At(x));
    const MatrixX by_angles = Rows(x, between.value, value, J);
    if (J == nullptr) return;
    angles_from.AddTo(by_angles * between.by_from, *J, 0);
    angles_to.AddTo(by_angles * between.by_to, *J, 0);
    momentum_from.AddTo(by_angles * between.by_l_from, *J, 0);
    momentum_to.AddTo(by_angles * between.by_l_to, *J, 0);
  }

 private:
  /// @return the derivative by the angles.
  MatrixX Rows(const VectorX& x, const Vector3& angles, VectorX& value, MatrixX* J) const {
    const Matrix3 R_BW = RotationOf(angles).transpose();
    const Vector3 p_B = R_BW * (place.At(x) - com.At(x));
    value = normals * p_B;
    if (J == nullptr) return {};
    const MatrixX by_place = normals * R_BW;
    AddPlace(place, by_place, *J, 0);
    com.AddTo(-by_place, *J, 0);
    return normals * Skew(p_B) * BodyRatesByAngleRates(angles);
  }
};

/// Ends of a workspace's rows, with its normals.
Constraint WorkspaceOf(const RigidFoot& foot, double margin_m, MatrixX& normals) {
  const auto n = static_cast<Eigen::Index>(foot.workspace_B.size());
  Constraint rows{"", {}, VectorX::Constant(n, -kNoEnd), VectorX(n)};
  normals.resize(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WorkspaceSide& side = foot.workspace_B[static_cast<std::size_t>(i)];
    normals.row(i) = side.normal;
    rows.upper[i] = side.offset - margin_m;
  }
  return rows;
}

}  // namespace

Vector3 AngleRates(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum) {
  return RatesOf<double>(inverse_B, angles_rad, momentum);
}

TurningRate TurningRateOf(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum) {
  using Jet = ceres::Jet<double, 6>;
  Eigen::Matrix<Jet, 3, 1> angles, l;
  for (int i = 0; i < 3; ++i) {
    angles[i] = Jet(angles_rad[i], i);
    l[i] = Jet(momentum[i], 3 + i);
  }
  const Eigen::Matrix<Jet, 3, 1> rates = RatesOf<Jet>(inverse_B, angles, l);
  TurningRate turning;
  for (int i = 0; i < 3; ++i) {
    turning.rate[i] = rates[i].a;
    turning.by_angles.row(i) = rates[i].v.head<3>();
    turning.by_momentum.row(i) = rates[i].v.tail<3>();
  }
  return turning;
}

Constraint RigidBodyTerms::Turning(std::size_t interval) const {
  const std::vector<double>& breaks = unknowns_.breaks_s();
  SeenUnknowns seen;
  TurningTerm term;
  term.inverse_B = unknowns_.mean_inertia() * problem_.inertia_B.inverse();
  term.h = breaks[interval + 1] - breaks[interval];
  term.per_force = problem_.mass_kg * kGravity / unknowns_.mean_inertia();
  term.angles_from = seen.See(unknowns_.Angles(interval));
  term.angles_to = seen.See(unknowns_.Angles(interval + 1));
  term.momentum_from = seen.See(unknowns_.Momentum(interval));
  term.momentum_to = seen.See(unknowns_.Momentum(interval + 1));
  if (!unknowns_.Forces(interval).empty()) {
    for (std::size_t q = 0; q < kPlaces; ++q) {
      const double u = static_cast<double>(q) / (kPlaces - 1);
      term.com[q] = seen.See(unknowns_.CentreOfMass(breaks[interval] + u * term.h));
    }
    term.whole_from = seen.See(unknowns_.WholeForce(interval));
    term.whole_to = seen.See(unknowns_.WholeForce(interval + 1));
  }
  for (const ContactForce& force : unknowns_.Forces(interval)) {
    term.carried.push_back(
        {SeenPlace(unknowns_.ContactPoint(force.stance, force.point), seen), seen.See(force.from), seen.See(force.to)});
  }
  return {fmt::format("turning from {:.3f} s on", breaks[interval]), term, VectorX::Zero(6), VectorX::Zero(6),
          seen.variables()};
}

Constraint RigidBodyTerms::Free(std::size_t at_break) const {
  SeenUnknowns seen;
  VectorFunction rows = AffineRows(unknowns_.WholeForce(at_break), Matrix3::Identity(), Vector3::Zero(), seen);
  return {fmt::format("free flight at {:.3f} s", unknowns_.breaks_s()[at_break]),
          rows,
          Vector3::Zero(),
          Vector3::Zero(),
          seen.variables(),
          true};
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
  return {fmt::format("friction of foot {} at {:.3f} s", stance.foot, unknowns_.breaks_s()[force.at_break]),
          rows,
          VectorX::Constant(sides + 1, -kNoEnd),
          upper,
          seen.variables(),
          true};
}

Constraint RigidBodyTerms::Reach(std::size_t stance, double time_s, double margin_m) const {
  constexpr double kAtBreak = 1e-9;
  const std::vector<double>& breaks = unknowns_.breaks_s();
  const auto after = std::upper_bound(breaks.begin(), breaks.end(), time_s + kAtBreak);
  const auto k = static_cast<std::size_t>(after - breaks.begin()) - 1;
  SeenUnknowns seen;
  ReachTerm term;
  Constraint rows =
      WorkspaceOf(problem_.feet[static_cast<std::size_t>(problem_.stances[stance].foot)], margin_m, term.normals);
  term.place = SeenPlace(unknowns_.Foothold(stance), seen);
  term.com = seen.See(unknowns_.CentreOfMass(time_s));
  term.angles_from = seen.See(unknowns_.Angles(k));
  term.h = term.share = 0.0;
  if (time_s > breaks[k] + kAtBreak) {
    term.inverse_B = unknowns_.mean_inertia() * problem_.inertia_B.inverse();
    term.h = breaks[k + 1] - breaks[k];
    term.share = (time_s - breaks[k]) / term.h;
    term.momentum_from = seen.See(unknowns_.Momentum(k));
    term.angles_to = seen.See(unknowns_.Angles(k + 1));
    term.momentum_to = seen.See(unknowns_.Momentum(k + 1));
  }
  rows.name = fmt::format("reach of foot {} at {:.3f} s", problem_.stances[stance].foot, time_s);
  rows.function = term;
  rows.variables = seen.variables();
  return rows;
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
  return {fmt::format("region of foot {}'s foothold from {:.3f} s on", problem_.stances[stance].foot,
                      problem_.stances[stance].start_s),
          rows,
          VectorX::Constant(n, -kNoEnd),
          upper,
          {start, start + 1},
          true};
}

}  // namespace gaitwright
