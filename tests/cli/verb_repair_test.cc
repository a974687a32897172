// SPDX-License-Identifier: BSD-3-Clause
// The verb `repair`: output, files and refusals.
#include <csignal>

#include "playback/viewer/viewer_page.h"
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Repair : public Stranger {
 protected:
  void SetUp() override {
    Stranger::SetUp();
    MakePlan("plan.json");
    EXPECT_EQ(Run({"export", "plan.json", "--format", "csv", "--out", "motion.csv", "--quiet"}).status, 0);
  }
};

TEST_F(Repair, KeepsASoundMotionAndPlaysIt) {
  const Ran ran = Run({"repair", "motion.csv", "--out", "new/repaired.json", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("robot"), "a1");
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_EQ(json.at("kept"), true);
  EXPECT_LT(json.at("distance").at("joint_largest_rad"), 0.01);
  EXPECT_EQ(json.at("files").at("plan"), "new/repaired.json");
  EXPECT_EQ(Run({"audit", "new/repaired.json", "--quiet"}).out, "pass\n");
}

TEST_F(Repair, RefusesTrajectoryOptionsWithoutEffect) {
  for (const char* option : {"trajectory.timing=optimised", "trajectory.swings=free", "trajectory.near=2"})
    ExpectRefused(Run({"repair", "motion.csv", "--set", option}), 1, {"'trajectory."});
}

TEST_F(Repair, LiftsAMotionThatFloatsAndOnlyChecksIfAsked) {
  const Ran checked = Run({"repair", "motion.csv", "--set", "lift_m=0.02", "--check"});
  EXPECT_EQ(checked.status, 3) << checked.err;
  EXPECT_NE(checked.out.find("lifted: the base was moved down by 20.0 mm"), std::string::npos) << checked.out;
  EXPECT_EQ(checked.out.find("after:"), std::string::npos);
  const Ran ran = Run({"repair", "motion.csv", "--set", "lift_m=0.02", "--no-play", "--out", "down.json"});
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("after: audit: pass"), std::string::npos) << ran.out;
}

