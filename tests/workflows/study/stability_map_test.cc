// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/stability_map.h"

#include <gtest/gtest.h>

#include "tests/workflows/study/made_up_sweep.h"
#include "workflows/study/study_page.h"

namespace gaitwright {
namespace {

std::string Map(const MadeUpSweep& sweep, MapQuantity quantity = MapQuantity::kScore) {
  return DrawStabilityMap(sweep.study, sweep.outcomes, quantity).svg;
}

/// Every element that is opened is closed, in order.
void ExpectWellFormed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (tag.starts_with("!") || tag.ends_with("/")) continue;
    if (tag.starts_with("/")) {
      ASSERT_FALSE(open.empty()) << tag;
      ASSERT_EQ("/" + open.back(), tag);
      open.pop_back();
    } else {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
}

TEST(MapColour, EndsAreThoseOfCividisAndEachStepIsLighter) {
  EXPECT_EQ(MapColour(0.0), "#00224e");
  EXPECT_EQ(MapColour(1.0), "#fee838");
  EXPECT_EQ(MapColour(-3.0), MapColour(0.0));
  double before = -1.0;
  for (int i = 0; i <= 20; ++i) {
    const std::string colour = MapColour(i / 20.0);
    const auto part = [&](std::size_t at) { return static_cast<double>(std::stoi(colour.substr(at, 2), nullptr, 16)); };
    const double luminance = 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
    EXPECT_GT(luminance, before) << i;
    before = luminance;
  }
}

TEST(StabilityMap, MarksEachFailureByPatternAndLetter) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.3:0.7:5", "gait.cycle_s=0.3:0.5:3"});
  const std::string svg = Map(sweep);
  ExpectWellFormed(svg);
  // Three cells of each, and one in the legend.
  for (const char* pattern : {"url(#map-hatched)", "url(#map-crossed)", "url(#map-dots)"})
    EXPECT_EQ(CountOf(svg, pattern), 3 + 1) << pattern;
  for (const char* letter : {">R</text>", ">A</text>", ">F</text>", ">G</text>"})
    EXPECT_EQ(CountOf(svg, letter), 3 + 1) << letter;
  EXPECT_EQ(CountOf(svg, "<title>"), 15);
  EXPECT_EQ(CountOf(svg, MapColour(0.7)), 3 + 1) << "the score's colour, which the scale has too";
  EXPECT_NE(svg.find("speed [m/s]"), std::string::npos);
  EXPECT_NE(svg.find("gait.cycle_s [s]"), std::string::npos);
  EXPECT_NE(svg.find("score 70.0"), std::string::npos);
}

TEST(StabilityMap, WhatDoesNotOccurIsNotInTheLegend) {
  const std::string svg = Map(MakeUpSweep({"speed=0.1:0.3:3", "gait.cycle_s=0.3:0.5:3"}));
  EXPECT_EQ(CountOf(svg, "url(#map-"), 0);
  EXPECT_EQ(svg.find("refused"), std::string::npos);
}

TEST(StabilityMap, TheSurvivalOfTrialsHasItsOwnMap) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.3:0.7:5", "gait.cycle_s=0.3:0.5:3"}, 4);
  const std::string svg = Map(sweep, MapQuantity::kSurvival);
  EXPECT_EQ(CountOf(svg, "\"" + MapColour(1.0) + "\""), 3 + 1) << "three cells, and the end of the scale";
  EXPECT_NE(svg.find("Share of trials survived"), std::string::npos);
}

TEST(StabilityMap, FurtherAxesMakePanelsAndTooManyAreCut) {
  EXPECT_EQ(CountOf(Map(MakeUpSweep({"speed=0.3,0.7", "gait.cycle_s=0.3,0.4", "play.friction=0.4,0.6,0.8"})),
                    "play.friction="),
            3 + 12)
      << "a title over each panel, and one in each cell's words";
  const MadeUpSweep many =
      MakeUpSweep({"speed=0.3,0.7", "gait.cycle_s=0.3,0.4", "play.friction=0.1:1:10", "stabilised.dcm_gain=1:2:5"});
  const StudyPicture picture = DrawStabilityMap(many.study, many.outcomes, MapQuantity::kScore);
  EXPECT_NE(picture.caption.find("beyond the third"), std::string::npos);
  EXPECT_EQ(CountOf(picture.svg, "<title>"), 2 * 2 * 10);
}

TEST(StabilityMap, OneAxisIsAStripAndASampleDiscs) {
  const std::string strip = Map(MakeUpSweep({"speed=0.3:0.7:5"}));
  ExpectWellFormed(strip);
  EXPECT_EQ(CountOf(strip, "<title>"), 5);
  const std::string discs = Map(MakeUpSweep({"speed=0.3:0.7", "gait.cycle_s=0.3:0.5"}, 0, 12));
  ExpectWellFormed(discs);
  EXPECT_EQ(CountOf(discs, "<title>"), 12);
  EXPECT_GE(CountOf(discs, "<circle"), 12);
}

TEST(SweepPage, IsWellFormedAndSaysWhereItFailsAndWhy) {
  for (const int trials : {0, 4}) {
    const MadeUpSweep sweep = MakeUpSweep({"speed=0.3:0.7:5", "gait.cycle_s=0.3:0.5:3"}, trials);
    const std::string page = SweepPage(sweep.study, sweep.outcomes);
    ExpectWellFormed(page.substr(page.find("<body>"), page.find("</html>") - page.find("<body>")));
    EXPECT_NE(page.find("a&lt;1&gt;"), std::string::npos) << "names are escaped";
    EXPECT_NE(page.find("speed 0.7 m/s, gait.cycle_s 0.3 to 0.5 s"), std::string::npos);
    EXPECT_NE(page.find("the knee, &quot;FL_calf&quot;, needs too much"), std::string::npos);
    EXPECT_EQ(CountOf(page, "<figure>"), trials > 0 ? 2 : 1);
  }
  const MadeUpSweep sample = MakeUpSweep({"speed=0.3:0.7", "gait.cycle_s=0.3:0.5"}, 0, 12);
  EXPECT_EQ(CountOf(SweepPage(sample.study, sample.outcomes), "<figure>"), 3)
      << "the map, and the score over each axis";
}

}  // namespace
}  // namespace gaitwright
