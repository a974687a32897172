// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/render/shown_page.h"

#include <unistd.h>

#include <stdexcept>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "tests/workflows/render/shared_browser.h"

namespace gaitwright {
namespace {

template <class Value>
Value OrThrow(Result<Value> result) {
  if (!result) throw std::runtime_error(result.failure().message);
  return std::move(*result);
}

}  // namespace

ShownWalk MakeShownWalk(const std::string& robot, const WalkRequest& request, const Vector3& push_n) {
  RobotModel model = LoadNamedRobot(robot).value();
  PlannedWalk planned = OrThrow(PlanWalk(model, request));
  PlayRequest play;
  play.play.push_force_W = push_n;
  play.play.push_at_s = 1.0;
  play.play.push_for_s = 0.3;
  PlayedWalk played = OrThrow(PlayWalk(model, planned.motion.plan, play));
  return {std::move(model), std::move(planned.motion.plan), std::move(played)};
}

ShownPage::ShownPage(const std::string& html)
    : file_(std::filesystem::temp_directory_path() / ("gaitwright-page-" + std::to_string(getpid()) + ".html")),
      bytes_(html.size()),
      browser_(SharedBrowser()) {
  OrThrow(WriteFileAtomically(file_.string(), html));
  OrThrow(browser_.Open(FileUrl(file_.string())));
}

ShownPage::~ShownPage() {
  static_cast<void>(browser_.Open("about:blank"));  // stops all drawing
  std::filesystem::remove(file_);
}

nlohmann::json ShownPage::Ask(const std::string& expression) const {
  return nlohmann::json::parse(
      OrThrow(browser_.Evaluate("(() => { const v = window.gaitwright.viewers[0]; return " + expression + "; })()")));
}

}  // namespace gaitwright
