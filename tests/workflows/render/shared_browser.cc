// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/render/shared_browser.h"

#include <stdexcept>

namespace gaitwright {

Chromium& SharedBrowser() {
  static std::unique_ptr<Chromium> browser;
  if (browser && browser->Open("about:blank")) return *browser;
  browser.reset();
  Result<std::unique_ptr<Chromium>> started = Chromium::Start({.pixel_ratio = 0.25});
  if (!started) throw std::runtime_error(started.failure().message);
  browser = std::move(*started);
  return *browser;
}

}  // namespace gaitwright
