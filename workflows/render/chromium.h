// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The browser and the size of its page.
struct ChromiumOptions {
  std::string program = {};  ///< its path; "": GAITWRIGHT_CHROMIUM, otherwise a Chromium on PATH
  int width_px = 1280, height_px = 720;
  double pixel_ratio = 1.0;  ///< drawn pixels per page pixel; a smaller ratio draws faster
  bool dark = false;         ///< colour scheme of the page (prefers-color-scheme): dark or light
  double timeout_s = 60.0;   ///< time limit for each answer
};

/// One page in its own headless Chromium, driven over its debugging pipe (Chrome DevTools Protocol). It opens no port,
/// and has its own profile in a temporary folder, which is deleted with it.
class Chromium {
 public:
  /// Failure: no Chromium is installed, or it does not start; with a hint.
  static Result<std::unique_ptr<Chromium>> Start(const ChromiumOptions& options);
  ~Chromium();
  Chromium(const Chromium&) = delete;
  Chromium& operator=(const Chromium&) = delete;

  /// Opens a URL, such as file:///..., in place of the previous page, and waits until it has loaded. @return the URL.
  Result<std::string> Open(const std::string& url);

  /// Evaluates a JavaScript expression. @return its value as JSON; promises are awaited. Failure: its exception.
  Result<std::string> Evaluate(const std::string& expression);

  /// A picture of the page, as the bytes of a PNG.
  Result<std::string> Png();

  /// Presses a key, by its name in KeyboardEvent.key.
  Result<std::string> Press(const std::string& key);

  /// A mouse event at a point of the page: moves there with the left button up or down, or presses or releases it.
  enum class Mouse { kMove, kDrag, kPress, kRelease };
  Result<std::string> Point(Mouse does, double x_px, double y_px);

  /// Console errors and uncaught exceptions of the page that was opened last, so far.
  const std::vector<std::string>& complaints() const;

 private:
  class Pipe;
  explicit Chromium(std::unique_ptr<Pipe> pipe);
  std::unique_ptr<Pipe> pipe_;
};

/// The file:// URL of a path, made absolute.
std::string FileUrl(const std::string& path);

}  // namespace gaitwright
