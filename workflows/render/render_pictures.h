// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// Options for pictures of a motion.
struct PictureOptions {
  int width_px = 1280, height_px = 720;
  std::string view = "corner";  ///< corner, side, front or top
  bool dark = false;
  std::vector<std::string> hidden = {};  ///< hidden overlays, by OverlayNames
  double frames_per_s = 30.0;            ///< frame rate of a film
  double speed = 1.0;                    ///< playback speed, as a multiple of real time
  double from_s = -1e9, to_s = 1e9;      ///< shown time range of the motion

  /// Called after each picture with the number of finished and of all pictures.
  std::function<void(int, int)> progress = {};
};

/// Names of overlays that can be hidden.
const std::vector<std::string>& OverlayNames();
/// Names of camera views.
const std::vector<std::string>& ViewNames();

/// Makes a picture of a page's motion (ViewerPage) at a time, as the bytes of a PNG, with a headless Chromium. Failure:
/// Chromium is not installed, or has no WebGL. @throws InvalidArgument if an option is out of range.
Result<std::string> RenderPng(const std::string& page, double at_s, const PictureOptions& options);

/// Format of a film.
enum class FilmFormat { kGif, kMp4 };

/// Makes a film of the motion (the bytes of its file) with ffmpeg. Failure: as of RenderPng; ffmpeg is not installed,
/// or fails.
Result<std::string> RenderFilm(const std::string& page, FilmFormat format, const PictureOptions& options);

}  // namespace gaitwright
