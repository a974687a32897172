// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/viewer/scene.h"

namespace gaitwright {

/// Whether the program has the viewer in it: not where it was built with GAITWRIGHT_VIEWER=OFF.
bool HasViewer();

/// A page that shows motions in 3D side by side under one clock, with plots. Whole by itself: no network. Well-formed
/// XML. @throws InvalidArgument as SceneJson does, and without the viewer.
std::string ViewerPage(const std::string& title, const std::vector<ShownMotion>& motions);

/// The same as a part of another page: an element, the scene and what shows it. Empty without the viewer.
std::string ViewerPart(const std::vector<ShownMotion>& motions);

/// Where the server of a page that shows a robot as it goes has its WebSocket.
inline constexpr char kLivePath[] = "/live";

/// A page that is told what to show by the server that it is from (docs/live.md). @throws InvalidArgument without the
/// viewer.
std::string LivePage(const std::string& title);

}  // namespace gaitwright
