// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Largest distance between two known points of a link [m]: its shapes, and points such as its origin, its centre of
/// mass and the joints on it, all in the link's frame.
double LinkExtent(const std::vector<const Shape*>& shapes, std::vector<Vector3> points);

/// Replaces an inertia that is far too large for the link by that of its shapes; such inertias come from files with a
/// wrong unit or invented numbers. No body has a radius of gyration sqrt(tr(I) / (2 m)) larger than its extent. Shapes
/// may show only a part of a link, so only four times the extent or more is replaced; a link without shapes keeps its
/// inertia.
std::optional<MendedInertia> MendOversizedInertia(const Matrix3& I, double mass, double extent_m,
                                                  const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
