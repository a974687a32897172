// SPDX-License-Identifier: BSD-3-Clause
// Exit status 2: no plan exists; exit status 3: the verdict is a fail.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Verdicts = Stranger;

TEST_F(Verdicts, APlanPastLimitsIsGivenOnlyWhenAskedFor) {
  ExpectRefused(Run({"walk", "--speed", "1.6", "--set", "gait.duty_factor=0.6", "--out-dir", "no"}), 2,
                {"past its limit of 21", "a speed of ", "pipeline.allow_limits=true"});
  EXPECT_TRUE(Found().empty());
  const Ran ran =
      Run({"plan", "--speed", "1.6", "--set", "gait.duty_factor=0.6", "--set", "pipeline.allow_limits=true", "--json"});
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_FALSE(ran.json().at("warnings").empty());
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
  std::string urdf = MakePlan("plan.json").at("urdf");  // its motors are too slow for the audit only
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
