// SPDX-License-Identifier: BSD-3-Clause
// Messages to a page.
#include "workflows/live/live_messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/workflows/live/made_world.h"

namespace gaitwright {
namespace {

using MessageJson = nlohmann::ordered_json;

/// A world that stands, made once.
LiveWorld& WorldOfMessages() {
  static const RobotModel model = ChooseRobot("a1", "").value();
  static const std::unique_ptr<LiveWorld> live = MadeWorld(model);
  return *live;
}

TEST(LiveMessages, ARefusalIsTextWhateverItSays) {
  EXPECT_EQ(MessageJson::parse(LiveRefusal("no \"such\" <gait>\n"))["refused"], "no \"such\" <gait>\n");
  EXPECT_TRUE(MessageJson::accept(LiveRefusal("broken \xff UTF-8")));
}

TEST(LiveMessages, APageHasItsNumber) { EXPECT_EQ(LivePageNumber(12), "{\"page\":12}"); }

TEST(LiveMessages, TheGreetingHasRobotGaitsAndOptionsWithTheirRanges) {
  const LiveWorld& live = WorldOfMessages();
  const MessageJson greeting = MessageJson::parse(LiveGreeting(live));
  EXPECT_EQ(greeting["format"], "gaitwright-live");
  EXPECT_EQ(greeting["step_s"], live.step_s());
  EXPECT_EQ(greeting["scene"]["robot"]["joints"].size(), live.model().joints.size());
  std::set<std::string> gaits;
  for (const MessageJson& gait : greeting["gaits"]) gaits.insert(gait.get<std::string>());
  EXPECT_TRUE(gaits.contains("trot"));
  EXPECT_EQ(gaits.size(), greeting["gaits"].size()) << "each once";
  ASSERT_FALSE(greeting["options"].empty());
  for (const auto& [key, option] : greeting["options"].items()) {
    EXPECT_TRUE(option["value"].is_number()) << key;
    EXPECT_TRUE(option["lowest"].is_null() || option["lowest"] <= option["value"]) << key;
    EXPECT_TRUE(option["highest"].is_null() || option["highest"] >= option["value"]) << key;
  }
}

// A page that stayed open over a restart of the program detects the new world by this name.
TEST(LiveMessages, EachGreetingHasANameOfItsOwn) {
  const LiveWorld& live = WorldOfMessages();
  EXPECT_NE(MessageJson::parse(LiveGreeting(live))["run"], MessageJson::parse(LiveGreeting(live))["run"]);
}

TEST(LiveMessages, AFrameIsTheStateOfTheWorld) {
  LiveWorld& live = WorldOfMessages();
  live.Reset("bullet");
  for (int k = 0; k < 20; ++k) live.Step();
  LiveStatus status;
  status.clock.paused = true;
  status.behind_s = 0.25;
  status.notes = {{3, "a note"}};
  const MessageJson frame = MessageJson::parse(LiveFrame(live, status));
  EXPECT_EQ(frame["t"], live.time_s());
  EXPECT_EQ(frame["paused"], true);
  EXPECT_EQ(frame["behind_s"], 0.25);
  EXPECT_EQ(frame["notes"], (MessageJson::array({MessageJson::array({3, "a note"})})));
  ASSERT_EQ(frame["q"].size(), static_cast<std::size_t>(live.model().nq()));
  for (std::size_t i = 0; i < frame["q"].size(); ++i)
    EXPECT_NEAR(frame["q"][i].get<double>(), live.world().q()[static_cast<Eigen::Index>(i)], 1e-6);
  ASSERT_EQ(frame["feet"].size(), live.model().feet.size());
  for (const MessageJson& foot : frame["feet"])
    EXPECT_EQ(foot["f"].is_null(), !foot["touching"].get<bool>()) << "a foot in the air carries no force";
  EXPECT_TRUE(frame["pulls"].empty());
  EXPECT_TRUE(frame["push_n"].is_null());
  EXPECT_EQ(frame["options"].size(), MessageJson::parse(LiveGreeting(live))["options"].size());
}

}  // namespace
}  // namespace gaitwright
