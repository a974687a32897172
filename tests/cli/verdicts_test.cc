// SPDX-License-Identifier: BSD-3-Clause
// Exit status 2, no plan exists, and 3, the verdict is a fail.
#include <sstream>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Verdicts = Stranger;

/// Doubles what the first motor does.
void DoubleFirstTorque(Json& plan) {
  for (Json& row : plan.at("tau_nm")) row.at(0) = 2.0 * row.at(0).get<double>() + 1.0;
}

/// The flags that a refusal's first hint tries.
std::vector<std::string> HintOf(const Ran& ran) {
  const std::size_t at = ran.err.find("(try: ") + 6;
  std::istringstream stream(ran.err.substr(at, ran.err.find(';', at) - at));
  std::vector<std::string> flags;
  for (std::string flag; stream >> flag;) flags.push_back(flag);
  return flags;
}

TEST_F(Verdicts, TooMuchNamesWhatWorksWhenTypedIn) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--speed", "9", "--distance", "0.5"}, " with gait 'trot' ("},
      {{"--speed", "9", "--yaw-rate", "1", "--duration", "1"}, " with gait 'trot' ("},
      {{"--robot", "nao", "--lateral-speed", "-0.3", "--distance", "0.3"},
       "the largest lateral speed with gait 'biped' is "},
      {{"--robot", "nao", "--yaw-rate", "2", "--duration", "1"}, "the largest turning rate with gait 'biped' is "},
      {{"--robot", "nao", "--steps", "4", "--step-length", "0.3"}, "the largest step length with gait 'biped' is "}};
  for (const auto& [arguments, message] : cases) {
    SCOPED_TRACE(message);
    std::vector<std::string> asked = {"plan", "--quiet"};
    asked.insert(asked.end(), arguments.begin(), arguments.end());
    const Ran ran = Run(asked);
    ExpectRefused(ran, 2, {message, "try: --"});
    std::vector<std::string> hinted = {"plan", "--quiet"};
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
      if (arguments[i] == "--robot" || arguments[i] == "--steps" || arguments[i] == "--duration" ||
          arguments[i] == "--distance")
        hinted.insert(hinted.end(), {arguments[i], arguments[i + 1]});
    }
    const std::vector<std::string> flags = HintOf(ran);
    hinted.insert(hinted.end(), flags.begin(), flags.end());
    const Ran again = Run(hinted);
    EXPECT_EQ(again.out, "pass\n") << again.err;
  }
}

