// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

/// Horizontal shifts of a wrench's axis for which contacts inside their friction cones can still provide it: all shifts
/// d in x and y [m] for which there are forces f_i in K_i with
///   sum_i f_i = F,   sum_i (p_i - p) x f_i = M + d x F.
/// The result is the convex hull of these shifts, exact to 1e-4 m on the side nearest to zero. It is empty if there are
/// no such shifts. On level ground with enough friction, it is the support polygon relative to the ZMP. For
/// non-coplanar contacts, which have no ZMP, it replaces the support polygon: it is a slice of the contact wrench cone.
/// Caron, Pham and Nakamura, RSS 2015 and T-RO 33(1), 2017. If contacts can press against each other, as between two
/// walls, it is unbounded, and 10 m are returned. Computed by linear programming over rays of the second-order cones,
/// with column generation. @throws InvalidArgument unless the force points up and there are contacts, each with
/// friction above 0.
Polygon WrenchShifts(const std::vector<ContactPoint>& contacts, const PointWrench& wrench);

/// Signed distance [m] of a zero shift to the boundary of WrenchShifts: negative outside, never positive for contacts
/// on a line, and -infinity if the region is empty, for example because friction cannot give the force. On level ground
/// with enough friction, it is the distance of the ZMP to the boundary of the support polygon.
double WrenchConeMargin(const std::vector<ContactPoint>& contacts, const PointWrench& wrench);

}  // namespace gaitwright
