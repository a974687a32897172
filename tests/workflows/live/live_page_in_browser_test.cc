// SPDX-License-Identifier: BSD-3-Clause
// End-to-end: a browser shows a robot that runs in real time, and actions on the page reach the robot.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "playback/viewer/viewer_page.h"
#include "tests/workflows/live/made_world.h"
#include "tests/workflows/render/shared_browser.h"
#include "workflows/live/live_session.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;
using Mouse = Chromium::Mouse;

/// A running robot, and a browser that shows its page.
class LivePageTest : public testing::Test {
 protected:
  void SetUp() override {
    live_ = MadeWorld(model_);
    server_ = std::move(LiveServer::Start({}, LivePage("a1, live")).value());
    server_->Greet(LiveGreeting(*live_));
    runs_ = std::thread([this] { LiveSession(*live_, *server_, {}).Run([this] { return stop_.load(); }); });
    browser_ = &SharedBrowser();
    ASSERT_TRUE(browser_->Open(server_->url()).ok());
    // Four frames per second are enough, because they are drawn without a graphics card.
    ASSERT_TRUE(browser_
                    ->Evaluate("(window.requestAnimationFrame = (draw) => setTimeout(() => "
                               "draw(performance.now()), 250), 0)")
                    .ok());
    Await("L.stage !== null");
  }
  void TearDown() override {
    if (browser_ != nullptr) {
      for (const std::string& complaint : browser_->complaints()) ADD_FAILURE() << complaint;
      static_cast<void>(browser_->Open("about:blank"));  // before the server ends
    }
    stop_ = true;
    if (runs_.joinable()) runs_.join();
  }

