// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The replacement of an inertia that is not physical.
struct MendedInertia {
  Matrix3 I;         ///< about the centre of mass [kg m^2]
  std::string was;   ///< error of the given inertia; "" if only by rounding
  std::string used;  ///< replacement, such as "the nearest physical inertia" or "the inertia of its shapes"
};

/// Principal moments, smallest first [kg m^2].
Vector3 PrincipalMoments(const Matrix3& I);

/// The physical condition that a tensor violates by more than rounding (1e-9 kg m^2 or 1e-6 of its largest moment): a
/// negative principal moment, a moment larger than the sum of the other two, or a moment of zero with a mass. "" if it
/// violates no condition.
std::string BrokenInertiaLaw(const Matrix3& I, double mass);

/// The replacement of an inertia that is not physical; nothing for a physical inertia. The replacement is the nearest
/// tensor (Frobenius norm) whose second moments S = 1/2 tr(I) 1 - I, the integral of r r^T over the mass, have no
/// negative eigenvalue (Wensing, Kim and Slotine, Linear matrix inequalities for physically consistent inertial
/// parameter identification, RA-L 2018). If the tensor is zero, or the nearest one differs by half of its norm or more,
/// the inertia of the link's shapes at its mass is used, if it has shapes. If one moment alone is zero, as of an
/// infinitely thin rod, the other two are kept, and the third is the moment of the shapes, or without shapes that of a
/// cylinder ten times as long as thick.
/// @param shapes  shapes of the link in its frame, like I.
std::optional<MendedInertia> MendInertia(const Matrix3& I, double mass, const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
