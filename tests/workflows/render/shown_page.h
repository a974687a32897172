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

/// Plans and plays; fails the test where no plan exists. A push ends it early, if it is hard enough.
ShownWalk MakeShownWalk(const std::string& robot, const WalkRequest& request, const Vector3& push_n = Vector3::Zero());

/// A page of such walks, opened in the browser that the tests share: one at a time.
class ShownPage {
 public:
  /// @throws std::runtime_error where the browser does not start or the page does not load.
  explicit ShownPage(const std::string& html);
  ~ShownPage();

  /// The value of an expression of JavaScript, in which `v` is the page's first viewer.
  /// @throws std::runtime_error with what it threw.
  nlohmann::json Ask(const std::string& expression) const;
  Chromium& browser() const { return browser_; }
  std::size_t bytes() const { return bytes_; }

 private:
  std::filesystem::path file_;
  std::size_t bytes_;
  Chromium& browser_;
};

}  // namespace gaitwright
