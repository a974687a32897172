// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

/// Horizontal shifts of a wrench's axis for which contacts inside their friction cones can still provide it: all shifts
/// d in x and y [m] for which there are forces f_i in K_i with
///   sum_i f_i = F,   sum_i (p_i - p) x f_i = M + d x F.
/// The convex hull of such shifts, exact to 1e-4 m on the side that is nearest to no shift at all. Empty if there are
/// none. On level ground with enough friction it is the support polygon relative to the ZMP; for non-coplanar contacts,
/// which have no ZMP, it replaces the support polygon: a slice of the contact wrench cone. Caron, Pham and Nakamura,
/// RSS 2015 and T-RO 33(1), 2017. Where contacts can press against each other, as between two walls, it is unbounded,
/// and 10 m are returned. By linear programming over rays of the second-order cones, made as they are needed.
/// @throws InvalidArgument unless the force points up and there is a contact, with friction above 0 each.
Polygon WrenchShifts(const std::vector<ContactPoint>& contacts, const PointWrench& wrench);

/// How far the wrench is inside of that region: the signed distance [m] from no shift to its edge, negative outside,
/// never positive for contacts on a line; -infinity when the region is empty, as where the force is outside of all
/// friction. On level ground with friction enough it is the ZMP's distance to the edge of the support polygon.
double WrenchConeMargin(const std::vector<ContactPoint>& contacts, const PointWrench& wrench);

}  // namespace gaitwright
