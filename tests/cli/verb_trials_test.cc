// SPDX-License-Identifier: BSD-3-Clause
// Output, files and exit statuses of `gaitwright trials` and `play --disturbances`.
#include <algorithm>
#include <csignal>
#include <fstream>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Trials : public Stranger {
 protected:
  Trials() {
    MakePlan("plan.json");
    Write("calm.yaml", "mass_scale: {uniform: [0.95, 1.05]}\nfriction: 0.8\n");
    Write("hard.yaml", "pushes:\n  - {size_n: {uniform: [500, 900]}, direction_deg: 90, at_s: 1}\n");
  }
};

TEST_F(Trials, WriteTheSameForAnyNumberOfThreads) {
  const Ran one =
      Run({"trials", "plan.json", "-n", "3", "--threads", "1", "--out", "one.json", "--report", "one.html"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_NE(one.out.find("95 % interval"), std::string::npos);
  const Ran two = Run({"trials", "plan.json", "-n", "3", "--threads", "2", "--out", "two.json", "--json"});
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_TRUE(Read("one.json") == Read("two.json"));
  const Json json = two.json();
  EXPECT_EQ(json.at("n"), 3);
  EXPECT_EQ(json.at("files").at("result"), "two.json");
  EXPECT_LE(json.at("survival_low"), json.at("survival"));
  EXPECT_TRUE(Read("one.html").ends_with("</html>\n"));
  EXPECT_EQ(Found(),
            (std::vector<std::string>{"calm.yaml", "hard.yaml", "one.html", "one.json", "plan.json", "two.json"}));
}

TEST_F(Trials, TheWorstIsRepeatedBySeed) {
  const Ran ran = Run({"trials", "plan.json", "-n", "2", "--disturbances", "hard.yaml", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json worst = ran.json().at("worst").at(0);
  EXPECT_EQ(worst.at("survived"), false);
  const std::string seed = std::to_string(worst.at("seed").get<int>());
  const std::vector<std::string> repeat = {"play",   "plan.json", "--disturbances", "hard.yaml",
                                           "--seed", seed,        "--json"};
  const Ran played = Run(repeat);
  EXPECT_EQ(played.status, 3) << played.err;
  EXPECT_EQ(played.json().at("reason"), worst.at("reason"));
  EXPECT_EQ(played.json().at("score"), worst.at("score"));
}

TEST_F(Trials, AndEachByTheCommandThatIsGiven) {
  const Ran ran = Run({"trials", "plan.json", "-n", "2", "--disturbances", "calm.yaml", "--state", "estimated",
                       "--sensors", "hobby", "--command-delay", "0.004", "--set", "stabilised.dcm_gain=1.4", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  const Json& trials = json.at("trials");
  const auto of_last = [&](const char* column) {
    const auto& columns = trials.at("columns");
    const auto at = std::find(columns.begin(), columns.end(), column) - columns.begin();
    return trials.at("rows").at(1).at(static_cast<std::size_t>(at));
  };
  std::string command = json.at("repeat").get<std::string>() + " --json";
  for (const auto& [word, with] : {std::pair<std::string, std::string>("gaitwright", ProgramPath()),
                                   {"PLAN", "plan.json"},
                                   {"FILE", "calm.yaml"},
                                   {"SEED", of_last("seed").dump()}})
    command.replace(command.find(word), word.size(), with);
  const Ran again = RunWords({"/bin/sh", "-c", command});
  EXPECT_EQ(again.json().at("log_hash"), of_last("log_hash")) << command << again.err;
  EXPECT_EQ(std::stod(again.json().at("drawn").at("mass_scale").get<std::string>()), of_last("mass_scale"));
}

TEST_F(Trials, WhatWouldActOnNothingIsRefused) {
  Write("imu.yaml", "mass_scale: 1\nsensors: {gyroscope_bias_rad_s: {uniform: [0, 0.01]}}\n");
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "imu.yaml"}), 1,
                {"'sensors.gyroscope_bias_rad_s'", "no sensors", "--state estimated"});
  EXPECT_EQ(Run({"trials", "plan.json", "-n", "1", "--disturbances", "imu.yaml", "--state", "measured", "--quiet"}).out,
            "1 of 1 survived\n");
  Write("downhill.yaml", "ground_slope_direction_deg: 90\n");
  Write("wave.yaml", "mass_scale: {uniform: [0.9, 1.1]}\nbump_wavelength_m: 0.2\nground_bumps_m: 0\n");
  Write("seed.yaml", "bump_seed: 7\n");
  for (const char* verb : {"trials", "play"}) {
    ExpectRefused(Run({verb, "plan.json", "--disturbances", "downhill.yaml"}), 1,
                  {"'ground_slope_direction_deg', which has no effect without 'ground_slope_deg'"});
  }
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "wave.yaml"}), 1,
                {"'bump_wavelength_m', which has no effect without 'ground_bumps_m'"});
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "seed.yaml"}), 1, {"'bump_seed'", "'ground_bumps_m'"});
  EXPECT_EQ(
      Run({"trials", "plan.json", "-n", "1", "--disturbances", "downhill.yaml", "--ground-slope-deg", "1"}).status, 0)
      << "the slope is set";
  const auto set = [this](const char* option) { return Run({"play", "plan.json", "--set", option}); };
  ExpectRefused(set("sensors.imu_rate_hz=500"), 1, {"--set sensors.imu_rate_hz", "no effect", "no sensors"});
  ExpectRefused(set("odometry.start_tilt_rad=0.1"), 1, {"no effect with the state 'true'", "--state estimated"});
  ExpectRefused(set("play.ground_slope_direction_deg=9"), 1, {"no effect without 'ground_slope_deg'"});
  ExpectRefused(Run({"play", "plan.json", "--controller", "joint-pd", "--set", "stabilised.dcm_gain=1.5"}), 1,
                {"--set stabilised.dcm_gain has no effect on the controller 'joint-pd'", "leave it out"});
  ExpectRefused(Run({"sweep", "--over", "stabilised.dcm_gain=1,2", "--controller", "joint-pd"}), 1,
                {"--over stabilised.dcm_gain has no effect on the controller 'joint-pd'"});
  ExpectRefused(Run({"play", "plan.json", "--state", "measured", "--set", "sensors.imu_rate_hz=500"}), 1,
                {"no effect with the state 'measured'", "--state estimated"});
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "calm.yaml", "--set", "play.bump_wavelength_m=0.3"}), 1,
                {"no effect without 'ground_bumps_m'"});
  Write("noise.yaml", "sensor_noise_scale: {uniform: [1, 3]}\n");
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "noise.yaml"}), 1,
                {"'sensor_noise_scale'", "true state"});
  ExpectRefused(Run({"play", "plan.json", "--state", "estimated", "--set", "sensors.imu_rate_hz=400"}), 1,
                {"'sensors.imu_rate_hz' is 400 Hz", "the nearest accepted value is 333.333"});
  ExpectRefused(Run({"play", "plan.json", "--sensors", "hobby"}), 1, {"--sensors is for --state measured"});
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "calm.yaml", "--friction", "0.4"}), 1, {"'friction'"});
  ExpectRefused(Run({"play", "plan.json", "--disturbances", "calm.yaml", "--friction", "0.4"}), 1, {"'friction'"});
  ExpectRefused(Run({"sweep", "--over", "play.friction=0.4,0.8", "--trials", "1", "--disturbances", "calm.yaml"}), 1,
                {"'friction'", "--over"});
  for (const char* option : {"play.bump_wavelength_m=0.3", "play.ground_slope_direction_deg=90"}) {
    const Ran ran = Run({"trials", "plan.json", "-n", "1", "--set", option, "--json"});
    EXPECT_EQ(ran.status, 0) << option << ": the standard set has bumps and slopes; " << ran.err;
    EXPECT_NE(ran.out.find(std::string("--set ") + option), std::string::npos) << "the command that repeats it";
  }
  const Ran shown = Run({"trials", "plan.json", "--show-disturbances", "--friction", "0.4"});
  EXPECT_EQ(shown.out.find("friction"), std::string::npos) << "the standard set leaves it to whom says it";
}

