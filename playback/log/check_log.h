// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/log/playback_log.h"

namespace gaitwright {

/// Checks that a log is plausible: every number is finite; step, rate and mass are positive, friction is not negative;
/// samples are in the order of their times, with quaternions of unit length to 1e-3 and feet as many as there are
/// wrenches; stances are of such feet and end after they begin.
/// @throws InvalidArgument naming the error, its value and what is accepted.
void CheckLog(const PlaybackLog& log);

}  // namespace gaitwright
