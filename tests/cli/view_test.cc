// SPDX-License-Identifier: BSD-3-Clause
// Motions are looked at: pages, pictures, films and figures.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class View : public Stranger {
 protected:
  View() {
    EXPECT_EQ(Run({"walk", "--speed", "0.5", "--distance", "0.3", "--engine", "bullet", "--quiet", "--out-dir", "out"})
                  .status,
              0);
  }

  bool Begins(const std::string& name, const std::string& with) const { return Read(name).starts_with(with); }
};

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

TEST_F(View, RendersPicturesFilmsAndFigures) {
  const Ran all =
      Run({"render",   "out/log.json", "--png",    "p.png",    "--at",   "0.8",          "--gif", "f.gif",   "--mp4",
           "f.mp4",    "--from-s",     "0.5",      "--to-s",   "0.8",    "--fps",        "10",    "--width", "322",
           "--height", "201",          "--figure", "gait.pdf", "--hide", "ghost,swings", "--json"});
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_EQ(all.json().at("files").size(), 4U);
  EXPECT_TRUE(Begins("p.png", "\x89PNG"));
  EXPECT_TRUE(Begins("f.gif", "GIF89a"));
  EXPECT_NE(Read("f.mp4").substr(0, 12).find("ftyp"), std::string::npos);
  EXPECT_TRUE(Begins("gait.pdf", "%PDF"));
  EXPECT_EQ(Run({"render", "out/plan.json", "--figure", "gait.svg", "--cycles", "2", "--quiet"}).out, "gait.svg\n");
  EXPECT_NE(Read("gait.svg").find("support polygons"), std::string::npos);
  const Ran many = Run({"render", "out/plan.json", "--figure", "MANY.SVG", "--cycles", "900"});
  EXPECT_NE(many.out.find("of 900 cycles: the motion ends there"), std::string::npos) << many.out;
}

TEST_F(View, RenderRefusesWhatItCannotMake) {
  ExpectRefused(Run({"render", "out/log.json"}), 1, {"nothing to render", "--png"});
  ExpectRefused(Run({"render", "out/log.json", "--figure", "gait.eps"}), 1, {"'.eps'", ".svg or .pdf"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.jpg"}), 1, {"'.jpg'", "accepted: .png"});
  ExpectRefused(Run({"render", "out/log.json", "--figure", "g.svg", "--cycles", "1001"}), 1, {"1001", "1000"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png", "--view", "above"}), 1, {"'above'", "'top'"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png", "--hide", "gost"}), 1, {"'gost'", "'ghost'"});
  ExpectRefused(Run({"render", "out/log.json", "--gif", "p.gif", "--fps", "0"}), 1, {"frames per second", "1"});
  ExpectRefused(Run({"render", "out/log.json", "--gif", "p.gif", "--from-s", "2", "--to-s", "1"}), 1, {"2", "1"});
  ExpectRefused(Run({"render", "out/log.json", "--figure", "g.svg", "--at", "1"}), 1, {"--at is for --png only"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png", "--fps", "9"}), 1,
                {"--fps is for --gif or --mp4 only"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png", "--cycles", "2"}), 1, {"--cycles", "--figure"});
  ExpectRefused(Run({"render", "out/plan.json", "--png", "p.png", "--plan", "out/log.json"}), 1, {"is for logs"});
  ExpectRefused(Run({"render", "out/log.json", "--png", "p.png", "--meshes", "out/log.json"}), 1, {"is not a folder"});
  ExpectRefused(Run({"view", "out/plan.json", "--plan", "out/plan.json"}), 1, {"is for logs"});
  ExpectRefused(Run({"render", "out/log.json", "--figure", "g.svg", "--from-s", "99"}), 1, {"99.000", "lasts from"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"out"})) << "nothing was written";
}

}  // namespace
}  // namespace gaitwright::cli
