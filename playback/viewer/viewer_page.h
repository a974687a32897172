// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/viewer/scene.h"

namespace gaitwright {

/// Whether the program contains the viewer; false if built with GAITWRIGHT_VIEWER=OFF.
bool HasViewer();

/// A page that shows motions in 3D side by side with a common clock, and plots. Self-contained: no network. Well-formed
/// XML. @throws InvalidArgument as SceneJson does, and if the program has no viewer.
std::string ViewerPage(const std::string& title, const std::vector<ShownMotion>& motions);

/// The viewer as a part of another page: an element, the scene and the script. Empty if the program has no viewer.
std::string ViewerPart(const std::vector<ShownMotion>& motions);

/// Path of the WebSocket on the server of a live page.
inline constexpr char kLivePath[] = "/live";

/// A page that gets its data from its server (docs/live.md). @throws InvalidArgument if the program has no viewer.
std::string LivePage(const std::string& title);

}  // namespace gaitwright
