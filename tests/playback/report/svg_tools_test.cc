// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/svg_tools.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitwright {
namespace {

TEST(SvgTools, TicksAreRoundAndInside) {
  const auto ticks = RoundTicks(-0.13, 0.42, 6);
  ASSERT_EQ(ticks.size(), 6u);
  EXPECT_NEAR(ticks.front(), -0.1, 1e-12);
  EXPECT_NEAR(ticks.back(), 0.4, 1e-12);
  EXPECT_TRUE(RoundTicks(1.0, 1.0, 5).empty());
  EXPECT_TRUE(RoundTicks(0.0, std::nan(""), 5).empty());
  EXPECT_GE(RoundTicks(-0.41, 0.43, 1).size(), 2u) << "one tick is no scale";
  EXPECT_TRUE(RoundTicks(0.268, std::nextafter(0.268, 1.0), 5).empty()) << "rounding is no range";
  EXPECT_TRUE(RoundTicks(-5e-324, 5e-324, 5).empty());
  EXPECT_TRUE(RoundTicks(-1e308, 1e308, 1).empty()) << "the span is not finite";
  EXPECT_GE(RoundTicks(0.0, 1e300, 5).size(), 2u);
  for (const double span : {1e-6, 0.7, 3.0, 12345.0}) {
    const auto some = RoundTicks(0.0, span, 5);
    EXPECT_GE(some.size(), 2u) << span;
    EXPECT_LE(some.size(), 7u) << span;
  }
}

TEST(SvgTools, SimplifyingKeepsSpikesAndDropsWhatLiesOnALine) {
  std::vector<Vector2> line;
  for (int i = 0; i <= 1000; ++i) line.emplace_back(i, i == 500 ? 40.0 : 0.0);
  const auto few = Simplified(line, 0.3, 100);
  ASSERT_EQ(few.size(), 5u);
  EXPECT_EQ(few[2], Vector2(500.0, 40.0));
}

TEST(SvgTools, SimplifyingNeverExceedsItsBudgetNorItsTolerance) {
  std::vector<Vector2> noise;
  for (int i = 0; i <= 5000; ++i) noise.emplace_back(0.1 * i, 30.0 * std::sin(12.9898 * i) * std::cos(78.233 * i));
  EXPECT_LE(Simplified(noise, 0.3, 300).size(), 300u);
  std::vector<Vector2> wave;
  for (int i = 0; i <= 1000; ++i) wave.emplace_back(0.5 * i, 50.0 * std::sin(0.02 * i));
  const auto few = Simplified(wave, 0.3, 900);
  EXPECT_LT(few.size(), 100u);
  for (std::size_t k = 1; k < few.size(); ++k) {
    const double middle = 0.5 * (few[k - 1].x() + few[k].x());
    const double chord = 0.5 * (few[k - 1].y() + few[k].y());
    EXPECT_NEAR(chord, 50.0 * std::sin(0.02 * middle / 0.5), 1.0);
  }
}

TEST(SvgTools, ReservedCharactersAreEscaped) {
  EXPECT_EQ(EscapedXml("a<b & \"c\" 'd'>"), "a&lt;b &amp; &quot;c&quot; &#39;d&#39;&gt;");
  EXPECT_EQ(EscapedXml(std::string("x\x01y")), "xy");
  EXPECT_EQ(SvgText(1.0, 2.0, "tick", ""), "");
}

}  // namespace
}  // namespace gaitwright
