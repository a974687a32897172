// SPDX-License-Identifier: BSD-3-Clause
// The verb `tune`, and the option file that it writes.
#include <csignal>
#include <filesystem>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Tuned = Stranger;

TEST_F(Tuned, OptionsThatCannotBeWrittenInTheEndAreNotLost) {
  const Ran ran = RunUntil({"tune", "--gait", "trot", "--distance", "0.3", "--over", "stabilised.dcm_gain=1:2",
                            "--evaluations", "2", "--trials", "1", "--held-out", "6", "--quiet"},
                           SIGCONT, [&] {
                             return std::filesystem::exists(In("tuned.yaml.so-far")) &&
                                    std::filesystem::create_directory(In("tuned.yaml"));
                           });
  ExpectRefused(ran, 1,
                {"cannot write 'tuned.yaml': it is a folder", "--resume", "'tuned.yaml.so-far' keeps the results"});
  EXPECT_TRUE(std::filesystem::exists(In("tuned.yaml.so-far")));
}

TEST_F(Tuned, OptionsAreWrittenProvedAndTaken) {
  const std::vector<std::string> tune = {"tune",
                                         "--gait",
                                         "trot",
                                         "--distance",
                                         "0.3",
                                         "--over",
                                         "gait.cycle_s=0.4:0.6",
                                         "--over",
                                         "stabilised.dcm_gain=1:2",
                                         "--evaluations",
                                         "3",
                                         "--trials",
                                         "1",
                                         "--finalists",
                                         "1",
                                         "--held-out",
                                         "6",
                                         "--json",
                                         "--report",
                                         "tuned.html",
                                         "--result",
                                         "tuned.json"};
  const Ran ran = Run(tune);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(Read("tuned.json"), ran.out);
  EXPECT_EQ(json.at("candidates").size(), 3U);
  EXPECT_EQ(json.at("candidates").at(0).at("found_by"), "usual");
  EXPECT_EQ(json.at("usual"), (Json{{"gait.cycle_s", 0.0}, {"stabilised.dcm_gain", 1.3}}));
  EXPECT_EQ(json.at("better").get<bool>(), json.at("options") != json.at("usual"));
  EXPECT_TRUE(json.at("held_out").is_null() || json.at("held_out").at("trials") == 6);
  EXPECT_EQ(Found(), (std::vector<std::string>{"tuned.html", "tuned.json", "tuned.yaml"}));
  std::vector<std::string> two_threads = tune;
  two_threads.insert(two_threads.end(), {"--threads", "2"});
  EXPECT_EQ(Run(two_threads).out, ran.out);

  const Ran planned = Run({"plan", "--distance", "0.3", "--gait", "trot", "--options", "tuned.yaml"});
  EXPECT_EQ(planned.status, 0) << planned.err;
  EXPECT_NE(planned.err.find("': stabilised.dcm_gain"), std::string::npos) << planned.err;
  EXPECT_EQ(Run({"walk", "--distance", "0.3", "--gait", "trot", "--options", "tuned.yaml", "--json"}).err, "");
}

TEST_F(Tuned, OptionsOfAFileAreThoseOfSetAndSetWins) {
  Write("o.yaml", "stabilised.dcm_gain: 2.5\nplay.friction: 0.7\n");
  MakePlan("plan.json");
  const auto score = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"play", "plan.json", "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return Run(all).json().at("metrics");
  };
  const Json by_file = score({"--options", "o.yaml"});
  EXPECT_EQ(by_file, score({"--set", "stabilised.dcm_gain=2.5", "--set", "play.friction=0.7"}));
  EXPECT_NE(by_file, score({}));
  EXPECT_EQ(score({"--options", "o.yaml", "--set", "stabilised.dcm_gain=1.3", "--set", "play.friction=0"}), score({}));
}

TEST_F(Tuned, RefusalsSayWhy) {
  ExpectRefused(Run({"tune", "--over", "speed=0.1:0.5"}), 1, {"'speed' cannot be tuned", "sweep it instead"});
  ExpectRefused(Run({"tune", "--over", "play.friction=0.5:1"}), 1, {"'play.friction' cannot be tuned"});
  ExpectRefused(Run({"tune", "--over", "gait.cycle_s=0.4,0.5"}), 1, {"KEY=FROM:TO"});
  ExpectRefused(Run({"tune", "--over", "gait.cycle_s=0.4:0.5", "--evaluations", "1"}), 1, {"accepted: 2 to"});
  Write("o.yaml", "gait.cycle: 0.5\n");
  ExpectRefused(Run({"walk", "--options", "o.yaml"}), 1, {"'o.yaml', line 1", "'gait.cycle'", "'gait.cycle_s'"});
  ExpectRefused(Run({"walk", "--options", "none.yaml"}), 1, {"no such file"});
}

}  // namespace
}  // namespace gaitwright::cli
