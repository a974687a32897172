// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Sweep : public Stranger {
 protected:
  /// A grid of four points: two plans, each with two gains.
  std::vector<std::string> Grid(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {
        "sweep",  "--gait",         "trot", "--distance", "0.3", "--over", "stabilised.dcm_gain=1,1.5",
        "--over", "speed=0.3:0.4:2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(Sweep, GivesItsObjectAndWritesItsFiles) {
  const Ran ran = Run(Grid({"--json", "--report", "map.html", "--map", "map.svg", "--best", "best.json"}));
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const Json json = ran.json();
  EXPECT_EQ(json.at("points").size(), 4U);
  EXPECT_EQ(json.at("counts").at("pass"), 4);
  EXPECT_EQ(json.at("points").at(1).at("values"), (Json{{"stabilised.dcm_gain", 1.0}, {"speed", 0.4}}));
  double best = 0.0;
  for (const Json& point : json.at("points")) best = std::max(best, point.at("score").get<double>());
  EXPECT_EQ(json.at("best").at("score"), best);
  EXPECT_EQ(json.at("files"),
            (Json{{"map", "sweep.csv"}, {"report", "map.html"}, {"picture", "map.svg"}, {"best", "best.json"}}));
  EXPECT_EQ(Found(), (std::vector<std::string>{"best.json", "map.html", "map.svg", "sweep.csv"}))
      << "nothing is left of the run";
  std::istringstream csv(Read("sweep.csv"));
  int lines = 0;
  for (std::string line; std::getline(csv, line);) ++lines;
  EXPECT_EQ(lines, 5);
  // The best plan is that of its point: its score is the same when it is played separately.
  const std::string gain = json.at("best").at("values").at("stabilised.dcm_gain").dump();
  EXPECT_EQ(json.at("best_play_flags"), "--set stabilised.dcm_gain=" + gain.substr(0, gain.find(".0")));
  const Json played = Run({"play", "best.json", "--json", "--set", "stabilised.dcm_gain=" + gain}).json();
  EXPECT_EQ(played.at("score"), json.at("best").at("score"));
}

TEST_F(Sweep, RefusesNamesThatSayAnotherFormat) {
  ExpectRefused(Run(Grid({"--out", "map.json"})), 1, {"--out 'map.json' ends in '.json'", "accepted: .csv"});
  ExpectRefused(Run(Grid({"--best", "best.YML"})), 1, {"--best 'best.YML'", "'.yml'", "accepted: .json"});
  EXPECT_EQ(Found(), std::vector<std::string>()) << "before anything is done";
  ASSERT_EQ(Run({"sweep", "--gait", "trot", "--distance", "0.3", "--over", "speed=0.3,0.4", "--out", "v0.4", "--quiet"})
                .status,
            0);
  EXPECT_EQ(Found(), std::vector<std::string>({"v0.4"})) << "a number is no ending";
}

TEST_F(Sweep, ThreadsAndBeingKilledChangeNotAByte) {
  const std::vector<std::string> more = {"--trials", "1", "--json"};
  const auto with = [&](std::vector<std::string> also) {
    also.insert(also.end(), more.begin(), more.end());
    return Grid(also);
  };
  const Ran one = Run(with({"--threads", "1"}));
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out, Run(with({"--threads", "2"})).out);
  const std::string csv = Read("sweep.csv");
  std::string killed;
  std::filesystem::remove(In("sweep.csv"));
  const auto so_far = [&] { return std::filesystem::exists(In("sweep.csv.so-far")) ? Read("sweep.csv.so-far") : ""; };
  const Ran cut = RunUntil(with({"--threads", "1"}), SIGKILL, [&] {
    killed = so_far();
    return std::count(killed.begin(), killed.end(), '\n') >= 3;  // the first line, and points on the disk
  });
  EXPECT_EQ(cut.status, 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(In("sweep.csv")));
  Write("sweep.csv.so-far", killed + "3 {\"point\":3,\"sta");
  ExpectRefused(Run(Grid({"--trials", "1"})), 1, {"sweep.csv.so-far", "contains an unfinished run", "--resume"});
  EXPECT_TRUE(Run(with({"--resume"})).out == one.out);
  EXPECT_TRUE(Read("sweep.csv") == csv);
  Write("sweep.csv.so-far", killed);
  ExpectRefused(Run(Grid({"--resume"})), 1, {"belongs to another run"});
}

TEST_F(Sweep, AMapThatCannotBeWrittenInTheEndIsNotLost) {
  const std::vector<std::string> start = Grid({"--threads", "1", "--quiet", "--report", "map.html"});
  const Ran ran = RunUntil(start, SIGCONT, [&] {  // SIGCONT has no effect on a running process
    return std::filesystem::exists(In("sweep.csv.so-far")) && std::filesystem::create_directory(In("map.html"));
  });
  ExpectRefused(ran, 1,
                {"cannot write 'map.html': it is a folder", "--resume", "'sweep.csv.so-far' keeps the results"});
  EXPECT_FALSE(std::filesystem::exists(In("sweep.csv")));
  std::filesystem::remove(In("map.html"));
  std::vector<std::string> resume = start;
  resume.push_back("--resume");
  EXPECT_EQ(Run(resume).out, "4 of 4 pass\n");
  EXPECT_EQ(Found(), (std::vector<std::string>{"map.html", "sweep.csv"}));
}

