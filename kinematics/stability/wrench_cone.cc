// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/wrench_cone.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;
using Matrix64 = Eigen::Matrix<double, 6, 4>;
using Matrix26 = Eigen::Matrix<double, 2, 6>;

constexpr double kTiny = 1e-9;  // tolerance for values scaled to about one

/// The linear program for the shifts: max c . d  s.t.  G x = w + B d, x >= 0. The columns of G are rays of the friction
/// cones, and B is the change of the wrench by a shift. With d eliminated, four rows are left. Forces are in units of
/// |F|, lengths in units of the farthest contact. Primal simplex; the entering ray has the best reduced cost, which has
/// a closed form for each cone.
class ShiftProgramme {
 public:
  ShiftProgramme(const std::vector<ContactPoint>& contacts, const PointWrench& wrench) : contacts_(contacts) {
    length_m_ = 1e-3;
    for (const ContactPoint& contact : contacts) length_m_ = std::max(length_m_, (contact.p_W - wrench.p_W).norm());
    for (const ContactPoint& contact : contacts) arms_.push_back((contact.p_W - wrench.p_W) / length_m_);
    const double force = wrench.force_W.norm();
    const Vector3 along = wrench.force_W / force;
    wanted_ << along, wrench.moment_W / (length_m_ * force);
    Eigen::Matrix<double, 6, 2> shift = Eigen::Matrix<double, 6, 2>::Zero();
    shift.bottomRows<3>().col(0) = Vector3::UnitX().cross(along);
    shift.bottomRows<3>().col(1) = Vector3::UnitY().cross(along);
    across_.setZero();
    across_.topLeftCorner<3, 3>().setIdentity();  // a shift changes no force, and no moment about the force's line
    across_.bottomRightCorner<3, 1>() = along;
    to_shift_ = (shift.transpose() * shift).inverse() * shift.transpose();
  }

  double length_m() const { return length_m_; }

  /// Finds a first solution. @return false if there is none.
  bool Start() {
    const Vector4 wanted = across_.transpose() * wanted_;
    for (int i = 0; i < 4; ++i) {
      basis_.col(i) = (wanted[i] < 0.0 ? -1.0 : 1.0) * Vector4::Unit(i);
      shifts_.col(i).setZero();
      artificial_[static_cast<std::size_t>(i)] = true;
    }
    amounts_ = wanted.cwiseAbs();
    Climb(nullptr);
    double left = 0.0;
    for (int i = 0; i < 4; ++i) left += artificial_[static_cast<std::size_t>(i)] ? std::abs(amounts_[i]) : 0.0;
    constexpr double kLeft = 1e-6;
    return left < kLeft;
  }

  /// The farthest shift along a direction [m], starting from the last solution; a distant one if it is unbounded.
  Vector2 Farthest(const Vector2& direction) {
    endless_.setZero();
    Climb(&direction);
    const Vector2 shift = length_m_ * (shifts_ * amounts_ - to_shift_ * wanted_);
    return endless_.isZero() ? shift : Vector2(shift + kFar * endless_.normalized());
  }