  /// The value of an expression; L is the page.
  Json Ask(const std::string& expression) const {
    const auto answer =
        browser_->Evaluate("(() => { const L = window.gaitwright.live[0]; return " + expression + "; })()");
    if (!answer) throw std::runtime_error(answer.failure().message);
    return Json::parse(*answer);
  }
  /// Waits until the expression is true.
  void Await(const std::string& condition, double within_s = 300.0) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(within_s);
    while (std::chrono::steady_clock::now() < end) {
      if (Ask("!!(" + condition + ")").get<bool>()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    ADD_FAILURE() << condition << " does not come; " << Ask("[L.frame.mode, L.frame.t, L.frame.wanted, L.frame.notes]");
  }
  void Click(const std::string& name) const { Ask("(document.querySelector('button[name=" + name + "]').click(), 0)"); }
  /// Moves and releases a slider, or sets a menu.
  void Set(const std::string& selector, const std::string& value) const {
    Ask("((s) => { s.value = '" + value +
        "'; s.dispatchEvent(new Event('input', {bubbles: true})); s.dispatchEvent(new Event('change', {bubbles: "
        "true})); "
        "return 0; })(document.querySelector('" +
        selector + "'))");
  }
  void ShowTab(const std::string& title) const {
    Ask("([...document.querySelectorAll('[role=tab]')].find((t) => t.textContent === '" + title + "').click(), 0)");
  }

  const RobotModel model_ = ChooseRobot("a1", "").value();
  std::unique_ptr<LiveWorld> live_;
  std::unique_ptr<LiveServer> server_;
  std::thread runs_;
  std::atomic<bool> stop_{false};
  Chromium* browser_ = nullptr;  // the shared browser
};

TEST_F(LivePageTest, SlidersMoveTheJoints) {
  ShowTab("Pose");
  const Json before = Ask("[L.frame.q[9], L.stage.robot.bodyPosition(3).toArray()]");
  Set("input[name=\"joint:FL_calf_joint\"]", "-60");
  Await("L.frame.mode === 'posed'");
  Await("Math.abs(L.frame.q[9] + Math.PI / 3) < 0.02");
  Set("input[name=\"base:height\"]", "500");
  Await("L.frame.q[2] > 0.45");
  Await("L.stage.robot.bodyPosition(3).z > 0.3");
  EXPECT_GT(std::abs(before[0].get<double>() + 1.047), 0.2) << "it was elsewhere before";
  const std::string joint = "document.querySelector('input[name=\"joint:FL_calf_joint\"]').parentElement";
  EXPECT_EQ(Ask("[..." + joint + ".querySelectorAll('.gw-end')].map((end) => end.textContent)"),
            Json({"-154.5\u00b0", "-52.5\u00b0"}));
  Click("stand_up");
  Await("L.frame.mode === 'stands' && L.frame.q[2] < 0.4");
}

TEST_F(LivePageTest, WalksAndChangesItsGaitSpeedAndHeadingAndStops) {
  Set("select[name=gait]", "trot");
  Set("input[name=speed_m_s]", "0.3");
  Click("walk");
  Await("L.frame.mode === 'walks'");
  const double t = Ask("L.frame.t").get<double>();
  Await("L.frame.t > " + std::to_string(t + 3.0));
  Await("L.frame.q[0] > 0.3");
  Set("input[name=speed_m_s]", "0.5");
  Await("L.frame.pace.speed_m_s > 0.45 && L.frame.wanted === null");
  Set("select[name=gait]", "amble");
  Await("L.frame.pace.gait === 'amble' && L.frame.wanted === null");
  Set("select[name=gait]", "trot");
  Await("L.frame.pace.gait === 'trot' && L.frame.wanted === null");
  Set("input[name=heading_deg]", "40");
  Await("Math.abs(L.frame.heading_deg - 40) < 5");
  Await("L.frame.wanted_heading_deg === null");
  EXPECT_EQ(Ask("L.frame.mode"), "walks");
  Click("walk");  // the button is now Stop
  Await("L.frame.mode === 'stands'");
}

TEST_F(LivePageTest, AMouseThatDragsTheRobotMovesItAndItRecovers) {
  Set("input[name=speed_m_s]", "0.3");
  Click("walk");
  Await("L.frame.mode === 'walks'");
  const Json at =
      Ask("(() => { const p = L.stage.seenAt(L.stage.robot.bodyPosition(0)), box = "
          "L.stage.canvas.getBoundingClientRect(); return [box.left + p.x, box.top + p.y]; })()");
  const double x = at[0].get<double>(), y = at[1].get<double>();
  const std::string lateral_m = Ask("L.frame.q[1]").dump();
  for (const auto& [does, dx] :
       {std::pair(Mouse::kMove, 0.0), {Mouse::kPress, 0.0}, {Mouse::kDrag, 20.0}, {Mouse::kDrag, 40.0}})
    ASSERT_TRUE(browser_->Point(does, x + dx, y).ok());
  Await("L.frame.pulls.length === 1 && L.frame.q[1] > 0.01 + " + lateral_m);
  ASSERT_TRUE(browser_->Point(Mouse::kRelease, x + 40.0, y).ok());
  Await("L.frame.pulls.length === 0");
  const double t = Ask("L.frame.t").get<double>();
  Await("L.frame.t > " + std::to_string(t + 3.0));
  EXPECT_EQ(Ask("L.frame.mode"), "walks");
}

TEST_F(LivePageTest, APushMovesTheRobotAndItRecovers) {
  const Json before = Ask("L.frame.q");
  Set("input[name=push_n]", "60");
  Click("push_left");
  Await("L.frame.q[1] > " + std::to_string(before[1].get<double>() + 0.003));
  const double t = Ask("L.frame.t").get<double>();
  Await("L.frame.t > " + std::to_string(t + 2.0));
  EXPECT_EQ(Ask("L.frame.mode"), "stands");
}

TEST_F(LivePageTest, PausesStepsAndResetsByKeys) {
  ASSERT_TRUE(browser_->Press(" ").ok());
  Await("L.frame.paused");
  const double t = Ask("L.frame.t").get<double>(), step_s = PlayOptions{}.world.step_s;
  ASSERT_TRUE(browser_->Press(".").ok());
  Await("L.frame.t > " + std::to_string(t + 0.5 * step_s));
  EXPECT_NEAR(Ask("L.frame.t").get<double>(), t + step_s, 1e-9);
  ASSERT_TRUE(browser_->Press("r").ok());
  Await("L.frame.t < " + std::to_string(t));
  ASSERT_TRUE(browser_->Press(" ").ok());
  Await("!L.frame.paused");
  ShowTab("Ground");
  Set("input[name=slope_deg]", "4");
  Await("L.frame.ground.slope_deg === 4");
  ShowTab("Gains");
  Set("input[type=number][name=\"gains.stance_damping\"]", "1.5");
  Await("L.frame.options.includes(1.5)");
}

TEST_F(LivePageTest, TellsTheGainsOfAJointAndShowsTheViewFromAboveLarge) {
  Await("L.frame.stiffness.length === 12 && document.querySelector('.gw-drive').textContent !== ''");
  EXPECT_EQ(
      Ask("/^kp [0-9.]+ N m\\/rad, kd [0-9.]+ N m s\\/rad$/.test(document.querySelector('.gw-drive').textContent)"),
      true)
      << Ask("document.querySelector('.gw-drive').textContent");
  const std::string size =
      "[document.querySelector('.gw-plan').clientWidth, document.querySelector('.gw-plan').clientHeight]";
  const Json small = Ask(size);
  ASSERT_TRUE(browser_->Press("p").ok());
  const Json large = Ask(size);
  EXPECT_GT(large[1].get<int>(), 2 * small[1].get<int>());
  Click("enlarge");
  EXPECT_EQ(Ask(size), small);
}

}  // namespace
}  // namespace gaitwright
