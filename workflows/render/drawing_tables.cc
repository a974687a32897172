// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "playback/report/svg_tools.h"
#include "workflows/render/drawing_tables_internal.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

constexpr double kLine = 17.0;         // height of a line of a table [px]
constexpr double kIndent = 14.0;       // indent of the second line of a foot [px]
constexpr double kHeadingHigh = 24.0;  // [px]

/// Upper estimate of the width of a letter in the tables [px].
double WidthOf(char c) {
  if ((c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9')) return 8.0;
  return c == 'm' || c == 'w' ? 11.0 : 6.2;
}

double WidthOf(const std::string& text) {
  return std::accumulate(text.begin(), text.end(), 0.0, [](double sum, char c) { return sum + WidthOf(c); });
}

/// A text, cut if it is wider than its place.
std::string Fitted(const std::string& text, double width_px) {
  if (WidthOf(text) <= width_px) return text;
  std::size_t end = 0;
  for (double wide = WidthOf("..."); end < text.size() && wide + WidthOf(text[end]) <= width_px; ++end)
    wide += WidthOf(text[end]);
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;  // do not cut inside a UTF-8 character
  return text.substr(0, end) + "...";
}

std::string SizeOfFoot(const Foot& foot) {
  constexpr const char* kNames[] = {"point", "ball", "line", "sole"};
  std::string text = kNames[static_cast<std::size_t>(foot.type)];
  if (foot.radius > 0.0) text += fmt::format(", radius {:.1f} mm", 1e3 * foot.radius);
  if (foot.sole_F.empty()) return text;
  Eigen::AlignedBox2d box;
  for (const Vector2& corner : foot.sole_F) box.extend(corner);
  return text + fmt::format(" of {} corners, {:.0f} x {:.0f} mm", foot.sole_F.size(), 1e3 * box.sizes().x(),
                            1e3 * box.sizes().y());
}

void AddHeading(const std::string& words, const Vector2& at_px, DrawnTable& table) {
  table.height_px += kHeadingHigh;
  table.svg += SvgText(at_px.x(), at_px.y() + table.height_px - 6.0, "h", words);
}

void AddLine(const std::string& words, const Vector2& at_px, DrawnTable& table) {
  table.height_px += kLine;
  table.svg += SvgText(at_px.x(), at_px.y() + table.height_px - 5.0, "", words);
}

void AddFeet(const RobotModel& model, const Vector2& at_px, double width_px, DrawnTable& table) {
  AddHeading("Feet", at_px, table);
  for (std::size_t i = 0; i < model.feet.size(); ++i) {
    const Foot& foot = model.feet[i];
    const std::string size =
        fmt::format("{}{}: {}", foot.name, i < model.legs.size() ? "" : " (it may lie on it)", SizeOfFoot(foot));
    const std::string whole = size + "; " + foot.derived_from;
    const bool fits = Fitted(whole, width_px) == whole;
    AddLine(fits ? whole : Fitted(size, width_px), at_px, table);
    if (!fits) AddLine(Fitted(foot.derived_from, width_px - kIndent), at_px + Vector2(kIndent, 0.0), table);
  }
}

/// Adds the signs with their meanings.
void AddSigns(const Vector2& at_px, double width_px, DrawnTable& table) {
  struct Sign {
    const char *picture, *words;
  };
  constexpr Sign kSigns[] = {
      {"<polygon class=\"sole\" points=\"0,-8 16,-8 16,0 0,0\"/><circle class=\"corner\" cx=\"16\" cy=\"0\" "
       "r=\"2.5\"/>",
       "sole and its corners, point or ball of a foot"},
      {"<polygon class=\"support\" points=\"0,-9 18,-9 18,1 0,1\"/>", "support of all feet"},
      {"<circle class=\"mass\" cx=\"8\" cy=\"-4\" r=\"6\"/><path class=\"quarter\" d=\"M8 -4h6a6 6 0 0 0 -6 -6zM8 "
       "-4h-6a6 6 0 0 0 6 6z\"/>",
       "centre of mass"},
      {"<line class=\"jx line\" x1=\"0\" y1=\"-4\" x2=\"16\" y2=\"-4\"/>", "axis along x"},
      {"<line class=\"jy line\" x1=\"0\" y1=\"-4\" x2=\"16\" y2=\"-4\"/>", "along y"},
      {"<line class=\"jz line\" x1=\"0\" y1=\"-4\" x2=\"16\" y2=\"-4\"/>", "along z"},
      {"<line class=\"jo line\" x1=\"0\" y1=\"-4\" x2=\"16\" y2=\"-4\"/>", "between them"},
      {"<circle class=\"jy ring\" cx=\"8\" cy=\"-4\" r=\"6\"/><circle class=\"jy full\" cx=\"8\" cy=\"-4\" r=\"2\"/>",
       "axis toward the reader"},
      {"<circle class=\"jy ring\" cx=\"8\" cy=\"-4\" r=\"6\"/><path class=\"jy line\" d=\"M4 -8l8 8M4 0l8 -8\"/>",
       "away from the reader"}};
  double x = 0.0;
  table.height_px += kLine;
  for (const Sign& sign : kSigns) {
    const double wide = 44.0 + WidthOf(std::string(sign.words));
    if (x > 0.0 && x + wide > width_px) x = 0.0, table.height_px += kLine + 2.0;
    table.svg += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>", at_px.x() + x,
                             at_px.y() + table.height_px - 3.0, sign.picture);
    table.svg += SvgText(at_px.x() + x + 24.0, at_px.y() + table.height_px - 3.0, "", sign.words);
    x += wide;
  }
}

std::string NameOfJoint(const RobotModel& model, const Joint& joint) {
  if (joint.is_mimic)
    return fmt::format("{} (follows {})", joint.name, model.dof_joint[static_cast<std::size_t>(joint.dof)] + 1);
  return joint.name + (joint.is_prismatic() ? " (prismatic)" : "");
}

void AddJoints(const RobotModel& model, const DynamicsScratch& scratch, const Vector2& at_px, double width_px,
               DrawnTable& table) {
  constexpr double kNumberWide = 28.0, kBetween = 12.0, kWidestName = 250.0;
  AddHeading("Joints: number, name, axis in the standing posture", at_px, table);
  const std::size_t n = model.joints.size();
  double name_wide = 0.0, axis_wide = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    name_wide = std::max(name_wide, WidthOf(NameOfJoint(model, model.joints[j])));
    axis_wide = std::max(axis_wide, 1.1 * WidthOf(AxisText(scratch.axis_W[j])));
  }
  name_wide = std::min(name_wide + 8.0, kWidestName);
  const double wide = kNumberWide + name_wide + axis_wide + kBetween;
  const std::size_t columns = std::max<std::size_t>(1, static_cast<std::size_t>((width_px + kBetween) / wide));
  const std::size_t rows = (n + columns - 1) / columns;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t column = j / rows;
    const double x = at_px.x() + wide * static_cast<double>(column);
    const double y = at_px.y() + table.height_px + kLine * (static_cast<double>(j % rows) + 1.0) - 5.0;
    const std::string css = AxisClass(scratch.axis_W[j]);
    table.svg += SvgText(x + kNumberWide - 8.0, y, css + " number-of-table", fmt::format("{}", j + 1));
    table.svg += SvgText(x + kNumberWide, y, "", Fitted(NameOfJoint(model, model.joints[j]), name_wide));
    table.svg += SvgText(x + kNumberWide + name_wide, y, css + " axis", AxisText(scratch.axis_W[j]));
  }
  table.height_px += kLine * static_cast<double>(rows);
}

}  // namespace

DrawnTable DrawnTables(const RobotModel& model, const DynamicsScratch& scratch, const Vector2& at_px, double width_px) {
  DrawnTable table;
  AddSigns(at_px, width_px, table);
  AddFeet(model, at_px, width_px, table);
  AddJoints(model, scratch, at_px, width_px, table);
  return table;
}

}  // namespace gaitwright