TEST_F(Repair, WritesAPageAlsoWhenItOnlyChecksOrRefuses) {
  const auto scene = [&](const std::string& name) {
    const std::string page = Read(name), start = "id=\"scene\">";
    const std::size_t at = page.find(start) + start.size();
    return Json::parse(page.substr(at, page.find("</script>", at) - at)).at("motions").at(0);
  };
  const std::vector<std::string> repair = {"repair", "motion.csv", "--set", "lift_m=0.02"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = repair;
    words.insert(words.end(), more.begin(), more.end());
    return Run(words);
  };
  const Ran ran = with({"--report", "pages/page.html", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("files"), (Json{{"plan", "repaired.json"}, {"report", "pages/page.html"}}));
  EXPECT_EQ(ran.json().at("distance").at("groups").at("feet").at("unit"), "m");
  if (HasViewer()) {
    EXPECT_EQ(scene("pages/page.html").at("ghost").at("title"), "original motion");
  }
  for (const char* part : {"id=\"broken\"", "id=\"laws\"", "id=\"groups\"", "id=\"changes\"", "id=\"engines\""})
    EXPECT_NE(Read("pages/page.html").find(part), std::string::npos) << part;

  const Ran checked = with({"--check", "--report", "check.html", "--json"});
  EXPECT_EQ(checked.status, 3) << checked.err;
  EXPECT_EQ(checked.json().at("files"), (Json{{"report", "check.html"}}));
  if (HasViewer()) {
    EXPECT_TRUE(scene("check.html").at("ghost").is_null());
  }
  EXPECT_EQ(Read("check.html").find("id=\"groups\""), std::string::npos);

  const Ran refused =
      with({"--set", "trajectory.max_iterations=1", "--set", "trajectory.max_solves=1", "--report", "refused.html"});
  ASSERT_EQ(refused.status, 2) << refused.out << refused.err;
  EXPECT_NE(Read("refused.html").find(">REFUSED</span>"), std::string::npos);
  EXPECT_NE(Read("refused.html").find("id=\"laws\""), std::string::npos) << "the first half";
  std::filesystem::create_directories(In("clips"));
  std::filesystem::copy_file(In("motion.csv"), In("clips/a.csv"));
  ExpectRefused(Run({"repair", "clips", "--report", "clips.html"}), 1, {"--report is for a single motion"});
}

TEST_F(Repair, SaysForHowLongEachCheckFails) {
  const Ran ran = Run({"repair", "motion.csv", "--set", "lift_m=0.02", "--check", "--json"});
  ASSERT_EQ(ran.status, 3) << ran.err;
  const Json broken = ran.json().at("broken");
  ASSERT_FALSE(broken.empty());
  for (const Json& one : broken) {
    EXPECT_GT(one.at("share").get<double>(), 0.0);
    EXPECT_LE(one.at("share").get<double>(), 1.0);
    EXPECT_LE(one.at("worst_s").size(), 3U);
  }
  EXPECT_NE(Run({"import", "motion.csv", "--set", "lift_m=0.004"}).out.find(" of the time, longest from "),
            std::string::npos);
}

TEST_F(Repair, AFolderIsRepairedAndResumedAfterAKill) {
  std::filesystem::create_directories(In("clips"));
  for (const char* const name : {"a.csv", "b.csv", "c.csv", "d.csv"})
    std::filesystem::copy_file(In("motion.csv"), In("clips") / name);
  Write("clips/broken.csv", "1,2,3\n4,5,6\n");
  const std::vector<std::string> repair = {"repair", "clips", "--set", "lift_m=0.02", "--no-play", "--threads", "1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), repair.begin(), repair.end());
    return more;
  };
  const Ran whole = Run(with({"--out", "whole", "--json"}));
  ASSERT_EQ(whole.status, 3) << whole.err;
  EXPECT_EQ(whole.json().at("passed"), 4);
  EXPECT_EQ(whole.json().at("clips").at(0).at("verdict"), "refused");
  EXPECT_EQ(Run({"audit", "whole/a.csv.plan.json", "--quiet"}).out, "pass\n");

  const auto some = [&] { return std::filesystem::exists(In("part/b.csv.plan.json")); };
  EXPECT_EQ(RunUntil(with({"--out", "part"}), SIGKILL, some).status, 128 + SIGKILL);
  ExpectRefused(Run(with({"--out", "part"})), 1, {"clips.csv.so-far", "--resume"});
  const Ran resumed = Run(with({"--out", "part", "--resume", "--quiet"}));
  EXPECT_EQ(resumed.out, "4 of 5 pass\n") << resumed.err;
  std::string table = Read("part/clips.csv");
  for (std::size_t at = table.find("part/"); at != std::string::npos; at = table.find("part/"))
    table.replace(at, 5, "whole/");
  EXPECT_EQ(table, Read("whole/clips.csv"));
  EXPECT_FALSE(std::filesystem::exists(In("part/clips.csv.so-far")));
}

TEST_F(Repair, ALongMotionContinuesAfterAKill) {
  const std::vector<std::string> repair = {"repair",   "motion.csv",        "--set", "lift_m=0.02",
                                           "--set",    "repair.window_s=1", "--set", "repair.overlap_s=0.4",
                                           "--no-play"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), repair.begin(), repair.end());
    return more;
  };
  ASSERT_EQ(Run(with({"--out", "whole.json"})).status, 0);
  EXPECT_FALSE(std::filesystem::exists(In("whole.json.so-far")));
  const auto some = [&] {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(In("part.json.so-far"), ignored);
    return !ignored && size > 10000;
  };
  ASSERT_EQ(RunUntil(with({"--out", "part.json"}), SIGKILL, some).status, 128 + SIGKILL);
  ExpectRefused(Run(with({"--out", "part.json"})), 1, {"part.json.so-far", "--resume"});
  ExpectRefused(Run(with({"--out", "part.json", "--set", "repair.joint=3", "--resume"})), 1,
                {"belongs to another run"});
  EXPECT_EQ(Run(with({"--out", "part.json", "--resume"})).status, 0);
  EXPECT_EQ(Read("part.json"), Read("whole.json"));
  EXPECT_FALSE(std::filesystem::exists(In("part.json.so-far")));
}

TEST_F(Repair, SlowsOnlyWhatItMay) {
  ExpectRefused(Run({"repair", "motion.csv", "--stretch", "0.5"}), 1, {"stretch"});
  const Ran ran = Run({"repair", "motion.csv", "--set", "lift_m=0.01", "--stretch", "1.5", "--no-play", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  for (const Json& change : json.at("changes")) EXPECT_NE(change.at("what"), "slowed") << "it can keep its speed";
}

}  // namespace
}  // namespace gaitwright::cli
