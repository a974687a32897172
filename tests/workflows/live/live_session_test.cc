// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_session.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "playback/play/make_world.h"
#include "tests/workflows/live/made_world.h"
#include "tests/workflows/live/socket_client.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

RobotModel Robot() { return ChooseRobot("a1", "").value(); }

/// A standing world, made once; tests that change it begin with a reset.
LiveWorld& World() {
  static const RobotModel model = Robot();
  static const std::unique_ptr<LiveWorld> live = MadeWorld(model);
  return *live;
}

class Session : public testing::Test {
 protected:
  Session()
      : live_(World()),
        server_(std::move(LiveServer::Start({}, "").value())),
        session_(live_, *server_,
                 {[this](const std::string& note) { notes_.push_back(note); },
                  [this](const std::string& line) { phases_.push_back(line); }},
                 [this] { return spent_s_ += look_s_; }) {
    live_.Reset("bullet");
    live_.SetGround(0.0, 0.0, 0.0);
    live_.SetControl({});
    live_.TakeNotes();
    server_->Greet(LiveGreeting(live_));
    const std::string host = "127.0.0.1:" + std::to_string(server_->port());
    page_ = std::make_unique<SocketClient>(server_->port());
    EXPECT_EQ(page_->Open("/live", "http://" + host, host), 101);
    greeting_ = Json::parse(page_->Hear().value_or("null"));
    number_ = Json::parse(page_->Hear().value_or("null"))["page"];
  }

