// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/derive_legs.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Distance from a body's joint to the farthest of its collision geometry and its frames [m].
double FarthestExtent(const RobotModel& model, int body);

/// The foot at the end of a leg; X_BF has the base's axes at joint positions zero, or where a sole that lies aslant
/// there is level (a sphere's are set with the posture).
/// @param biped     the robot has two legs, so that those of four joints may end in soles too.
/// @param choices   have the give of soles, unless `given`, which is of this foot, has it.
/// @param standing  joint positions by coordinate, in which such a sole is level; NaN where none is given.
Foot FindFoot(const RobotModel& model, const Leg& leg, const LegChoices& choices, const FootOverride* given,
              const VectorX& standing, bool biped = false);

/// A support surface for lying that is not a foot: the flat bottom of a link's shapes in the standing posture, with the
/// sole's give of FindFlatBottom. Nothing if there is none. @throws InvalidArgument for an unknown link.
std::optional<Foot> FindRest(const RobotModel& model, const std::string& link, std::optional<double> give_m = {});

}  // namespace gaitwright
