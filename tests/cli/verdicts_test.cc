// SPDX-License-Identifier: BSD-3-Clause
// Exit status 2, no plan exists, and 3, the verdict is a fail.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Verdicts = Stranger;

/// Doubles what the first motor does.
void DoubleFirstTorque(Json& plan) {
  for (Json& row : plan.at("tau_nm")) row.at(0) = 2.0 * row.at(0).get<double>() + 1.0;
}

TEST_F(Verdicts, TooFastNamesTheLargestSpeed) {
  const Ran ran = Run({"walk", "--speed", "9", "--out-dir", "no"});
  ExpectRefused(ran, 2, {"the largest speed with gait 'trot' is ", " m/s", "try: --speed "});
  const std::string speed = ran.err.substr(ran.err.find("--speed ") + 8, 4);
  EXPECT_EQ(Run({"plan", "--speed", speed, "--distance", "0.5", "--quiet"}).status & ~3, 0)
      << "the speed that the hint names has a plan, whatever its audit says";
  EXPECT_FALSE(std::filesystem::exists(In("no")));
}

TEST_F(Verdicts, FlightIsNotPlanned) {
  for (const char* gait : {"pronk", "bound", "gallop"}) {
    ExpectRefused(Run({"walk", "--gait", gait, "--out-dir", "no"}), 2, {gait, "flight", "not planned"});
  }
  const Ran ran = Run({"plan", "--gait", "pronk", "--json"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.json().at("error").at("code"), "gait_with_flight");
  EXPECT_TRUE(Found().empty());
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
    urdf.replace(at, fast.size(), "velocity='1'");
  Write("slow.urdf", urdf);
  const Ran object = Run({"walk", "--urdf", "slow.urdf", "--distance", "0.3", "--json"});
  EXPECT_EQ(object.status, 3) << object.err;
  EXPECT_EQ(object.json().at("verdict"), "fail");
  EXPECT_EQ(object.json().at("reason"), "the plan fails its audit: joint_velocity");
  EXPECT_EQ(object.json().at("metrics").at("fell").at("value"), false);
  const Ran words = Run({"walk", "--urdf", "slow.urdf", "--distance", "0.3"});
  EXPECT_EQ(words.status, 3);
  EXPECT_TRUE(words.out.starts_with("FAIL   the plan fails its audit: joint_velocity")) << words.out.substr(0, 200);
}

}  // namespace
}  // namespace gaitwright::cli