  /// The next frame after this real time.
  Json Picture(double wall_s) {
    session_.Turn(wall_s);
    return Json::parse(page_->Hear().value_or("null"));
  }
  /// The next message to the page after its request: a refusal, or a frame that shows its effect.
  Json Say(const Json& message) {
    const std::string mark = "no more than that";  // its refusal shows that all earlier messages are processed
    page_->Say(message.dump());
    page_->Say(Json({{"do", mark}}).dump());
    Json refusal, heard;
    for (int tries = 0; tries < 2000; ++tries) {
      session_.Turn(0.0);
      bool marked = false;
      while ((heard = Json::parse(page_->Hear().value_or("null"))).contains("refused")) {
        if (heard["refused"].get<std::string>().find(mark) != std::string::npos)
          marked = true;
        else
          refusal = heard;
      }
      if (marked) return refusal.is_null() ? heard : refusal;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {};
  }

  LiveWorld& live_;
  std::unique_ptr<LiveServer> server_;
  LiveSession session_;
  std::unique_ptr<SocketClient> page_;
  Json greeting_;
  HandId number_ = 0;
  std::vector<std::string> notes_, phases_;
  double spent_s_ = 0.0, look_s_ = 0.0;  ///< work takes no time, except that each reading of the clock adds this
};

TEST_F(Session, GreetsWithRobotGaitsAndOptions) {
  EXPECT_EQ(greeting_["format"], "gaitwright-live");
  EXPECT_EQ(greeting_["scene"]["robot"]["name"], live_.model().name);
  EXPECT_EQ(greeting_["scene"]["robot"]["dofs"].size(), 12U);
  EXPECT_EQ(greeting_["gaits"][0], "stand");
  EXPECT_NE(std::find(greeting_["gaits"].begin(), greeting_["gaits"].end(), "trot"), greeting_["gaits"].end());
  EXPECT_EQ(greeting_["options"]["gains.stance_damping"]["value"], 0.7);
}

TEST_F(Session, ResetsInAnotherEngine) {
  ASSERT_EQ(greeting_["engines"], Json(EngineNames()));
  EXPECT_EQ(Picture(0.01)["ground"]["engine"], "bullet");
  for (const std::string& engine : EngineNames()) {
    EXPECT_FALSE(Say({{"do", "reset"}, {"engine", engine}}).contains("refused"));
    for (int i = 0; i < 30; ++i) Picture(0.0166667);
    const Json picture = Picture(0.01);
    EXPECT_EQ(picture["ground"]["engine"], engine);
    EXPECT_EQ(picture["mode"], "stands");
    EXPECT_LT(live_.time_s(), 1.0);
  }
  const Json answer = Say({{"do", "reset"}, {"engine", "both"}});
  ASSERT_TRUE(answer.contains("refused"));
  EXPECT_NE(answer["refused"].get<std::string>().find("both"), std::string::npos);
}

TEST_F(Session, GoesAsFastAsTheWallsClock) {
  const double begun = live_.time_s();
  for (int i = 0; i < 60; ++i) Picture(0.0166667);
  EXPECT_NEAR(live_.time_s() - begun, 1.0, 0.02);
  const Json picture = Picture(0.01);
  EXPECT_EQ(picture["mode"], "stands");
  EXPECT_EQ(picture["q"].size(), 19U);
  EXPECT_EQ(picture["feet"].size(), 4U);
  ASSERT_EQ(picture["stiffness"].size(), 12U);
  EXPECT_NEAR(picture["stiffness"][2].get<double>(), live_.gains().stiffness[2], 1e-4);
  EXPECT_GT(picture["damping"][2].get<double>(), 0.0);
  EXPECT_NEAR(picture["measured"]["margin_m"].get<double>(), 0.1, 0.1);
  EXPECT_EQ(picture["measured"]["support"].size(), 4U);
  EXPECT_EQ(picture["options"].size(), greeting_["options"].size());
}

TEST_F(Session, SaysThatItFallsBehindAndNeverRushesAfter) {
  const double before = live_.time_s();
  look_s_ = 1e-3;  // a step takes as long as its simulated time
  Json picture;
  for (int i = 0; i < 8; ++i) picture = Picture(30.0);  // far more than can be done in the time of one frame
  EXPECT_GT(picture["behind_s"].get<double>(), 0.1);
  EXPECT_LE(picture["behind_s"].get<double>(), LiveSession::kMostBehind);
  ASSERT_FALSE(notes_.empty());
  EXPECT_NE(notes_.back().find("slower than real time"), std::string::npos) << notes_.back();
  EXPECT_NEAR(live_.time_s() - before, 8.0 / LiveSession::kPictures_hz, 0.02);
  EXPECT_EQ(picture["notes"].back()[1], notes_.back());
}

TEST_F(Session, PausesStepsAndResets) {
  Picture(0.1);
  EXPECT_TRUE(Say({{"do", "clock"}, {"paused", true}})["paused"].get<bool>());
  const double paused = live_.time_s();
  Picture(1.0);
  EXPECT_EQ(live_.time_s(), paused);
  Say({{"do", "clock"}, {"steps", 3}});
  EXPECT_NEAR(live_.time_s() - paused, 3.0 * live_.step_s(), 1e-9);
  Say({{"do", "reset"}});
  EXPECT_EQ(live_.time_s(), live_.plan().whole_body.start_s);
  EXPECT_FALSE(Say({{"do", "clock"}, {"paused", false}})["paused"].get<bool>());
}

TEST_F(Session, PosesAreWithinTheLimitsOfJoints) {
  std::vector<double> q(19, 0.0);
  q[2] = 0.5;
  q[6] = 2.0;  // a quaternion of any length
  for (int d = 0; d < 12; ++d) q[static_cast<std::size_t>(7 + d)] = live_.model().dof_lower(d) - 1e-5;  // rounded
  const Json picture = Say({{"do", "pose"}, {"q", q}});
  EXPECT_EQ(picture["mode"], "posed");
  EXPECT_NEAR(picture["q"][7].get<double>(), live_.model().dof_lower(0), 1e-6);
  EXPECT_EQ(picture["q"][6], 1.0);
  EXPECT_EQ(picture["feet"].size(), 4U);
  q[7] = 100.0;
  EXPECT_NE(Say({{"do", "pose"}, {"q", q}})["refused"].get<std::string>().find("FL_hip"), std::string::npos);
  EXPECT_EQ(Say({{"do", "stand_up"}})["mode"], "stands");
}

TEST_F(Session, PullsGroundOptionsAndNudges) {
  Say({{"do", "pull"}, {"body", 0}, {"at_m", {0.0, 0.0, 0.0}}, {"by_m", {0.0, 1.0, 0.0}}});
  const Json pulls = Picture(0.005)["pulls"];
  ASSERT_EQ(pulls.size(), 1U);
  EXPECT_EQ(pulls[0]["page"], number_);
  EXPECT_GT(pulls[0]["force_n"][1].get<double>(), 10.0);
  EXPECT_LE(pulls[0]["force_n"][1].get<double>(), greeting_["spring"]["most_n"].get<double>());
  Say({{"do", "let_go"}});
  EXPECT_TRUE(Picture(0.005)["pulls"].empty());
  Say({{"do", "push"}, {"force_n", {0.0, 12.0, 0.0}}, {"for_s", 0.05}});
  EXPECT_EQ(Picture(0.02)["push_n"][1], 12.0);
  EXPECT_TRUE(Picture(0.05)["push_n"].is_null());
  const Json ground = Say({{"do", "ground"}, {"friction", 0.5}, {"slope_deg", 5.0}, {"slope_direction_deg", 90.0}});
  EXPECT_EQ(ground["ground"]["friction"], 0.5);
  EXPECT_EQ(ground["ground"]["slope_deg"], 5.0);
  EXPECT_GT(std::abs(ground["ground"]["pose"][3].get<double>()), 0.03) << "turned about x";
  const Json options = Say({{"do", "options"}, {"options", {{"gains.stance_damping", 1.25}}}});
  EXPECT_NE(std::find(options["options"].begin(), options["options"].end(), 1.25), options["options"].end());
  const Json stiff = Say({{"do", "options"}, {"options", {{"gains.stiffness_scale", 2.0}}}});
  EXPECT_NEAR(stiff["stiffness"][2].get<double>(), 2.0 * ground["stiffness"][2].get<double>(), 1e-3);
  EXPECT_FALSE(Say({{"do", "nudge"}, {"dof", 2}, {"by", 0.1}, {"for_s", 0.3}}).contains("refused"));
}

TEST_F(Session, GaitsGoByTheirOwnNames) {
  for (const char* name : {"walk", "crawl"}) {
    Say({{"do", "pace"}, {"gait", name}, {"speed_m_s", 0.1}});
    ASSERT_TRUE(live_.wanted()) << name;
    EXPECT_EQ(live_.wanted()->pace.gait, "crawl");
    live_.Reset();
  }
}

TEST_F(Session, APageThatIsLostWhileItPullsLetsGo) {
  Say({{"do", "pull"}, {"body", 0}, {"at_m", {0.0, 0.0, 0.0}}, {"by_m", {0.0, 0.1, 0.0}}});
  EXPECT_EQ(live_.hands().grips().size(), 1U);
  page_.reset();
  for (int tries = 0; tries < 500 && !live_.hands().grips().empty(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session_.Turn(0.0);
  }
  EXPECT_TRUE(live_.hands().grips().empty());
}

TEST_F(Session, WhatIsNoMessageIsRefusedInWordsAndChangesNothing) {
  for (const auto& [message, word] : std::vector<std::pair<std::string, std::string>>{
           {"", "JSON"},
           {"{", "JSON"},
           {"[1]", "do"},
           {R"({"do":7})", "do"},
           {R"({"do":"dance"})", "dance"},
           {R"({"do":"reset","now":true})", "now"},
           {R"({"do":"clock","paused":1})", "paused"},
           {R"({"do":"clock","steps":-1})", "steps"},
           {R"({"do":"pull","body":99,"at_m":[0,0,0],"by_m":[0,0,0]})", "body"},
           {R"({"do":"pull","body":0,"at_m":[0,0,0],"by_m":[0,0,0],"along":1})", "along"},
           {R"({"do":"pull","body":0,"at_m":[0,0,0],"by_m":[0,0,1e9]})", "pull distance"},
           {R"({"do":"pull","body":0,"at_m":[0,0],"by_m":[0,0,0]})", "at_m"},
           {R"({"do":"pull","body":0,"at_m":[0,0,1e9],"by_m":[0,0,0]})", "hold point too far"},
           {R"({"do":"ground","friction":-1,"slope_deg":0,"slope_direction_deg":0})", "friction"},
           {R"({"do":"ground","friction":1,"slope_deg":89,"slope_direction_deg":0})", "slope"},
           {R"({"do":"options","options":{"gains.nothing":1}})", "nothing"},
           {R"({"do":"options","options":{"gains.stance_damping":-1}})", "stance_damping"},
           {R"({"do":"options","options":[1]})", "options"},
           {R"({"do":"pose","q":[1,2,3]})", "q"},
           {R"({"do":"pose","q":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]})", "quaternion"},
           {R"({"do":"options","options":{"gains.stance_damping":1,"gains.nothing":1}})", "nothing"},
           {R"({"do":"pace","gait":"trot","speed_m_s":1e9})", "speed_m_s"},
           {R"({"do":"pace"})", "gait"},
           {R"({"do":"pace","gait":"dance"})", "dance"},
           {R"({"do":"pace","gait":"biped"})", "biped"},
           {R"({"do":"pace","gait":"../gaits.yaml:trot"})", "file"},
           {R"({"do":"heading","heading_deg":"north"})", "heading_deg"},
           {R"({"do":"push","force_n":[0,1e5,0],"for_s":0.1})", "times the robot's weight"},
           {R"({"do":"nudge","dof":12,"by":0.1,"for_s":0.5})", "dof"},
           {R"({"do":"nudge","dof":1,"by":3,"for_s":0.5})", "moved"}}) {
    LiveClock clock;
    const VectorX q = live_.world().q();
    const PlayRequest play = live_.play();
    try {
      ReadLiveRequest(live_.model(), message)(live_, clock, number_);
      ADD_FAILURE() << message << " was taken";
    } catch (const InvalidArgument& refused) {
      EXPECT_NE(std::string(refused.what()).find(word), std::string::npos) << message << ": " << refused.what();
    }
    EXPECT_EQ(live_.world().q(), q);
    EXPECT_EQ(clock.steps, 0);
    EXPECT_FALSE(clock.paused);
    EXPECT_EQ(live_.mode(), LiveMode::kStands);
    EXPECT_FALSE(live_.wanted());
    EXPECT_TRUE(live_.hands().grips().empty());
    EXPECT_FALSE(live_.hands().push_W());
    EXPECT_EQ(live_.play().gains.stance_damping, play.gains.stance_damping);
    EXPECT_EQ(live_.play().play.world.friction, play.play.world.friction);
    EXPECT_EQ(live_.play().play.world.ground_slope_deg, play.play.world.ground_slope_deg);
  }
  EXPECT_NE(Say({{"do", "dance"}})["refused"].get<std::string>().find("dance"), std::string::npos);
}

TEST_F(Session, TellsEachChangeOfContact) {
  live_.Ask({.gait = "trot", .speed_m_s = 0.3});
  while (live_.wanted()) {
    live_.WaitForPlan();
    Picture(0.001);
  }
  for (int i = 0; i < 200; ++i) Picture(0.01);
  EXPECT_EQ(live_.mode(), LiveMode::kWalks);
  ASSERT_GT(phases_.size(), 6U);
  EXPECT_NE(phases_.back().find("walks"), std::string::npos) << phases_.back();
  EXPECT_NE(phases_.back().find("planned"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
