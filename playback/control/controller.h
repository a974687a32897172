// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The interface is in the engine's folder, which is below all controllers.
#include "playback/engine/controller.h"  // IWYU pragma: export
