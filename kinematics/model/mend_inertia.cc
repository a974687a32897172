// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mend_inertia.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "kinematics/model/solid_inertia.h"

namespace gaitwright {
namespace {

constexpr double kRounding = 1e-9, kRelativeRounding = 1e-6;  // [kg m^2], share of the largest moment
constexpr double kThinnest = 1e-6;  // smallest used second moment over the largest: a body has an extent
constexpr double kFarOff = 0.5;     // relative change of a tensor from which its numbers are not usable

/// Whether the smallest principal moment is zero to rounding, and the largest is not.
bool HasZeroMoment(const Vector3& moments) {
  return moments[2] > kRounding && moments[0] <= kRelativeRounding * moments[2];
}

/// The inertia of an infinitely thin rod, whose moment about its own axis is zero, with a moment there: that of the
/// link's shapes, or where no body has that one, of a cylinder ten times as long as thick.
MendedInertia ThickenedRod(const Matrix3& I, const std::optional<Matrix3>& solid, const std::string& broken) {
  constexpr double kOfCylinder = 12.0 / 800.0;  // m d^2 / 8 of m l^2 / 12, with l = 10 d
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(I);
  const Vector3 axis = principal.eigenvectors().col(0);
  const Vector3& moments = principal.eigenvalues();
  const double of_shapes = solid ? axis.dot(*solid * axis) : 0.0;
  const bool fits = of_shapes > 0.0 && of_shapes <= moments[1] + moments[2];
  const double moment = fits ? of_shapes : kOfCylinder * moments[2];
  return {I + (moment - moments[0]) * axis * axis.transpose(), broken,
          fits ? "the moment of its shapes about that axis" : "the moment of a rod ten times as long as thick"};
}

Matrix3 NearestOfABody(const Matrix3& I) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> second(0.5 * I.trace() * Matrix3::Identity() - I);
  const double least = kThinnest * second.eigenvalues().cwiseAbs().maxCoeff();
  const Vector3 kept = second.eigenvalues().cwiseMax(least);
  const Matrix3 S = second.eigenvectors() * kept.asDiagonal() * second.eigenvectors().transpose();
  return S.trace() * Matrix3::Identity() - S;
}

}  // namespace

Vector3 PrincipalMoments(const Matrix3& I) {
  return Eigen::SelfAdjointEigenSolver<Matrix3>(I, Eigen::EigenvaluesOnly).eigenvalues();
}

std::string BrokenInertiaLaw(const Matrix3& I, double mass) {
  if (mass > 0.0 && I.isZero(0.0)) return "is zero";
  const Vector3 moments = PrincipalMoments(I);
  const double slack = std::max(kRounding, kRelativeRounding * moments.cwiseAbs().maxCoeff());
  if (moments[0] < -slack) return fmt::format("has the negative principal moment {:.3g} kg m^2", moments[0]);
  if (moments[0] + moments[1] < moments[2] - slack) {
    return fmt::format("violates the triangle inequality: {:.4g} + {:.4g} < {:.4g} kg m^2", moments[0], moments[1],
                       moments[2]);
  }
  if (mass > 0.0 && HasZeroMoment(moments)) return "has a principal moment of zero, although the link has a mass";
  return "";
}

std::optional<MendedInertia> MendInertia(const Matrix3& I, double mass, const std::vector<const Shape*>& shapes) {
  const std::string broken = BrokenInertiaLaw(I, mass);
  if (broken.empty()) {
    const Vector3 moments = PrincipalMoments(I);
    const bool sound = moments[0] >= 0.0 && moments[0] + moments[1] >= moments[2];
    if (sound) return std::nullopt;
    return MendedInertia{NearestOfABody(I), "", ""};
  }
  const Vector3 moments = PrincipalMoments(I);
  const double slack = std::max(kRounding, kRelativeRounding * moments[2]);
  if (HasZeroMoment(moments) && moments[0] >= -slack && moments[0] + moments[1] >= moments[2] - slack)
    return ThickenedRod(I, SolidInertia(shapes, mass), broken);
  const Matrix3 nearest = NearestOfABody(I);
  if (I.isZero(0.0) || (nearest - I).norm() >= kFarOff * I.norm()) {
    if (const auto solid = SolidInertia(shapes, mass); solid && mass > 0.0)
      return MendedInertia{*solid, broken, "the inertia of its shapes"};
    if (I.isZero(0.0)) return std::nullopt;  // a point mass
  }
  return MendedInertia{nearest, broken, "the nearest physical inertia"};
}

}  // namespace gaitwright
