// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The inertia that is used for one that no body has.
struct MendedInertia {
  Matrix3 I;         ///< about the centre of mass [kg m^2]
  std::string was;   ///< error of the given inertia; "" if only by rounding
  std::string used;  ///< replacement, such as "the nearest physical inertia" or "the inertia of its shapes"
};

/// Principal moments, smallest first [kg m^2].
Vector3 PrincipalMoments(const Matrix3& I);

/// Physical condition that a tensor violates, "" for none, beyond rounding (1e-9 kg m^2 or 1e-6 of its largest moment):
/// a negative principal moment, a moment larger than the sum of the other two, or, with a mass, a moment of zero.
std::string BrokenInertiaLaw(const Matrix3& I, double mass);

/// The inertia in place of one that no body of that mass has; nothing for one that a body has.
/// The nearest (Frobenius) is taken in the cone of second moments: S = 1/2 tr(I) 1 - I, which is the integral of r r^T
/// over the mass, has no negative eigenvalue (Wensing, Kim and Slotine, Linear matrix inequalities for physically
/// consistent inertial parameter identification, RA-L 2018). Where the tensor is 0, or the nearest is off by half of it
/// or more, that of the link's shapes at its mass is taken, if it has any. Where one moment alone is zero, as of an
/// infinitely thin rod, the others are kept, and that one is taken from the shapes, or from a cylinder ten times as
/// long as thick. @param shapes  of the link, in its frame, as I is.
std::optional<MendedInertia> MendInertia(const Matrix3& I, double mass, const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
