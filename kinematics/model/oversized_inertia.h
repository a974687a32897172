// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Largest distance between two points of what is known of a link [m]: its shapes, and points such as its origin, its
/// centre of mass and the joints on it, all in the link's frame.
double LinkExtent(const std::vector<const Shape*>& shapes, std::vector<Vector3> points);

/// The inertia of the shapes in place of one that is far too large for the link: files with another unit, or with
/// numbers that nobody worked out. No body has a radius of gyration sqrt(tr(I) / (2 m)) larger than its extent. Shapes
/// may show a link in part, so that only four times the extent or more is mended; a link without shapes keeps what it
/// has.
std::optional<MendedInertia> MendOversizedInertia(const Matrix3& I, double mass, double extent_m,
                                                  const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
