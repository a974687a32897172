// SPDX-License-Identifier: BSD-3-Clause
// Pictures, films and figures.
#include "tests/cli/viewed.h"

namespace gaitwright::cli {
namespace {

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
