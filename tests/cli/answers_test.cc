// SPDX-License-Identifier: BSD-3-Clause
// Successful commands: exit status 0, and output that a script can read.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

void ExpectKeys(const Json& json, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) EXPECT_TRUE(json.contains(key)) << "no key '" << key << "'";
}

void ExpectJudged(const Json& json) {
  ExpectKeys(json, {"robot", "verdict", "score", "reason", "metrics", "planning_cpu_s", "playback_realtime_factor"});
  EXPECT_EQ(json.at("robot"), "a1");
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_GT(json.at("playback_realtime_factor"), 0.0);
  EXPECT_GT(json.at("metrics").size(), 20U);
  for (const auto& [key, metric] : json.at("metrics").items()) {
    SCOPED_TRACE(key);
    ExpectKeys(metric, {"value", "unit", "limit", "pass", "at_s"});
  }
  EXPECT_NEAR(json.at("metrics").at("distance_m").at("value"), 0.3, 0.02);
}

class Answers : public Stranger {
 protected:
  /// Whether the program has the engine, from the message if it does not.
  bool HasMujoco() {
    const Ran ran = Run({"walk", "--robot", "a1", "--distance", "0.2", "--engine", "mujoco", "--out-dir", "probe"});
    std::filesystem::remove_all(In("probe"));
    return ran.err.find("libmujoco-dev") == std::string::npos;
  }
};

