// SPDX-License-Identifier: BSD-3-Clause
// HTML pages of motions.
#include "tests/cli/viewed.h"

namespace gaitwright::cli {
namespace {

TEST_F(View, MakesAPageOfAPlanALogAndTwo) {
  const Ran plan = Run({"view", "out/plan.json", "--json"});
  ASSERT_EQ(plan.status, 0) << plan.err;
  EXPECT_EQ(plan.json().at("files"), (Json{{"page", "view.html"}}));
  EXPECT_EQ(plan.json().at("page_bytes"), Read("view.html").size());
  EXPECT_TRUE(Begins("view.html", "<!DOCTYPE html>"));
  EXPECT_EQ(Run({"view", "out/log.json", "--out", "log.html", "--quiet"}).out, "log.html\n")
      << "its plan lies beside it";
  const Ran two = Run({"view", "out/log.json", "out/plan.json", "--out", "two.html"});
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_NE(two.out.find(" beside "), std::string::npos);
  EXPECT_GT(Read("two.html").size(), Read("log.html").size());
  EXPECT_EQ(Run({"view", "out/log.json", "--out", "again.html", "--quiet"}).status, 0);
  EXPECT_TRUE(Read("log.html") == Read("again.html")) << "the same bytes";
}

TEST_F(View, ShowsASecondMotionAsAGhost) {
  ASSERT_EQ(Run({"plan", "--distance", "0.4", "--out", "other.json", "--quiet"}).status, 0);
  const Ran ran = Run({"view", "out/plan.json", "other.json", "--ghost", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.json().at("shows").get<std::string>().find(" with the ghost of "), std::string::npos);
  const std::string page = Read("view.html");
  EXPECT_NE(page.find("\"ghost\":{\"title\":"), std::string::npos);
  EXPECT_EQ(Run({"view", "other.json", "out/log.json", "--plan", "out/plan.json", "--ghost", "--quiet"}).status, 0)
      << "a log";
  ExpectRefused(Run({"view", "other.json", "--ghost"}), 1, {"give a second FILE"});
  ASSERT_EQ(Run({"plan", "--robot", "go1", "--distance", "0.3", "--out", "go1.json", "--quiet"}).status, 0);
  ExpectRefused(Run({"view", "other.json", "go1.json", "--ghost"}), 1, {"same robot", "'a1'", "'go1'"});
}

TEST_F(View, TheReportHasTheMotionInIt) {
  const std::string report = Read("out/report.html");
  EXPECT_NE(report.find("data-scene=\"scene\""), std::string::npos);
  EXPECT_NE(report.find("gaitwright-scene"), std::string::npos);
}

TEST_F(View, RefusesWhatItCannotShow) {
  std::filesystem::rename(In("out/plan.json"), In("plan-of-it.json"));
  ExpectRefused(Run({"view", "out/log.json"}), 1, {"does not contain the ground", "--plan FILE"});
  EXPECT_EQ(Run({"view", "out/log.json", "--plan", "plan-of-it.json", "--quiet"}).status, 0);
  std::filesystem::remove(In("view.html"));
  ASSERT_EQ(Run({"plan", "--distance", "0.4", "--out", "other.json", "--quiet"}).status, 0);
  ExpectRefused(Run({"view", "out/log.json", "--plan", "other.json"}), 1, {"not the plan", "hash"});
  ExpectRefused(Run({"view", "out/report.html"}), 1, {"neither a plan nor a log"});
  ExpectRefused(Run({"view", "other.json", "--out", "other.json"}), 1, {"would overwrite"});
  ExpectRefused(Run({"view", "none.json"}), 1, {"none.json"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"other.json", "out", "plan-of-it.json"})) << "nothing was written";
}

}  // namespace
}  // namespace gaitwright::cli