TEST_F(Sweep, AGroundThatWasChangedMeanwhileIsOtherWork) {
  const std::string lawn = "patches:\n  - {name: lawn, height_m: 0, friction: 0.8}\n";
  Write("yard.yaml", lawn);
  const std::vector<std::string> sweep = Grid({"--terrain", "yard.yaml", "--threads", "1", "--quiet"});
  std::vector<std::string> resume = sweep;
  resume.push_back("--resume");
  const Ran cut = RunUntil(sweep, SIGKILL, [&] {
    const std::string so_far = std::filesystem::exists(In("sweep.csv.so-far")) ? Read("sweep.csv.so-far") : "";
    return std::count(so_far.begin(), so_far.end(), '\n') >= 2;
  });
  EXPECT_EQ(cut.status, 128 + SIGKILL);
  Write("yard.yaml", "patches:\n  - {name: lawn, height_m: 0, friction: 0.3}\n");
  ExpectRefused(Run(resume), 1, {"sweep.csv.so-far", "belongs to another run"});
  Write("yard.yaml", lawn);
  EXPECT_EQ(Run(resume).status, 0);
}

TEST_F(Sweep, SamplesAreTakenBetweenTheEnds) {
  const Ran ran = Run({"sweep", "--distance", "0.3", "--over", "speed=0.2:0.4", "--over", "gait.cycle_s=0.4:0.6",
                       "--samples", "2", "--seed", "3", "--json", "--metrics", "distance_m"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("points").size(), 2U);
  EXPECT_TRUE(json.at("axes").at(0).at("values").is_null());
  for (const Json& point : json.at("points")) {
    EXPECT_GE(point.at("values").at("speed"), 0.2);
    EXPECT_LE(point.at("values").at("speed"), 0.4);
    EXPECT_NEAR(point.at("metrics").at("distance_m"), 0.3, 0.05);
  }
}

TEST_F(Sweep, AFlagThatGivesWhatIsVariedIsRefusedAsSetIs) {
  struct Case {
    std::string flag, value, axis;
  };
  const std::vector<Case> cases = {{"--speed", "0.2", "speed=0.1,0.2"},
                                   {"--lateral-speed", "0.1", "lateral_speed=0,0.1"},
                                   {"--yaw-rate", "0", "yaw_rate=0,0.2"},
                                   {"--com-method", "preview", "centre_of_mass.method=preview,optimised"},
                                   {"--state", "measured", "state=measured,estimated"},
                                   {"--command-delay", "0.002", "command_delay_s=0,0.004"},
                                   {"--push", "0,20,0", "play.push_force_y_n=10,20"},
                                   {"--ground-slope-deg", "2", "play.ground_slope_deg=0,4"},
                                   {"--ground-bumps", "0.01", "play.ground_bumps_m=0,0.01"},
                                   {"--friction", "0.5", "play.friction=0.4,0.6"},
                                   {"--mass-scale", "1.1", "play.mass_scale=0.9,1.1"},
                                   {"--log-rate-hz", "200", "play.log_rate_hz=100,200"}};
  for (const auto& [flag, value, axis] : cases) {
    const std::string key = axis.substr(0, axis.find('='));
    ExpectRefused(Run({"sweep", "--over", axis, flag, value}), 1,
                  {flag + " sets what --over " + key + " varies; leave one of them out"});
  }
  ExpectRefused(Run({"sweep", "--over", "step_length=0.05,0.06", "--steps", "4", "--step-length", "0.05"}), 1,
                {"--step-length sets what --over step_length varies"});
  ExpectRefused(Run({"sweep", "--over", "play.push_at_s=1,2", "--push", "0,20,0", "--push-at", "1"}), 1,
                {"--push-at sets what --over play.push_at_s varies"});
  EXPECT_TRUE(Found().empty());
  const Ran other = Run({"sweep", "--distance", "0.3", "--over", "play.push_force_y_n=0,5", "--push", "5,0,0",
                         "--push-at", "1", "--friction", "0.7", "--quiet"});
  EXPECT_EQ(other.status, 0) << "another component, and another option: " << other.err;
}

TEST_F(Sweep, RefusalsSayWhatIsAccepted) {
  ExpectRefused(Run({"sweep"}), 1, {"--over"});
  ExpectRefused(Run({"sweep", "--over", "sped=1:2:3"}), 1, {"no option 'sped'", "'speed'"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1:0.2"}), 1, {"KEY=FROM:TO:COUNT", "--samples"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1:0.2:2", "--metrics", "scor"}), 1, {"scor"});
  ExpectRefused(Run({"sweep", "--over", "gait.cycle_s=0.4,0.5", "--set", "gait.cycle_s=0.6"}), 1,
                {"--set gait.cycle_s=0.6", "leave one of them out"});
  Write("options.yaml", "gait.cycle_s: 0.6\n");
  ExpectRefused(Run({"sweep", "--over", "gait.cycle_s=0.4,0.5", "--options", "options.yaml"}), 1,
                {"--options sets what --over gait.cycle_s varies"});
  std::filesystem::remove(In("options.yaml"));
  ExpectRefused(Run({"sweep", "--over", "step_length=0.05,0.06"}), 1, {"step_length", "--steps"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1,0.2", "--disturbances", "d.yaml"}), 1, {"--trials"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1,0.2", "--out", "a", "--report", "a"}), 1, {"are the same file"});
  ExpectRefused(Run({"sweep", "--over", "speed=0.1,0.2", "--gait", "trott"}), 1, {"trott"});
  EXPECT_TRUE(Found().empty());
}

}  // namespace
}  // namespace gaitwright::cli
