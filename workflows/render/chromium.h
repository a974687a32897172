// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Which browser, and how large its page is.
struct ChromiumOptions {
  std::string program =
      {};  ///< its path; "" takes GAITWRIGHT_CHROMIUM, else the first of Chromium's usual names on PATH
  int width_px = 1280, height_px = 720;
  double pixel_ratio = 1.0;  ///< of what is drawn over what the page has: less draws the same page in less time
  bool dark = false;         ///< colour scheme of the page (prefers-color-scheme): dark or light
  double timeout_s = 60.0;   ///< for each answer
};

/// One page in a headless Chromium of its own, driven over its debugging pipe (Chrome DevTools Protocol). It opens no
/// port, and has a profile of its own in a temporary folder, which goes with it.
class Chromium {
 public:
  /// Failure: no Chromium is installed, or it does not start; with what to do.
  static Result<std::unique_ptr<Chromium>> Start(const ChromiumOptions& options);
  ~Chromium();
  Chromium(const Chromium&) = delete;
  Chromium& operator=(const Chromium&) = delete;

  /// Opens a URL, as file:///..., in place of the page before, and waits until it has loaded. @return the URL.
  Result<std::string> Open(const std::string& url);

  /// The value of an expression of JavaScript, as JSON; a promise is waited for. Failure: what it threw.
  Result<std::string> Evaluate(const std::string& expression);

  /// A picture of the page, as the bytes of a PNG.
  Result<std::string> Png();

  /// Presses a key, by its name in KeyboardEvent.key.
  Result<std::string> Press(const std::string& key);

  /// What a mouse does at a place in the page: goes there with its left button up or down, or presses or releases it.
  enum class Mouse { kMove, kDrag, kPress, kRelease };
  Result<std::string> Point(Mouse does, double x_px, double y_px);

  /// Errors that the page opened last wrote to its console, and exceptions that nobody caught, so far.
  const std::vector<std::string>& complaints() const;

 private:
  class Pipe;
  explicit Chromium(std::unique_ptr<Pipe> pipe);
  std::unique_ptr<Pipe> pipe_;
};

/// The file:// URL of a path, made absolute.
std::string FileUrl(const std::string& path);

}  // namespace gaitwright
