// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// How pictures of a motion are made.
struct PictureOptions {
  int width_px = 1280, height_px = 720;
  std::string view = "corner";  ///< corner, side, front or top
  bool dark = false;
  std::vector<std::string> hidden = {};  ///< overlays that are left out, by OverlayNames
  double frames_per_s = 30.0;            ///< of a moving picture
  double speed = 1.0;                    ///< of the motion in it
  double from_s = -1e9, to_s = 1e9;      ///< of the motion, within which it shows

  /// Called after each picture with how many there are and will be.
  std::function<void(int, int)> progress = {};
};

/// Names of what can be left out of a picture.
const std::vector<std::string>& OverlayNames();
/// Names of where a picture can be taken from.
const std::vector<std::string>& ViewNames();

/// A picture of a page's motion (ViewerPage) at a time, as the bytes of a PNG. The page is opened in a headless
/// Chromium. Failure: there is none, or it shows no 3D. @throws InvalidArgument when an option is out of its range.
Result<std::string> RenderPng(const std::string& page, double at_s, const PictureOptions& options);

/// What a moving picture is made as.
enum class FilmFormat { kGif, kMp4 };

/// The motion as a moving picture, as the bytes of its file; ffmpeg puts it together. Failure: as RenderPng; ffmpeg is
/// not installed, or fails.
Result<std::string> RenderFilm(const std::string& page, FilmFormat format, const PictureOptions& options);

}  // namespace gaitwright
