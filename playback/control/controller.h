// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The interface stands beside the simulator, which is below all controllers.
#include "playback/engine/controller.h"  // IWYU pragma: export
