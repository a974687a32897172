// SPDX-License-Identifier: BSD-3-Clause
// The verb `plan`: infeasible requests, gaits with flight, and output paths.
#include <sstream>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Verdicts = Stranger;

/// The flags in the first hint of a refusal.
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
      {{"--robot", "nao", "--lateral-speed", "-0.4", "--distance", "0.3"}, "a lateral speed of about "},
      {{"--robot", "nao", "--yaw-rate", "2", "--duration", "1"}, "a turning rate of "},
      {{"--robot", "nao", "--steps", "2", "--step-length", "0.4"}, "a step length of about "}};
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

using PlanVerb = Stranger;

TEST_F(PlanVerb, QuietPrintsTheVerdictAndWritesTheFileThatIsNamed) {
  const Ran ran = Run({"plan", "--distance", "0.3", "--out", "a.json", "--quiet"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "pass\n");
  EXPECT_EQ(Found(), std::vector<std::string>{"a.json"});
}

TEST_F(PlanVerb, PlacesThatContradictAreRefused) {
  ExpectRefused(Run({"plan", "--out", "a.yaml"}), 1, {"'a.yaml'", "accepted: .json"});
  ExpectRefused(Run({"plan", "--distance", "-1"}), 1, {"the distance is -1 m"});
  ExpectRefused(Run({"plan", "--gait", "trott"}), 1, {"trott", "'trot'"});
  EXPECT_TRUE(Found().empty());
}

}  // namespace
}  // namespace gaitwright::cli
