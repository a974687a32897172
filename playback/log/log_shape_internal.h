// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

inline constexpr char kLogFormat[] = "gaitwright-playback-log";

// What the parts of a log's file may hold.
DataShape StanceShape();
DataShape BodyContactShape();
DataShape LogGateShape();
DataShape LogPushShape();

}  // namespace gaitwright
