// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/contact_split.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kDualPenalty = 1e-9;

/// Projection of a force (tangents, normal) onto the cone |t| <= mu n. Its derivative is the identity inside of the
/// cone, zero inside of the polar cone, and ray ray^T + across across^T elsewhere.
struct ConeProjection {
  enum class Part { kInside, kPolar, kSurface };
  Part part;
  Vector3 force, ray, across;
};

ConeProjection ProjectOntoCone(const Vector3& f, double mu) {
  using Part = ConeProjection::Part;
  const double t = f.head<2>().norm(), n = f.z();
  if (t <= mu * n) return {Part::kInside, f, {}, {}};
  if (mu * t <= -n) return {Part::kPolar, Vector3::Zero(), {}, {}};
  const double scale = 1.0 / (1.0 + mu * mu);
  const double along = (mu * t + n) * scale;  // the projection is `along` times (mu u, 1)
  const Vector2 u = f.head<2>() / t;
  const Vector3 ray(mu * u.x(), mu * u.y(), 1.0);
  return {Part::kSurface, along * ray, std::sqrt(scale) * ray,
          std::sqrt(std::max(0.0, mu * along / t)) * Vector3(-u.y(), u.x(), 0.0)};
}

/// Axes of a contact as rows: two tangents and the normal.
Matrix3 ContactAxes(const Vector3& normal) {
  const Vector3 helper = std::abs(normal.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitY();
  const Vector3 t2 = normal.cross(helper).normalized();
  Matrix3 axes;
  axes.row(0) = t2.cross(normal).transpose();
  axes.row(1) = t2.transpose();
  axes.row(2) = normal.transpose();
  return axes;
}

}  // namespace

double ContactSplitter::Dual(const Vector6& wanted, const Vector6& y, bool with_derivatives) {
  double value = y.dot(wanted) - 0.5 * penalty_ * y.squaredNorm();
  if (with_derivatives) {
    gradient_ = wanted - penalty_ * y;
    hessian_ = penalty_ * Eigen::Matrix<double, 6, 6>::Identity();
  }
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    const Map& map = maps_[i];
    const ConeProjection projection = ProjectOntoCone(map.Gt * y / map.weight, map.mu);
    value -= 0.5 * map.weight * projection.force.squaredNorm();
    if (!with_derivatives) continue;
    forces_[i] = projection.force;
    if (projection.part == ConeProjection::Part::kPolar) continue;
    gradient_.noalias() -= map.Gt.transpose() * projection.force;
    if (projection.part == ConeProjection::Part::kInside) {
      hessian_ += map.inside;
      continue;
    }
    for (const Vector3& direction : {projection.ray, projection.across}) {
      const Vector6 along = map.Gt.transpose() * direction;
      hessian_.noalias() += (along / map.weight) * along.transpose();
    }
  }
  return value;
}

bool ContactSplitter::Climb(const Vector6& wanted, double penalty, Vector6& y, int& iterations) {
  constexpr int kMaxIterations = 30;
  penalty_ = penalty;
  double value = Dual(wanted, y, true);
  for (int i = 0; i < kMaxIterations; ++i, ++iterations) {
    if (gradient_.norm() < 1e-11 + 1e-15 * y.norm()) return true;
    const Vector6 step = hessian_.llt().solve(gradient_);
    const double slope = gradient_.dot(step);
    if (slope < 1e-20) return true;
    double length = 1.0, trial = Dual(wanted, y + step, false);
    while (trial < value + 1e-4 * length * slope && length > 1e-8) {
      length *= 0.5;
      trial = Dual(wanted, y + length * step, false);
    }
    if (length <= 1e-8) break;
    y += length * step;
    value = Dual(wanted, y, true);
  }
  return false;
}

void ContactSplitter::Solve(const std::vector<ContactPoint>& contacts, const PointWrench& wanted, ContactSplit& split) {
  if (contacts.empty()) throw InvalidArgument("ContactSplitter: no contact; one or more are needed");
  Vector3 centre = Vector3::Zero();
  for (const ContactPoint& contact : contacts) centre += contact.p_W / static_cast<double>(contacts.size());
  double length = 0.05;
  for (const ContactPoint& contact : contacts) length = std::max(length, (contact.p_W - centre).norm());
  double lightest = contacts.front().reluctance;
  for (const ContactPoint& contact : contacts) lightest = std::min(lightest, contact.reluctance);
  maps_.clear();
  for (const ContactPoint& contact : contacts) {
    if (!(contact.friction > 0.0) || !(contact.reluctance > 0.0)) {
      throw InvalidArgument("ContactSplitter: friction and reluctance must be positive");
    }
    Map& map = maps_.emplace_back();
    const Matrix3 axes = ContactAxes(contact.normal_W);
    map.Gt.leftCols<3>() = axes;
    map.Gt.rightCols<3>() = -axes * Skew(Vector3((contact.p_W - centre) / length));
    map.mu = contact.friction;
    map.weight = contact.reluctance / lightest;
    map.inside.noalias() = map.Gt.transpose() * map.Gt / map.weight;
  }
  forces_.resize(maps_.size());
  const double scale = std::max(wanted.force_W.norm(), 1e-9);
  Vector6 target;
  target << wanted.force_W, (wanted.moment_W + (wanted.p_W - centre).cross(wanted.force_W)) / length;
  target /= scale;

  Vector6 y = Vector6::Zero();
  y.head<3>() = target.head<3>();
  split.iterations = 0;
  // If Newton's method fails with the small penalty, start with a large penalty and reduce it.
  if (!Climb(target, kDualPenalty, y, split.iterations)) {
    y.setZero();
    for (double penalty = 0.1; penalty > 0.5 * kDualPenalty; penalty *= 0.1)
      Climb(target, penalty, y, split.iterations);
  }

  split.force_W.resize(contacts.size());
  split.residual_force_W = wanted.force_W;
  split.residual_moment_W = wanted.moment_W;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    split.force_W[i] = scale * (maps_[i].Gt.leftCols<3>().transpose() * forces_[i]);
    split.residual_force_W -= split.force_W[i];
    split.residual_moment_W -= (contacts[i].p_W - wanted.p_W).cross(split.force_W[i]);
  }
}

}  // namespace gaitwright