 private:
  /// The ray with the largest value of a linear functional of wrenches. @return this value.
  double BestRay(const Vector6& value, Vector6& best) const {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vector3 of_force = value.head<3>() + value.tail<3>().cross(arms_[i]);
      const Vector3& normal = contacts_[i].normal_W;
      const double pressing = of_force.dot(normal);
      const Vector3 sliding = of_force - pressing * normal;
      const double worth = pressing + contacts_[i].friction * sliding.norm();
      if (worth <= most) continue;
      most = worth;
      Vector3 force = normal;
      if (sliding.norm() > 0.0) force += contacts_[i].friction * sliding.normalized();
      best << force, arms_[i].cross(force);
    }
    return most;
  }

  /// Simplex steps for a direction; without a direction, steps that remove the artificial columns of the start.
  void Climb(const Vector2* direction) {
    constexpr int kMostSteps = 200;
    for (int step = 0; step < kMostSteps; ++step) {
      const Eigen::PartialPivLU<Matrix4> lu(basis_);
      Vector4 costs = Vector4::Zero();
      for (int i = 0; i < 4; ++i) {
        if (direction != nullptr) costs[i] = direction->dot(shifts_.col(i));
        if (artificial_[static_cast<std::size_t>(i)]) costs[i] = direction == nullptr ? -1.0 : 0.0;
      }
      const Vector4 multipliers = Matrix4(basis_.transpose()).partialPivLu().solve(costs);
      Vector6 value = -(across_ * multipliers), ray;
      if (direction != nullptr) value += to_shift_.transpose() * *direction;
      if (BestRay(value, ray) < kPriced) return;
      const Vector4 column = across_.transpose() * ray, change = lu.solve(column);
      const int leaves = Leaving(change, direction != nullptr);
      if (leaves < 0) {  // unbounded: contact forces can press against each other
        endless_ = to_shift_ * ray - shifts_ * change;
        return;
      }
      const double amount = std::max(amounts_[leaves] / change[leaves], 0.0);
      amounts_ -= amount * change;
      amounts_[leaves] = amount;
      amounts_ = amounts_.cwiseMax(0.0);
      basis_.col(leaves) = column;
      shifts_.col(leaves) = to_shift_ * ray;
      artificial_[static_cast<std::size_t>(leaves)] = false;
    }
  }

  /// The column whose amount becomes zero first; artificial columns leave as soon as possible.
  int Leaving(const Vector4& change, bool is_started) const {
    int leaves = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i) {
      const bool stands_in = is_started && artificial_[static_cast<std::size_t>(i)];
      if (stands_in && std::abs(change[i]) > kTiny) return i;
      if (change[i] <= kTiny || amounts_[i] / change[i] >= least) continue;
      least = amounts_[i] / change[i];
      leaves = i;
    }
    return leaves;
  }

  static constexpr double kPriced = 1e-7, kFar = 10.0;

  const std::vector<ContactPoint>& contacts_;
  std::vector<Vector3> arms_;
  double length_m_ = 1.0;
  Vector6 wanted_;
  Matrix64 across_;    // orthonormal complement of the effect of shifts
  Matrix26 to_shift_;  // shift from a wrench
  Matrix4 basis_;
  Eigen::Matrix<double, 2, 4> shifts_;  // shifts of the rays in the basis
  Vector4 amounts_;
  Vector2 endless_ = Vector2::Zero();  // unbounded direction, if the last result is unbounded
  std::array<bool, 4> artificial_{};
};

void Check(const std::vector<ContactPoint>& contacts, const PointWrench& wrench) {
  if (contacts.empty()) throw InvalidArgument("WrenchShifts: there is no contact; one or more are needed");
  if (!(wrench.force_W.z() > 0.0)) throw InvalidArgument("WrenchShifts: the force must point up");
  for (const ContactPoint& contact : contacts) {
    if (!(contact.friction > 0.0)) throw InvalidArgument("WrenchShifts: a contact's friction must be above 0");
  }
}

/// Index of the first corner of the polygon's edge that is nearest to a point.
std::size_t NearestEdge(const Polygon& polygon, const Vector2& point) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Polygon edge = {polygon[i], polygon[(i + 1) % polygon.size()]};
    const double distance = (NearestPoint(edge, point) - point).norm();
    if (distance < least) least = distance, nearest = i;
  }
  return nearest;
}

}  // namespace

Polygon WrenchShifts(const std::vector<ContactPoint>& contacts, const PointWrench& wrench) {
  Check(contacts, wrench);
  ShiftProgramme programme(contacts, wrench);
  if (!programme.Start()) return {};
  std::vector<Vector2> points;
  for (const Vector2& direction : {Vector2(1.0, 0.0), Vector2(0.0, 1.0), Vector2(-1.0, 0.0), Vector2(0.0, -1.0)})
    points.push_back(programme.Farthest(direction));
  // There may be shifts beyond the edge nearest to zero; search there until there are none.
  constexpr int kMostEdges = 40;
  constexpr double kExact = 1e-4;  // [m]
  Polygon region = ConvexHull(points);
  for (int i = 0; i < kMostEdges && region.size() > 1; ++i) {
    const std::size_t at = NearestEdge(region, Vector2::Zero());
    const Vector2 along = (region[(at + 1) % region.size()] - region[at]).normalized();
    const Vector2 outward(along.y(), -along.x());
    const Vector2 farthest = programme.Farthest(outward);
    if (outward.dot(farthest - region[at]) < kExact) break;
    points.push_back(farthest);
    region = ConvexHull(points);
  }
  return region;
}

double WrenchConeMargin(const std::vector<ContactPoint>& contacts, const PointWrench& wrench) {
  const Polygon region = WrenchShifts(contacts, wrench);
  return region.empty() ? -std::numeric_limits<double>::infinity() : SignedDistance(region, Vector2::Zero());
}

}  // namespace gaitwright
