// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/play/play.h"

namespace gaitwright::playing {

/// The world's options with what the plan says: which joints never move, and where it goes.
WorldOptions WorldOf(const MotionPlan& plan, const PlayOptions& options);

}  // namespace gaitwright::playing
