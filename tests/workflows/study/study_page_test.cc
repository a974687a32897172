// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_page.h"

#include <gtest/gtest.h>

#include "tests/playback/xml_check.h"
#include "tests/workflows/study/made_up_sweep.h"

namespace gaitwright {
namespace {

const std::vector<std::string> kSpeedAndPush = {"speed=0.3:0.7:5", "play.push_on=base,robot"};

std::string PageOfSweep(const std::vector<std::string>& over, int trials = 0, int samples = 0) {
  const MadeUpSweep sweep = MakeUpSweep(over, trials, samples);
  return SweepPage(sweep.study, sweep.outcomes);
}

TEST(StudyPage, FramesAnyBodyAndEscapesItsTitle) {
  const std::string page = StudyPage("a < b & c", "<p>body</p>\n");
  EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
  EXPECT_NE(page.find("<title>a &lt; b &amp; c</title>"), std::string::npos);
  EXPECT_EQ(CountOf(page, "<p>body</p>"), 1);
  EXPECT_EQ(CountOf(page, "<style>"), 1);
}

TEST(StudyPage, ATableHasHeadsInItsFirstRowAlone) {
  const std::string table = TableOf({{"a", "b"}, {"1 < 2", "x"}, {"", "y"}});
  EXPECT_EQ(XmlFault(table), "");
  EXPECT_EQ(CountOf(table, "<th>"), 2);
  EXPECT_EQ(CountOf(table, "<td>"), 4);
  EXPECT_EQ(CountOf(table, "<tr>"), 3);
  EXPECT_EQ(CountOf(table, "1 &lt; 2"), 1);
}

TEST(StudyPage, AFigureHasItsPictureAndItsCaption) {
  const std::string figure = FigureOf({"name", "less < more", "<svg></svg>"});
  EXPECT_EQ(XmlFault(figure), "");
  EXPECT_EQ(CountOf(figure, "<svg>"), 1);
  EXPECT_EQ(CountOf(figure, "<figcaption>less &lt; more</figcaption>"), 1);
}

TEST(SweepPages, AreWellFormedForGridsSamplesAndTrials) {
  for (const std::string& page : {PageOfSweep(kSpeedAndPush), PageOfSweep(kSpeedAndPush, 8),
                                  PageOfSweep({"speed=0.1:0.9"}, 0, 12), PageOfSweep({"speed=0.6,0.7"})}) {
    EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
    EXPECT_EQ(CountOf(page, "<script"), 0);
  }
  EXPECT_EQ(PageOfSweep(kSpeedAndPush, 8), PageOfSweep(kSpeedAndPush, 8)) << "the same bytes again";
}

TEST(SweepPages, CountEachStatusAndListEveryPoint) {
  const std::string page = PageOfSweep(kSpeedAndPush);
  EXPECT_EQ(CountOf(page, "<div class=\"card\">"), 5);
  EXPECT_EQ(CountOf(page, "<div class=\"figure\">2</div>"), 5) << "two points of each status";
  EXPECT_EQ(CountOf(page, "20 % of the points"), 5);
  const std::size_t every = page.find("<summary>Every point");
  ASSERT_NE(every, std::string::npos);
  EXPECT_EQ(CountOf(page.substr(every), "<tr>"), 1 + 10);
}

TEST(SweepPages, TrialsAddAMapAndAColumn) {
  const std::string without = PageOfSweep(kSpeedAndPush), with = PageOfSweep(kSpeedAndPush, 8);
  EXPECT_EQ(CountOf(with, "<figure>"), CountOf(without, "<figure>") + 1);
  EXPECT_EQ(CountOf(without, "<th>survived</th>"), 0);
  EXPECT_EQ(CountOf(with, "<th>survived</th>"), 1);
  EXPECT_EQ(CountOf(with, "<td>8 of 8</td>"), 2);
}

TEST(SweepPages, SampledAxesHaveTheScoreOverThem) {
  EXPECT_GT(CountOf(PageOfSweep({"speed=0.1:0.9"}, 0, 12), "Score over speed"), 0);
  EXPECT_EQ(CountOf(PageOfSweep({"speed=0.1:0.9:5"}), "Score over speed"), 0) << "a grid has its map";
}

TEST(SweepPages, TheBestPointIsNamedOrThatThereIsNone) {
  EXPECT_EQ(CountOf(PageOfSweep(kSpeedAndPush), "Best: speed=0.3, play.push_on=base, score 70.0"), 1);
  EXPECT_EQ(CountOf(PageOfSweep({"speed=0.6,0.7"}), "class=\"reason fail\""), 1);
  EXPECT_EQ(CountOf(PageOfSweep({"speed=0.1,0.2"}), "Every point passes."), 1);
}

}  // namespace
}  // namespace gaitwright