TEST_F(Verdicts, APlanPastLimitsIsGivenOnlyWhenAskedFor) {
  ExpectRefused(Run({"walk", "--speed", "1.6", "--set", "gait.duty_factor=0.6", "--out-dir", "no"}), 2,
                {"past its limit of 21", "largest speed", "pipeline.allow_limits=true"});
  EXPECT_TRUE(Found().empty());
  const Ran ran =
      Run({"plan", "--speed", "1.6", "--set", "gait.duty_factor=0.6", "--set", "pipeline.allow_limits=true", "--json"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_FALSE(ran.json().at("warnings").empty());
}

TEST_F(Verdicts, GaitsThatLeaveTheGroundArePlannedAndPassTheirAudit) {
  for (const char* gait : {"pronk", "bound"}) {
    const Ran ran = Run({"plan", "--gait", gait, "--distance", "0.4", "--speed", "0.5", "--out-dir", gait, "--json"});
    EXPECT_EQ(ran.status, 0) << gait << ": " << ran.err;
    EXPECT_EQ(Run({"audit", std::string(gait) + "/plan.json", "--quiet"}).out, "pass\n") << gait;
    bool flies = false;
    const Json written = Json::parse(Read(std::string(gait) + "/plan.json"));
    for (const Json& phase : written.at("schedule")) flies = flies || phase.at(2) == 0;
    EXPECT_TRUE(flies) << gait;
  }
}

TEST_F(Verdicts, ABrokenPlanFailsItsAudit) {
  Json plan = MakePlan("plan.json");
  DoubleFirstTorque(plan);
  Write("broken.json", plan.dump());
  const Ran ran = Run({"audit", "broken.json", "--json"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json json = ran.json();
  EXPECT_EQ(json.at("verdict"), "fail");
  ASSERT_FALSE(json.at("violations").empty());
  bool dynamics = false;
  for (const Json& violation : json.at("violations")) {
    EXPECT_TRUE(violation.at("at_s").is_number());
    EXPECT_GT(violation.at("value"), violation.at("limit"));
    EXPECT_FALSE(violation.at("where").get<std::string>().empty());
    EXPECT_FALSE(violation.at("unit").get<std::string>().empty());
    dynamics = dynamics || violation.at("law") == "dynamics";
  }
  EXPECT_TRUE(dynamics) << json.dump();
  EXPECT_EQ(Run({"audit", "broken.json", "--quiet"}).out, "fail\n");
  EXPECT_NE(Run({"audit", "broken.json"}).out.find("dynamics"), std::string::npos);
}

TEST_F(Verdicts, DeratedLimitsFail) {
  MakePlan("plan.json");
  const Ran ran = Run({"audit", "plan.json", "--derate", "torque=0.1,speed=0.9", "--json"});
  EXPECT_EQ(ran.status, 3);
  EXPECT_EQ(ran.json().at("violations").at(0).at("law"), "joint_torque");
  ExpectRefused(Run({"audit", "plan.json", "--derate", "torqe=0.1"}), 1, {"'torqe'", "'torque'"});
  ExpectRefused(Run({"audit", "plan.json", "--derate", "torque"}), 1, {"--derate", "key=value"});
  for (const char* twice : {"torque=0.2,torque=1", "torque=1,speed=1,torque=0.2"})
    ExpectRefused(Run({"audit", "plan.json", "--derate", twice}), 1, {"--derate: 'torque' is given twice"});
}

TEST_F(Verdicts, AHardPushIsAFall) {
  MakePlan("plan.json");
  const Ran ran = Run({"play", "plan.json", "--push", "0,900,0", "--push-at", "1", "--json"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json json = ran.json();
  EXPECT_EQ(json.at("verdict"), "fail");
  EXPECT_EQ(json.at("metrics").at("fell").at("value"), true);
  EXPECT_GT(json.at("metrics").at("time_to_fall_s").at("value"), 1.0);
  EXPECT_FALSE(json.at("reason").get<std::string>().empty());
  EXPECT_EQ(Run({"play", "plan.json", "--push", "0,900,0", "--push-at", "1", "--quiet"}).out, "fail\n");
}

TEST_F(Verdicts, AWalkWhosePlanFailsItsAuditFailsThoughItStands) {
  std::string urdf = MakePlan("plan.json").at("urdf");  // with motors too slow for it, which physics does not mind
  const std::string fast = "velocity=\"21\"";
  for (std::size_t at = 0; (at = urdf.find(fast, at)) != std::string::npos;)
    urdf.replace(at, fast.size(), "velocity='3'");
  Write("slow.urdf", urdf);
  const std::string anyway = "pipeline.allow_limits=true";
  const Ran object = Run({"walk", "--urdf", "slow.urdf", "--distance", "0.3", "--set", anyway, "--json"});
  EXPECT_EQ(object.status, 3) << object.err;
  EXPECT_EQ(object.json().at("verdict"), "fail");
  EXPECT_EQ(object.json().at("reason"), "the plan fails its audit: joint_velocity");
  EXPECT_EQ(object.json().at("metrics").at("fell").at("value"), false);
  const Ran words = Run({"walk", "--urdf", "slow.urdf", "--distance", "0.3", "--set", anyway});
  EXPECT_EQ(words.status, 3);
  EXPECT_TRUE(words.out.starts_with("FAIL   the plan fails its audit: joint_velocity")) << words.out.substr(0, 200);
}

}  // namespace
}  // namespace gaitwright::cli
