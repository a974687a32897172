// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/svg_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "playback/report/plot_grid.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

SvgPlot Example() {
  SvgPlot::Options options;
  options.title = "Heights <of> feet";
  options.x_label = "time [s]";
  options.y_label = "z [m]";
  SvgPlot plot(options);
  plot.Band({0.0, 1.0, 2.0}, {-1.0, -1.0, std::nan("")}, {1.0, 1.0, 1.0}, Ink::kSupport, "bounds");
  plot.Line({{0.0, 0.0}, {1.0, 2.0}, {1.5, std::nan("")}, {2.0, 1.0}, {3.0, 0.0}}, Ink::kZmp, Stroke::kMeasured, "ZMP");
  plot.Line({{0.0, 0.0}, {3.0, 1.0}}, Ink::kZmp, Stroke::kPlanned, "ZMP planned");
  plot.AcrossX(1.5, Ink::kLimit, "limit", true);
  plot.AcrossY(2.5, Ink::kBad, "fell");
  plot.Dot({1.0, 1.0}, Ink::kFoot, 3.0);
  plot.Cross({2.0, 1.0}, Ink::kFoot, "feet");
  plot.Area({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, Ink::kSupport, true);
  return plot;
}

TEST(SvgPlot, IsWellFormedWithTicksLabelsAndLegend) {
  const std::string svg = Example().Svg();
  EXPECT_EQ(XmlFault(svg), "") << svg;
  for (const char* part : {"Heights &lt;of&gt; feet", "time [s]", "z [m]", ">bounds<", ">ZMP planned<", ">limit<",
                           ">fell<", ">feet<", "class=\"zmp planned\"", "class=\"grid\""}) {
    EXPECT_TRUE(Has(svg, part)) << part;
  }
  EXPECT_FALSE(Has(svg, "nan"));
  EXPECT_FALSE(Has(svg, "http")) << "only a file of its own needs the name space";
}

TEST(SvgPlot, AGapInterruptsALine) {
  SvgPlot plot{SvgPlot::Options{}};
  plot.Line({{0.0, 0.0}, {1.0, 1.0}, {2.0, std::nan("")}, {3.0, 0.0}, {4.0, 1.0}}, Ink::kCom, Stroke::kMeasured);
  const std::string svg = plot.Svg();
  const std::size_t path = svg.find("<path d=\"M");
  const std::string d = svg.substr(path, svg.find("\" class", path) - path);
  EXPECT_EQ(std::count(d.begin(), d.end(), 'M'), 2) << d;
}

TEST(SvgPlot, EqualAxesHaveTheSameScale) {
  for (const Vector2& size : {Vector2(3.0, 0.2), Vector2(1.0, 1.0), Vector2(0.2, 3.0)}) {
    SvgPlot::Options options;
    options.equal_axes = true;
    SvgPlot plot(options);
    const double r = 0.1;
    plot.Area({{0.0, 0.0}, size}, Ink::kSupport, false);
    plot.Area({{0.0, 0.0}, {r, 0.0}, {r, r}, {0.0, r}}, Ink::kBad, false);
    const std::string svg = plot.Svg();
    const std::size_t at = svg.rfind("<path d=\"M");
    double x[4], y[4];
    ASSERT_EQ(std::sscanf(svg.c_str() + at, "<path d=\"M%lf %lfL%lf %lfL%lf %lfL%lf %lf", x, y, x + 1, y + 1, x + 2,
                          y + 2, x + 3, y + 3),
              8);
    EXPECT_NEAR(x[1] - x[0], y[1] - y[2], 0.25);
  }
}

TEST(SvgPlot, RoundingIsDrawnAsAConstant) {
  SvgPlot nearly{SvgPlot::Options{}};
  nearly.Line({{0.0, 0.268}, {1.0, std::nextafter(0.268, 1.0)}}, Ink::kCom, Stroke::kMeasured);
  EXPECT_EQ(XmlFault(nearly.Svg()), "");
  EXPECT_LT(nearly.Svg().size(), 5000U);
}

TEST(SvgPlot, AnEmptyPlotAndAConstantOneAreStillPlots) {
  EXPECT_EQ(XmlFault(SvgPlot{SvgPlot::Options{}}.Svg()), "");
  SvgPlot constant{SvgPlot::Options{}};
  constant.Line({{0.0, 0.3}, {1.0, 0.3}}, Ink::kCom, Stroke::kMeasured);
  EXPECT_FALSE(Has(constant.Svg(), "nan"));
  EXPECT_FALSE(Has(constant.Svg(), "inf"));
}

double NumberAfter(const std::string& svg, const std::string& key, std::size_t from) {
  const std::size_t at = svg.find(key, from);
  return at == std::string::npos ? std::nan("") : std::stod(svg.substr(at + key.size()));
}

TEST(SvgPlot, RowsGoDownwardsAndDotsLieOnTheirBars) {
  SvgPlot::Options options;
  options.rows = {"first", "second", "third"};
  SvgPlot plot(options);
  std::vector<double> bars, dots, names;
  for (int row = 0; row < 3; ++row) {
    plot.Bar(row, 0.0, 1.0, Ink::kFoot, Stroke::kPlanned);
    plot.Dot({0.5, static_cast<double>(row)}, Ink::kBad, 3.0);
  }
  const std::string svg = plot.Svg();
  std::size_t bar = svg.find("class=\"frame\""), dot = 0;
  for (const std::string& name : options.rows) {
    bar = svg.find("<rect", bar + 1);
    dot = svg.find("<circle", dot + 1);
    bars.push_back(NumberAfter(svg, " y=\"", bar) + 0.5 * NumberAfter(svg, " height=\"", bar));
    dots.push_back(NumberAfter(svg, " cy=\"", dot));
    names.push_back(NumberAfter(svg, " y=\"", svg.rfind("<text", svg.find(">" + name + "<"))));
  }
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_NEAR(bars[row], dots[row], 0.2);
    EXPECT_NEAR(names[row], dots[row] + 4.0, 0.2) << "base line of the letters";
  }
  EXPECT_GT(dots[1], dots[0] + 10.0);
  EXPECT_GT(dots[2], dots[1] + 10.0);
}