TEST_F(Trials, StatusThreeOnlyWhenSurvivalIsRequired) {
  const std::vector<std::string> hard = {"trials", "plan.json", "-n", "2", "--disturbances", "hard.yaml", "--quiet"};
  EXPECT_EQ(Run(hard).out, "0 of 2 survived\n");
  std::vector<std::string> required = hard;
  required.insert(required.end(), {"--require-survival", "0.5"});
  const Ran failed = Run(required);
  EXPECT_EQ(failed.status, 3);
  EXPECT_EQ(failed.out, "fail\n");
  EXPECT_EQ(
      Run({"trials", "plan.json", "-n", "1", "--disturbances", "calm.yaml", "--require-survival", "1", "--quiet"}).out,
      "pass\n");
}

TEST_F(Trials, InWhichNothingVariesAreSaidToAndAreNoEvidence) {
  Write("same.yaml", "mass_scale: 1\n");
  const std::vector<std::string> run = {"trials", "plan.json", "-n", "3", "--disturbances", "same.yaml"};
  EXPECT_NE(Run(run).out.find("note: all 3 trials are identical"), std::string::npos);
  Json result = Json::parse(Read("trials.json"));
  EXPECT_EQ(result.at("different"), 1);
  const Ran page = Run({"audit", "plan.json", "--preflight", "--trials-result", "trials.json"});
  EXPECT_EQ(page.status, 3) << page.err;
  EXPECT_NE(page.out.find("2 only repeat others exactly; counting each once, 1 of 1 did"), std::string::npos)
      << page.out;
  result["trials"]["rows"][1][1] = result["trials"]["rows"][1][2] = false;
  Write("forged.json", result.dump());
  ExpectRefused(Run({"audit", "plan.json", "--preflight", "--trials-result", "forged.json"}), 1,
                {"'forged.json'", "says that 3 of 3 trials survived, but 2 of its rows did"});
}

