// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/render/chromium.h"

namespace gaitwright {

/// An empty page in a headless Chromium that all tests of the process use one after the other: to start a browser and
/// to compile the shaders of a 3D page takes longer than most tests of a page. Each of its pages has few pixels.
/// @throws std::runtime_error where the browser does not start.
Chromium& SharedBrowser();

}  // namespace gaitwright
