// SPDX-License-Identifier: BSD-3-Clause
// `play`: what its own flags do.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Played : public Stranger {
 protected:
  Played() { MakePlan("plan.json"); }
};

TEST_F(Played, OrbitSaysWhyAShortWalkHasNoMultipliers) {
  const Ran ran = Run({"play", "plan.json", "--orbit", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json orbit = ran.json().at("orbit");
  EXPECT_EQ(orbit.at("verdict"), "unknown");
  EXPECT_TRUE(orbit.at("multipliers").empty());
  EXPECT_NE(orbit.at("missing"), "");
  EXPECT_NE(Run({"play", "plan.json", "--orbit"}).out.find("\norbit: "), std::string::npos);
  EXPECT_FALSE(Run({"play", "plan.json", "--json"}).json().contains("orbit"));
}

TEST_F(Played, WalkMeasuresTheOrbitToo) {
  const Ran ran = Run({"walk", "--robot", "a1", "--gait", "trot", "--speed", "0.5", "--distance", "0.2", "--engine",
                       "bullet", "--orbit", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("orbit").at("verdict"), "unknown") << "too short";
  EXPECT_NE(Read("out/report.html").find("Orbit stability"), std::string::npos);
}

TEST_F(Played, OrbitIsOfAPlanWithoutDisturbances) {
  ExpectRefused(Run({"play", "plan.json", "--orbit", "--disturbances", "standard"}), 1, {"--orbit", "--disturbances"});
  ExpectRefused(Run({"play", "--policy", "policy.onnx", "--contract", "deploy.yaml", "--orbit"}), 1,
                {"--orbit", "policy"});
}

TEST_F(Played, QuietlyPrintsTheVerdictAndWritesTheLog) {
  const Ran ran = Run({"play", "plan.json", "--log", "log.json", "--quiet"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "pass\n");
  EXPECT_EQ(Json::parse(Read("log.json")).at("format"), "gaitwright-playback-log");
}

}  // namespace
}  // namespace gaitwright::cli