TEST_F(Trials, WrongOnesAreRefused) {
  Write("bad.yaml", "mass_scale: 1\nfrction: 0.5\n");
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "bad.yaml"}), 1, {"bad.yaml", "line 2", "'friction'"});
  ExpectRefused(Run({"play", "plan.json", "--disturbances", "bad.yaml"}), 1, {"line 2"});
  ExpectRefused(Run({"trials", "plan.json", "-n", "0"}), 1, {"--trials", "0 is too small"});
  ExpectRefused(Run({"trials", "plan.json", "--require-survival", "95"}), 1, {"95", "accepted: 0 to 1"});
  ExpectRefused(Run({"trials", "none.json"}), 1, {"none.json"});
  ExpectRefused(Run({"trials", "plan.json", "--out", "./plan.json"}), 1, {"plan.json"});
  ExpectRefused(Run({"trials", "plan.json", "--until-width", "2"}), 1, {"until_width", "2"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"bad.yaml", "calm.yaml", "hard.yaml", "plan.json"}));
}

TEST_F(Trials, WhatIsSampledIsShownAndReadsBack) {
  const Ran shown = Run({"trials", "plan.json", "--show-disturbances"});
  ASSERT_EQ(shown.status, 0) << shown.err;
  Write("shown.yaml", shown.out);
  EXPECT_EQ(Run({"trials", "plan.json", "--show-disturbances", "--disturbances", "shown.yaml"}).out, shown.out);
  EXPECT_EQ(Run({"trials", "plan.json", "--show-disturbances", "--json"}).json().at("disturbances"), shown.out);
}

TEST_F(Trials, ADiskThatIsFullIsSaidSoAndTheRunGoesOnLater) {
  const std::vector<std::string> run = {"trials",    "plan.json", "-n", "6",      "--disturbances",
                                        "calm.yaml", "--threads", "1",  "--quiet"};
  std::string command = std::string("trap '' XFSZ; ulimit -f 16; exec ") + ProgramPath();  // 8 KiB per file
  for (const std::string& word : run) command += " " + word;
  const Ran full = RunWords({"/bin/sh", "-c", command});
  ExpectRefused(full, 1, {"cannot keep intermediate results in 'trials.json.so-far'", "--resume"});
  EXPECT_EQ(full.err.find("internal error: "), std::string::npos) << full.err;
  EXPECT_TRUE(Read("trials.json.so-far").ends_with("\n")) << "no line is left half written";
  std::vector<std::string> resume = run;
  resume.push_back("--resume");
  EXPECT_EQ(Run(resume).status, 0);
}

