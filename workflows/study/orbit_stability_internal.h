// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/floquet_multipliers_internal.h"
#include "workflows/study/study_jobs.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// Stability of the steady part of a gait, from playbacks with small pushes.
struct OrbitStability {
  std::string missing = {};  ///< why there are no multipliers; else empty
  double cycle_s = 0.0;
  int cycles = 0;            ///< of the plan's steady stretch
  double impulse_n_s = 0.0;  ///< of each push
  int playbacks = 0;
  FloquetMultipliers multipliers;

  bool stable() const { return missing.empty() && multipliers.largest() < 1.0; }
};

/// Measures the Floquet multipliers of the steady stretch of a plan as played. Pushes along the three axes, forward and
/// back, act at four phases of the first steady cycle, each in a playback of its own. Half the difference between the
/// playbacks of two opposite pushes, at the start of each later cycle, is the deviation that the push leaves: of
/// position, attitude and joints, and of their rates. Lengths are divided by the leg length l and times by
/// sqrt(l / g).
///
/// Noise of sensors and the ground are the same in all playbacks. There are no multipliers for a plan with less than
/// kLeastOrbitCycles steady cycles, or if the robot falls after a push.
/// @return a failure as of PlayWalk. @throws as PlayWalk does.
Result<OrbitStability> MeasureOrbit(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                    const JobOptions& jobs);

inline constexpr int kLeastOrbitCycles = 5;

/// One sentence for a terminal.
std::string OrbitText(const OrbitStability& orbit);

/// A JSON object, see docs/json-output.md.
std::string OrbitJson(const OrbitStability& orbit);

}  // namespace gaitwright
