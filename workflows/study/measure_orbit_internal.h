// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/orbit_stability_internal.h"
#include "workflows/study/study_jobs.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

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

/// A JSON object, see docs/json-output.md.
std::string OrbitJson(const OrbitStability& orbit);

}  // namespace gaitwright
