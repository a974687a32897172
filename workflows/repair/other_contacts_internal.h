// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/repair/repair_options_internal.h"

namespace gaitwright {

/// A time during which a link that is no foot is on the ground: the robot kneels, sits, lies or leans on a hand.
struct OtherContact {
  std::string link;
  double start_s = 0.0, end_s = 0.0;
};

/// Finds links that belong to no foot and come as low as feet that stand, for at least the shortest stance. Plans carry
/// the robot on its feet alone, so a repair has to say what it changed there. Links that are nearly on the ground in
/// the standing posture, such as ankles, do not count.
/// @param height_m  of feet that stand over the ground. @return by start.
std::vector<OtherContact> FindOtherContacts(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion,
                                            double height_m, const RepairOptions& options);

}  // namespace gaitwright