TEST_F(Trials, AResultThatCannotBeWrittenInTheEndIsNotLost) {
  const std::vector<std::string> start = {"trials",    "plan.json", "-n",     "4",       "--disturbances",
                                          "calm.yaml", "--threads", "1",      "--quiet", "--out",
                                          "it.json",   "--report",  "it.html"};
  const Ran ran = RunUntil(start, SIGCONT, [&] {  // SIGCONT has no effect on a running process
    const std::string so_far = std::filesystem::exists(In("it.json.so-far")) ? Read("it.json.so-far") : "";
    return std::count(so_far.begin(), so_far.end(), '\n') >= 2 && std::filesystem::create_directory(In("it.html"));
  });
  ExpectRefused(ran, 1, {"cannot write 'it.html': it is a folder", "--resume", "'it.json.so-far' keeps the results"});
  EXPECT_FALSE(std::filesystem::exists(In("it.json")));
  std::filesystem::remove(In("it.html"));
  std::vector<std::string> resume = start;
  resume.push_back("--resume");
  std::vector<std::string> fewer = resume;
  *std::find(fewer.begin(), fewer.end(), "4") = "1";
  EXPECT_EQ(Run(fewer).out, "1 of 1 survived\n");
  EXPECT_TRUE(std::filesystem::exists(In("it.json.so-far"))) << "three more are in it";
  EXPECT_EQ(Run(resume).out, "4 of 4 survived\n");
  EXPECT_EQ(Json::parse(Read("it.json")).at("n"), 4);
  EXPECT_FALSE(std::filesystem::exists(In("it.json.so-far")));
}

TEST_F(Trials, WhatIsOnlyShownNeedsNoPlaceForAResult) {
  std::filesystem::create_directory(In("trials.json"));
  EXPECT_EQ(Run({"trials", "plan.json", "--show-disturbances"}).status, 0);
  ExpectRefused(Run({"trials", "plan.json", "-n", "1"}), 1, {"--out 'trials.json' cannot be written: it is a folder"});
}

TEST_F(Trials, WhatCannotBePlayedIsRefusedAtOnceAndLeavesNothing) {
  Write("late.yaml", "pushes:\n  - {size_n: 10, at_s: {uniform: [0, 100]}}\n");
  Write("nowhere.yaml", "pushes:\n  - {size_n: 10, place: {choice: [base, FR_claf]}}\n");
  Write("loud.yaml", "sensor_noise_scale: {uniform: [0, 100]}\n");
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "late.yaml"}), 1,
                {"some trials", "the push begins at 100 s", "narrow the sampled ranges"});
  ExpectRefused(Run({"trials", "plan.json", "--disturbances", "nowhere.yaml"}), 1, {"'FR_claf'", "'FR_calf'"});
  ExpectRefused(
      Run({"trials", "plan.json", "--disturbances", "loud.yaml", "--sensors", "hobby", "--state", "measured"}), 1,
      {"'sensors.", "with a sensor_noise_scale of 100"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1,0.2", "--trials", "1", "--disturbances", "nowhere.yaml"}), 1,
                {"'FR_claf'"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"calm.yaml", "hard.yaml", "late.yaml", "loud.yaml", "nowhere.yaml",
                                               "plan.json"}));
}

TEST_F(Trials, AKilledRunIsResumedToTheSameBytes) {
  const std::vector<std::string> start = {"trials",         "plan.json", "-n",    "6",       "--threads", "1",
                                          "--disturbances", "calm.yaml", "--out", "it.json", "--quiet"};
  ASSERT_EQ(Run(start).status, 0);
  const std::string whole = Read("it.json");
  std::filesystem::remove(In("it.json"));
  for (const int signal : {SIGKILL, SIGINT}) {
    const Ran killed = RunUntil(start, signal, [&] {  // after two outcomes are on the disk
      const std::string so_far = std::filesystem::exists(In("it.json.so-far")) ? Read("it.json.so-far") : "";
      return std::count(so_far.begin(), so_far.end(), '\n') >= 3;
    });
    EXPECT_EQ(killed.status, 128 + signal) << killed.err;
    EXPECT_EQ(killed.err.find("--resume") != std::string::npos, signal == SIGINT) << killed.err;
    EXPECT_FALSE(std::filesystem::exists(In("it.json")));
    ExpectRefused(Run(start), 1, {"it.json.so-far", "an unfinished run", "--resume"});
    std::vector<std::string> resume = start;
    resume.push_back("--resume");
    ASSERT_EQ(Run(resume).status, 0);
    EXPECT_TRUE(Read("it.json") == whole);
    EXPECT_FALSE(std::filesystem::exists(In("it.json.so-far")));
    std::filesystem::remove(In("it.json"));
  }
}

}  // namespace
}  // namespace gaitwright::cli
