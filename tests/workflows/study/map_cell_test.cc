// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/map_cell.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "tests/playback/xml_check.h"
#include "tests/workflows/study/made_up_sweep.h"

namespace gaitwright {
namespace {

/// Relative luminance of a colour as in WCAG, from 0 (black) to 1 (white), without gamma correction.
double Brightness(const std::string& colour) {
  const auto part = [&](std::size_t at) {
    return static_cast<double>(std::strtol(colour.substr(at, 2).c_str(), nullptr, 16)) / 255.0;
  };
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

TEST(MapCell, ColoursGrowBrighterWithTheShare) {
  double before = -1.0;
  for (int k = 0; k <= 100; ++k) {
    const std::string colour = MapColour(0.01 * k);
    ASSERT_EQ(colour.size(), 7U);
    EXPECT_EQ(colour[0], '#');
    EXPECT_GE(Brightness(colour), before - 1e-3) << k;
    before = Brightness(colour);
  }
  EXPECT_GT(Brightness(MapColour(1.0)), Brightness(MapColour(0.0)) + 0.5);
  EXPECT_EQ(MapColour(0.0), "#00224e");
  EXPECT_EQ(MapColour(1.0), "#fee838");
}

TEST(MapCell, SharesBeyondTheScaleHaveTheColoursOfItsEnds) {
  EXPECT_EQ(MapColour(-3.0), MapColour(0.0));
  EXPECT_EQ(MapColour(7.0), MapColour(1.0));
}

TEST(MapCell, AShareIsThatOfTheQuantity) {
  PointOutcome outcome;
  EXPECT_FALSE(ShareOf(outcome, MapQuantity::kScore));
  EXPECT_FALSE(ShareOf(outcome, MapQuantity::kSurvival));
  outcome.score = 75.0;
  outcome.survival = SurvivalOf(10, 4, 50.0);
  EXPECT_DOUBLE_EQ(ShareOf(outcome, MapQuantity::kScore).value(), 0.75);
  EXPECT_DOUBLE_EQ(ShareOf(outcome, MapQuantity::kSurvival).value(), 0.4);
}

TEST(MapCell, EachStatusHasWordsAndALetterOfItsOwn) {
  std::set<std::string> letters, words;
  for (const PointStatus status : kPointStatuses) {
    letters.insert(LetterOf(status));
    words.insert(WordsOf(status));
  }
  EXPECT_EQ(letters.size(), std::size(kPointStatuses));
  EXPECT_EQ(words.size(), std::size(kPointStatuses));
  EXPECT_EQ(LetterOf(PointStatus::kPass), "");
}

MapCell CellOf(double side) {
  MapCell cell;
  cell.width = cell.height = side;
  return cell;
}

TEST(MapCell, IsWellFormedAndItsWordsAreEscaped) {
  MapCell cell = CellOf(40.0);
  cell.words = "speed < 1 & \"fell\"";
  cell.framed = true;
  for (const PointStatus status : kPointStatuses) {
    for (const bool round : {false, true}) {
      cell.round = round;
      const std::string svg = DrawCell(cell, status, 0.5);
      EXPECT_EQ(XmlFault(svg), "") << svg;
      EXPECT_NE(svg.find("speed &lt; 1 &amp;"), std::string::npos) << svg;
      EXPECT_EQ(CountOf(svg, "<circle") > 0, round);
      EXPECT_EQ(CountOf(svg, "<rect") > 0, !round);
    }
  }
}

/// The picture defines every pattern that a cell uses.
TEST(MapCell, PatternsThatAreUsedAreDefined) {
  const std::string patterns = MapPatterns();
  EXPECT_EQ(XmlFault(patterns), "");
  int used = 0;
  for (const PointStatus status : kPointStatuses) {
    const std::string svg = DrawCell(CellOf(40.0), status, 0.5);
    const std::size_t at = svg.find("url(#");
    if (at == std::string::npos) continue;
    ++used;
    const std::string name = svg.substr(at + 5, svg.find(')', at) - at - 5);
    EXPECT_EQ(CountOf(patterns, "id=\"" + name + "\""), 1) << name;
  }
  EXPECT_EQ(used, CountOf(patterns, "<pattern ")) << "fell, audit failed, refused";
}

TEST(MapCell, ALetterIsLeftOutWhereItCouldNotBeRead) {
  EXPECT_EQ(CountOf(DrawCell(CellOf(40.0), PointStatus::kFell, 0.5), "<text"), 1);
  EXPECT_EQ(CountOf(DrawCell(CellOf(6.0), PointStatus::kFell, 0.5), "<text"), 0);
  EXPECT_EQ(CountOf(DrawCell(CellOf(40.0), PointStatus::kPass, 0.5), "<text"), 0);
}

TEST(MapCell, WithoutAValueItHasNoColourOfTheScale) {
  const std::string svg = DrawCell(CellOf(40.0), PointStatus::kRefused, std::nullopt);
  for (int k = 0; k <= 8; ++k) EXPECT_EQ(svg.find(MapColour(k / 8.0)), std::string::npos) << k;
}

}  // namespace
}  // namespace gaitwright
