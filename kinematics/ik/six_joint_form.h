// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/ik/leg_closed_form.h"

namespace gaitwright {

/// The leg of most two-legged robots: three hip axes through one point H, a knee, two ankle axes through one point A;
/// or its mirror, two axes at the hip and three at the ankle. The hip axes may stand in any order and at any angle to
/// one another (NAO's first lies at 45 degrees), the knee's need not be parallel to the ankle's.
///
///   1. A is fixed in the foot, so the target gives |A - H|, and the law of cosines the knee. Two branches.
///   2. Seen from the foot, H must be where the ankle's two axes bring it. Two branches.
///   3. The rest of the rotation is the hip's: three turns about its own axes. Two branches.
/// With three axes at the ankle the same is done from the foot upwards.
///
/// @return null when the leg is of another kind.   Pieper, PhD thesis, Stanford 1968: three axes that meet.
std::shared_ptr<const LegClosedForm> FitSixJointForm(const LegChain& chain);

}  // namespace gaitwright
