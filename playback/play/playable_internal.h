// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/play/play.h"

namespace gaitwright::playing {

/// The world's options, completed from the plan: joints that never move, and the region of the plan.
WorldOptions WorldOf(const MotionPlan& plan, const PlayOptions& options);

}  // namespace gaitwright::playing
