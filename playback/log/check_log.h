// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/log/playback_log.h"

namespace gaitwright {

/// Checks that a log is plausible. Every number is finite; step, rate and mass are positive; friction is not negative.
/// Samples are in order of time, with quaternions of unit length to 1e-3 and no feet beyond the number of wrenches.
/// Stances are of such feet and end after they begin.
/// @throws InvalidArgument naming the error, its value and the accepted values.
void CheckLog(const PlaybackLog& log);

}  // namespace gaitwright
