// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/exchange/even_motion.h"
#include "workflows/repair/repair_options_internal.h"

namespace gaitwright {

/// A motion that begins and ends at rest with all feet on the ground.
struct RestedMotion {
  EvenMotion motion;            ///< positions and velocities of the file's motion along the new times; of findings,
                                ///< only its step is kept
  std::vector<FootSet> stance;  ///< by row
  std::vector<double> file_s;   ///< by row: time of the file's motion
  double slowed_start_s = 0.0, slowed_end_s = 0.0;  ///< time over which it was brought to its speed and to rest
  double stood_start_s = 0.0, stood_end_s = 0.0;    ///< time added for feet that were in the air
};

/// Where a motion does not begin at rest, its time begins slowly, over `rest_s`; where a foot is in the air at its
/// beginning, the robot first stands with that foot on the ground below it. The same at its end.
RestedMotion WithRestAtEnds(const RobotModel& model, const EvenMotion& motion, const std::vector<FootSet>& stance,
                            const RepairOptions& options);

}  // namespace gaitwright
