// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "playback/report/plot_style.h"

namespace gaitwright {

/// One pair of axes, as SVG. Add the contents from back to front; then call `Svg()`.
class SvgPlot {
 public:
  /// Size, titles and scales; omitted values follow from the data.
  struct Options {
    std::string title;
    std::string x_label, y_label;  ///< with the unit
    double width_px = 960.0, height_px = 280.0;
    bool equal_axes = false;  ///< one metre has the same length on x and y; the height follows
    bool legend = true;
    bool x_label_room = false;                  ///< keep room for a missing x label, as in a grid
    std::optional<double> x_lowest, x_highest;  ///< if not set, they follow from the data
    std::optional<double> y_lowest, y_highest;
    double y_least_span = 0.0;      ///< keeps noise around a constant from filling the plot
    std::vector<std::string> rows;  ///< names of rows instead of a y scale; row i is at y = i, the first on top
    std::size_t most_points = 900;  ///< of a line
  };

  /// Options of a plot of places to scale: one metre has the same length on x and y.
  static Options ToScale(const std::string& title, const std::string& x_label, const std::string& y_label);

  explicit SvgPlot(Options options);

  /// A line; a point that is not finite interrupts it. A non-empty label appears once in the legend if there is
  /// anything to draw; this also holds for the functions below.
  void Line(const std::vector<Vector2>& points, Ink ink, Stroke stroke, const std::string& label = "");

  /// The area between two lines over x. @throws InvalidArgument unless all have one length.
  void Band(const std::vector<double>& x, const std::vector<double>& lower, const std::vector<double>& upper, Ink ink,
            const std::string& label = "");

  /// A closed area; `filled` gives it a pale fill, otherwise only its outline is drawn. One or two corners give a dot
  /// or a line.
  void Area(const std::vector<Vector2>& corners, Ink ink, bool filled, const std::string& label = "");

  /// A bar in a row (see Options::rows), from x0 to x1; a planned one is tall and pale.
  void Bar(int row, double x0, double x1, Ink ink, Stroke stroke, const std::string& label = "");

  /// A filled circle. Like a cross, it is drawn whole if its middle is within the axes.
  void Dot(const Vector2& at, Ink ink, double radius_px, const std::string& label = "");
  /// A small x.
  void Cross(const Vector2& at, Ink ink, const std::string& label = "");

  /// A line across the whole plot, with words at its end. It extends the scale only if `in_scale`.
  void AcrossX(double y, Ink ink, const std::string& words, bool in_scale);
  void AcrossY(double x, Ink ink, const std::string& words);

  /// `<svg ...>...</svg>` with its corner at `at`, for a page that contains PlotStyle().
  std::string Svg(const Vector2& at = Vector2::Zero()) const;

  /// Height of the whole plot; with equal axes it follows from the data.
  double height_px() const { return MakeFrame().height; }

  /// Only the legend, on one line that ends at `right_px`.
  std::string LegendEndingAt(double right_px, double y_px) const;

  const Options& options() const { return options_; }

 private:
  struct Shape {
    enum class Kind { kLine, kArea, kBar, kDot, kCross, kAcrossX, kAcrossY } kind;
    std::vector<Vector2> points;
    Ink ink;
    Stroke stroke = Stroke::kMeasured;
    bool filled = false;
    double radius_px = 0.0;
    std::string words;
  };
  struct LegendEntry {
    std::string label;
    Shape shape;
  };

  void Add(Shape shape, const std::string& label, bool in_scale);
  void See(const Vector2& point);
  /// Place and range of the axes.
  struct Frame {
    double width, height;             // of the whole [px]
    double left, top, right, bottom;  // of the axes [px]
    Vector2 lowest, highest;          // in the units of the data
    int legend_lines;

    Vector2 Pixel(const Vector2& p) const;
  };
  Frame MakeFrame() const;
  static double WidthOf(const LegendEntry& entry);
  double LegendWidth() const;
  int LegendLines(double available_px) const;  ///< 0 if the legend fits beside the title
  std::string Axes(const Frame& frame) const;
  std::string Draw(const Shape& shape, const Frame& frame) const;
  static bool IsUncut(const Shape& shape, const Frame& frame);
  std::string DrawAcross(const Shape& shape, const Frame& frame) const;
  std::string Legend(const Frame& frame) const;
  std::string DrawEntry(const LegendEntry& entry, double x_px, double y_px) const;

  Options options_;
  std::vector<Shape> shapes_;
  std::vector<LegendEntry> legend_;
  Vector2 lowest_, highest_;
};

}  // namespace gaitwright