TEST_F(Answers, WalkGivesItsObjectAndWritesItsFiles) {
  const Ran ran = Run({"walk", "--robot", "a1", "--distance", "0.3", "--json"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  const Json json = ran.json();
  ExpectJudged(json);
  EXPECT_GT(json.at("planning_cpu_s"), 0.0);
  for (const char* kind : {"plan", "log", "report"}) {
    const std::string file = json.at("files").at(kind);
    EXPECT_TRUE(std::filesystem::is_regular_file(In(file))) << file;
  }
  EXPECT_EQ(Found(), std::vector<std::string>{"out"});
  EXPECT_EQ(Json::parse(Read("out/log.json")).at("robot"), "a1");
  EXPECT_NE(Read("out/report.html").find("</html>"), std::string::npos);
}

TEST_F(Answers, WalkPlaysInBothEnginesByDefault) {
  if (!HasMujoco()) GTEST_SKIP() << "this program was built without MuJoCo";
  const Json both = Run({"walk", "--robot", "a1", "--distance", "0.3", "--json"}).json();
  ASSERT_EQ(both.at("engines").size(), 2U);
  EXPECT_EQ(both.at("engines")[0].at("engine"), "bullet");
  EXPECT_EQ(both.at("engines")[1].at("engine"), "mujoco");
  EXPECT_EQ(both.at("agreement").at("agree"), true);
  EXPECT_EQ(both.at("score"), std::min(both.at("engines")[0].at("score"), both.at("engines")[1].at("score")));
  EXPECT_TRUE(std::filesystem::is_regular_file(In(both.at("files").at("second_log").get<std::string>())));
  const Json one = Run({"play", "out/plan.json", "--engine", "mujoco", "--json"}).json();
  EXPECT_EQ(one.at("engine"), "mujoco");
  EXPECT_FALSE(one.contains("engines"));
  EXPECT_EQ(one.at("log_hash"), both.at("engines")[1].at("log_hash"));
  const Ran compared = Run({"compare", "out/log.json", "out/log-mujoco.json", "--plan", "out/plan.json", "--json"});
  EXPECT_EQ(compared.json().at("agreement").at("engines"), (Json{"bullet", "mujoco"})) << compared.err;
  const Json set = Run({"walk", "--robot", "a1", "--distance", "0.3", "--set", "play.engine=bullet", "--json"}).json();
  EXPECT_FALSE(set.contains("engines"));
  EXPECT_FALSE(std::filesystem::exists(In("out/log-mujoco.json"))) << "it was of the walk before";
  const Ran wrong = Run({"walk", "--engine", "ode"});
  EXPECT_EQ(wrong.status, 1);
}

TEST_F(Answers, TrialsRunInBothEngines) {
  ASSERT_EQ(Run({"plan", "--distance", "0.3", "--out", "a.json"}).status, 0);
  if (!HasMujoco()) GTEST_SKIP() << "this program was built without MuJoCo";
  const Ran ran = Run({"trials", "a.json", "-n", "2", "--engine", "both", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("n"), 2);
  EXPECT_EQ(ran.json().at("second").at("n"), 2);
  EXPECT_EQ(Found(), (std::vector<std::string>{"a.json", "trials-mujoco.json", "trials.json"}));
}

TEST_F(Answers, PlanAuditAndPlayHandThePlanOn) {
  const Ran planned = Run({"plan", "--distance", "0.3", "--out", "a.json", "--json"});
  EXPECT_EQ(planned.status, 0) << planned.err;
  ExpectKeys(planned.json(), {"robot", "verdict", "gait", "duration_s", "planning_cpu_s", "audit", "files"});
  EXPECT_EQ(planned.json().at("files").at("plan"), "a.json");

  const Ran audited = Run({"audit", "a.json", "--json"});
  EXPECT_EQ(audited.status, 0) << audited.err;
  EXPECT_EQ(audited.json().at("verdict"), "pass");
  EXPECT_EQ(audited.json().at("violations"), Json::array());

  const Ran played = Run({"play", "a.json", "--json", "--log", "b/log.json", "--report", "c.html"});
  EXPECT_EQ(played.status, 0) << played.err;
  ExpectJudged(played.json());
  EXPECT_EQ(played.json().at("files"), (Json{{"plan", "a.json"}, {"log", "b/log.json"}, {"report", "c.html"}}));
  EXPECT_EQ(Found(), (std::vector<std::string>{"a.json", "b", "c.html"}));
}

TEST_F(Answers, WhatThereIsIsListed) {
  const Ran robots = Run({"robots", "--json"});
  EXPECT_EQ(robots.status, 0);
  EXPECT_EQ(robots.json().at("robots").at(0).at("name"), "a1");
  const Ran a1 = Run({"robots", "show", "a1", "--json"});
  EXPECT_EQ(a1.status, 0);
  EXPECT_EQ(a1.json().at("legs").size(), 4U);
  const Ran gaits = Run({"gaits", "--json"});
  EXPECT_EQ(gaits.status, 0);
  EXPECT_GT(gaits.json().at("gaits").size(), 5U);
  const Ran terrains = Run({"terrains", "--json"});
  EXPECT_EQ(terrains.status, 0);
  ExpectKeys(terrains.json().at("terrains").at(0), {"name", "description", "parameters"});
  EXPECT_TRUE(Found().empty());
}

TEST_F(Answers, EveryTerrainOfTheListIsShownAndWalked) {
  const Json listed = Run({"terrains", "--json"}).json();  // keeps the temporary alive in the loop
  for (const Json& entry : listed.at("terrains")) {
    const std::string name = entry.at("name");
    SCOPED_TRACE(name);
    const Ran shown = Run({"terrains", "show", name, "--json"});
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_EQ(shown.json().at("name"), name);
    EXPECT_EQ(shown.json().at("description"), entry.at("description"));
    ASSERT_FALSE(shown.json().at("patches").empty());
    ExpectKeys(shown.json().at("patches").at(0), {"name", "origin_m", "normal", "outline_m", "friction"});
    EXPECT_NE(Run({"terrains", "show", name}).out.find("friction"), std::string::npos);
    EXPECT_EQ(Run({"plan", "--terrain", name, "--distance", "0.3", "--quiet"}).status, 0);
  }
}

TEST_F(Answers, QuietPrintsTheVerdictAlone) {
  EXPECT_EQ(Run({"plan", "--distance", "0.3", "--quiet"}).out, "pass\n");
  EXPECT_EQ(Run({"audit", "plan.json", "--quiet"}).out, "pass\n");
  EXPECT_EQ(Run({"play", "plan.json", "--quiet"}).out, "pass\n");
  EXPECT_EQ(Run({"walk", "--distance", "0.3", "--quiet"}).out, "pass\n");
  EXPECT_EQ(Run({"robots", "--quiet"}).out, "a1\ng1\ngo1\nh1\nh1_2\nhumanoid\nlaikago\nmini_cheetah\nnao\n");
  EXPECT_TRUE(Run({"terrains", "--quiet"}).out.starts_with("flat\n"));
}

TEST_F(Answers, AStrangersOwnRobotWalks) {
  Write("mine/robot.urdf", Json::parse(MakePlan("plan.json").dump()).at("urdf"));
  const Ran shown = Run({"robots", "show", "mine/robot.urdf", "--json"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(shown.json().at("name"), "mine");
  EXPECT_EQ(Run({"walk", "--urdf", "mine/robot.urdf", "--distance", "0.3", "--quiet"}).out, "pass\n");
}

TEST_F(Answers, TheSameCommandWritesTheSameBytes) {
  for (const char* folder : {"one", "two"}) {
    EXPECT_EQ(Run({"walk", "--distance", "0.3", "--quiet", "--out-dir", folder}).status, 0);
  }
  for (const char* file : {"plan.json", "log.json", "report.html"}) {
    EXPECT_TRUE(Read(std::string("one/") + file) == Read(std::string("two/") + file)) << file;
  }
}

TEST_F(Answers, TheLogIsAsDenseAsAsked) {
  MakePlan("plan.json");
  EXPECT_EQ(Run({"play", "plan.json", "--log", "usual.json", "--quiet"}).status, 0);
  EXPECT_EQ(Run({"play", "plan.json", "--log", "dense.json", "--log-rate-hz", "500", "--quiet"}).status, 0);
  EXPECT_EQ(Run({"walk", "--distance", "0.3", "--engine", "bullet", "--log-rate-hz", "500", "--quiet"}).status, 0);
  const Json usual = Json::parse(Read("usual.json")), dense = Json::parse(Read("dense.json"));
  EXPECT_EQ(usual.at("log_rate_hz"), 200.0);
  EXPECT_EQ(dense.at("log_rate_hz"), 500.0);
  EXPECT_EQ(2 * dense.at("q").size(), 5 * usual.at("q").size());
  EXPECT_TRUE(Read("dense.json") == Read("out/log.json")) << "a plan's log is the same from walk and from play";
}

TEST_F(Answers, NegativeNumbersAreNoFlags) {
  const Ran back = Run({"walk", "--goal", "-0.2,0,0", "--json", "--push", "-5,-5,0", "--push-at", "1"});
  EXPECT_EQ(back.status, 0) << back.err;
  EXPECT_NEAR(back.json().at("metrics").at("distance_m").at("value"), 0.2, 0.02);
}

}  // namespace
}  // namespace gaitwright::cli
