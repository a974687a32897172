// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Largest distance between two known points of a link [m].
/// @param shapes  shapes of the link, in its frame.
/// @param points  other points in its frame: its origin, its centre of mass, the joints on it.
double LinkExtent(const std::vector<const Shape*>& shapes, std::vector<Vector3> points);

/// Replaces an inertia that is far too large for the link by the inertia of its shapes. Such inertias come from files
/// with a wrong unit or invented numbers. The radius of gyration sqrt(tr(I) / (2 m)) of a body cannot exceed its
/// extent. Shapes may show only a part of a link, so the inertia is replaced only if the radius is four times the
/// extent or more. A link without shapes keeps its inertia.
std::optional<MendedInertia> MendOversizedInertia(const Matrix3& I, double mass, double extent_m,
                                                  const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
