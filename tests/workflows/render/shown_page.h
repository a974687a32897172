// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "workflows/render/chromium.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// A walk that was planned and played.
struct ShownWalk {
  RobotModel model;
  MotionPlan plan;
  PlayedWalk played;
};

/// Plans and plays a walk; fails the test if no plan exists. A strong push ends the walk early.
ShownWalk MakeShownWalk(const std::string& robot, const WalkRequest& request, const Vector3& push_n = Vector3::Zero());

/// A page with such walks in the shared browser; only one may exist at a time.
class ShownPage {
 public:
  /// @throws std::runtime_error if the browser does not start or the page does not load.
  explicit ShownPage(const std::string& html);
  ~ShownPage();

  /// The value of a JavaScript expression; `v` is the page's first viewer.
  /// @throws std::runtime_error with the message of its exception.
  nlohmann::json Ask(const std::string& expression) const;
  Chromium& browser() const { return browser_; }
  std::size_t bytes() const { return bytes_; }

 private:
  std::filesystem::path file_;
  std::size_t bytes_;
  Chromium& browser_;
};

}  // namespace gaitwright
