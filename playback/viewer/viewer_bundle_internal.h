// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace gaitwright {

/// The result of building playback/viewer/web, embedded in the program: one script and one style sheet. Empty in a
/// program that was built without it (GAITWRIGHT_VIEWER=OFF).
std::string_view ViewerScript();
std::string_view ViewerStyle();

}  // namespace gaitwright