TEST(SvgPlot, TheLegendNamesOnlyWhatIsDrawn) {
  const double none = std::nan("");
  SvgPlot plot{SvgPlot::Options{}};
  plot.Line({{0.0, none}, {1.0, none}}, Ink::kBad, Stroke::kMeasured, "nowhere");
  plot.Line({{0.0, 1.0}, {1.0, none}, {2.0, 1.0}}, Ink::kBad, Stroke::kMeasured, "single points");
  plot.Line({}, Ink::kBad, Stroke::kMeasured, "no points");
  plot.Dot({none, 0.0}, Ink::kFoot, 2.0, "no dot");
  plot.Line({{0.0, none}, {1.0, 1.0}, {2.0, 2.0}}, Ink::kZmp, Stroke::kMeasured, "drawn");
  plot.Dot({1.0, 1.0}, Ink::kFoot, 2.0, "a dot");
  const std::string svg = plot.Svg();
  for (const char* label : {"nowhere", "single points", "no points", "no dot"}) EXPECT_FALSE(Has(svg, label)) << label;
  for (const char* label : {">drawn<", ">a dot<"}) EXPECT_TRUE(Has(svg, label)) << label;
}

/// The contents of the inner svg are clipped at the axes; elements after it are not.
TEST(SvgPlot, MarksAtTheEdgeAreWholeAndThoseOutsideAreNotThere) {
  SvgPlot::Options options;
  options.x_lowest = options.y_lowest = 0.0;
  options.x_highest = options.y_highest = 1.0;
  SvgPlot plot(options);
  plot.Dot({0.5, 0.5}, Ink::kFoot, 1.5);
  plot.Dot({1.5, 0.5}, Ink::kFoot, 2.5);
  plot.Line({{-1.0, 0.0}, {2.0, 1.0}}, Ink::kZmp, Stroke::kMeasured);
  for (const double end : {0.0, 1.0}) {
    plot.Dot({end, 0.5}, Ink::kFoot, 3.5);
    plot.Dot({0.5, end}, Ink::kFoot, 3.5);
    plot.Cross({end, end}, Ink::kBad);
  }
  const std::string svg = plot.Svg();
  const std::size_t end = svg.find("</svg>");
  const std::string cut = svg.substr(0, end), whole = svg.substr(end);
  const auto count = [](const std::string& text, const std::string& part) {
    int times = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++times;
    return times;
  };
  EXPECT_EQ(count(whole, "r=\"3.5\""), 4);
  EXPECT_EQ(count(whole, "bad heavy"), 4) << "two strokes of each cross";
  EXPECT_EQ(count(cut, "r=\"3.5\"") + count(cut, "bad heavy"), 0);
  for (const char* part : {"r=\"1.5\"", "r=\"2.5\"", "zmp measured"}) EXPECT_EQ(count(cut, part), 1) << part;
}

TEST(SvgPlot, BoundsOfOtherLengthAreRefused) {
  SvgPlot plot{SvgPlot::Options{}};
  EXPECT_THROW(plot.Band({0.0, 1.0}, {0.0}, {1.0, 1.0}, Ink::kSupport), InvalidArgument);
}

TEST(SvgPlot, AFileOfItsOwnHasNameSpaceAndStyle) {
  const std::string file = StandaloneSvg(Example().Svg());
  EXPECT_EQ(file.rfind("<?xml", 0), 0u);
  EXPECT_TRUE(Has(file, "xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(Has(file, "prefers-color-scheme:dark"));
  EXPECT_EQ(XmlFault(file), "");
}

TEST(SvgPlot, AGridHoldsItsPlotsAndOneLegend) {
  SvgPlot::Options options;
  options.width_px = 300.0;
  options.height_px = 100.0;
  options.legend = false;
  std::vector<SvgPlot> plots;
  for (int i = 0; i < 5; ++i) {
    options.title = "plot " + std::to_string(i);
    plots.emplace_back(options);
    plots.back().Line({{0.0, 0.0}, {1.0, 1.0}}, Ink::kJoint, Stroke::kMeasured, "measured");
  }
  const std::string grid = GridOfPlots(plots, 2, "All");
  EXPECT_EQ(XmlFault(grid), "");
  EXPECT_TRUE(Has(grid, "width=\"600\" height=\"326\"")) << grid.substr(0, 200);
  EXPECT_TRUE(Has(grid, ">plot 4<"));
  EXPECT_EQ(grid.find(">measured<"), grid.rfind(">measured<"));
  EXPECT_EQ(GridOfPlots({}, 2, "none"), "");
}

}  // namespace
}  // namespace gaitwright
