// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/ik/leg_closed_form.h"

namespace gaitwright {

/// Closed form for the leg of most two-legged robots: three hip axes through one point H, a knee, two ankle axes
/// through one point A; or the reverse, two axes at the hip and three at the ankle. The hip axes may be in any order
/// and at any angle to each other (the first axis of NAO is at 45 degrees). The knee axis need not be parallel to an
/// ankle axis.
///
///   1. A is fixed in the foot, so the target gives |A - H|, and the law of cosines gives the knee. Two branches.
///   2. The two ankle axes must bring H to its position relative to the foot. Two branches.
///   3. The remaining rotation gives the three angles of the hip. Two branches.
/// With three axes at the ankle, the same steps start from the foot.
///
/// @return null if the leg has another geometry.   Pieper, PhD thesis, Stanford 1968: three axes that meet.
std::shared_ptr<const LegClosedForm> FitSixJointForm(const LegChain& chain);

}  // namespace gaitwright
