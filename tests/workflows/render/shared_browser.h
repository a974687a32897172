// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/render/chromium.h"

namespace gaitwright {

/// An empty page in a headless Chromium that all tests of the process use in sequence, since starting a browser and
/// compiling the shaders of a 3D page take longer than most tests. Its pages are small.
/// @throws std::runtime_error if the browser does not start.
Chromium& SharedBrowser();

}  // namespace gaitwright
