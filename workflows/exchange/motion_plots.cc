// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/model/dof_units.h"
#include "kinematics/spatial/rotation.h"
#include "playback/report/plot_grid.h"
#include "playback/report/svg_plot.h"

namespace gaitwright {
namespace {

constexpr int kColumns = 3;
constexpr double kMoves = 1e-3;  // a joint that moves less than this in all motions is left out [rad] or [m]

int IndexOf(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// A value of each row of a motion.
using PlottedValue = double (*)(const MotionRows& rows, std::size_t row, int index);

double Position(const MotionRows& rows, std::size_t k, int dof) { return rows.q[k][7 + dof]; }
double Speed(const MotionRows& rows, std::size_t k, int dof) { return rows.v[k][6 + dof]; }
double Torque(const MotionRows& rows, std::size_t k, int dof) {
  return rows.tau.empty() ? std::nan("") : rows.tau[k][dof];
}
double BasePosition(const MotionRows& rows, std::size_t k, int axis) { return rows.q[k][axis]; }

/// Roll, pitch and yaw of the base [rad].
double BaseAngle(const MotionRows& rows, std::size_t k, int axis) {
  const Matrix3 R = BaseRotation(rows.q[k]);
  if (axis == 0) return std::atan2(R(2, 1), R(2, 2));
  if (axis == 1) return -std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  return YawOf(R);
}

/// Parts that all plots of one set of motions share.
class Drawing {
 public:
  Drawing(const std::vector<DrawnMotion>& motions, std::optional<double> mark_s, std::string words)
      : motions_(motions), mark_s_(mark_s), words_(std::move(words)) {
    for (const DrawnMotion& motion : motions) {
      start_s_ = std::min(start_s_, motion.rows->time_s.front() - motion.offset_s);
      end_s_ = std::max(end_s_, motion.rows->time_s.back() - motion.offset_s);
    }
  }

  SvgPlot::Options Options(const std::string& title, const std::string& y_label) const {
    SvgPlot::Options options;
    options.title = title;
    options.y_label = y_label;
    options.x_lowest = start_s_;
    options.x_highest = end_s_;
    return options;
  }

  Stroke StrokeOf(std::size_t motion) const {
    return motions_.size() > 1 && motion == 0 ? Stroke::kPlanned : Stroke::kMeasured;
  }

  /// Draws a value of every motion over time; `index(motion)` is -1 if a motion does not have it.
  template <class Index>
  void Lines(SvgPlot& plot, Ink ink, PlottedValue figure, Index index) const {
    for (std::size_t m = 0; m < motions_.size(); ++m) {
      const int i = index(motions_[m]);
      if (i < 0) continue;
      const MotionRows& rows = *motions_[m].rows;
      std::vector<Vector2> points;
      for (std::size_t k = 0; k < rows.time_s.size(); ++k)
        points.emplace_back(rows.time_s[k] - motions_[m].offset_s, figure(rows, k, i));
      plot.Line(points, ink, StrokeOf(m), motions_[m].name);
    }
    Mark(plot, false);
  }

  void Mark(SvgPlot& plot, bool in_words) const {
    if (mark_s_) plot.AcrossY(*mark_s_, Ink::kBad, in_words ? words_ : "");
  }

  const std::vector<DrawnMotion>& motions() const { return motions_; }
  const RobotModel& model() const { return *motions_.front().model; }

 private:
  const std::vector<DrawnMotion>& motions_;
  std::optional<double> mark_s_;
  std::string words_;
  double start_s_ = INFINITY, end_s_ = -INFINITY;
};

Plot TopViewOf(const Drawing& drawing) {
  SvgPlot plot(SvgPlot::ToScale("Path of the base from above", "x [m]", "y [m]"));
  for (std::size_t m = 0; m < drawing.motions().size(); ++m) {
    std::vector<Vector2> points;
    for (const VectorX& q : drawing.motions()[m].rows->q) points.emplace_back(q[0], q[1]);
    plot.Line(points, Ink::kCom, drawing.StrokeOf(m), drawing.motions()[m].name);
    if (points.back().allFinite()) plot.Dot(points.back(), Ink::kCom, 3.0);
  }
  return {"top_view", "Path of the base's origin in plan view; the dot is its end.", plot.Svg()};
}

/// Three small plots of the base over time.
Plot BasePlot(const Drawing& drawing, const std::string& title, const char* const (&names)[3], const char* unit,
              PlottedValue figure) {
  std::vector<SvgPlot> plots;
  for (int axis = 0; axis < 3; ++axis) {
    SvgPlot::Options options = drawing.Options(names[axis], unit);
    options.width_px = 320.0;
    options.height_px = 190.0;
    options.x_label = "time [s]";
    options.y_least_span = 0.01;
    options.legend = false;
    SvgPlot plot(options);
    drawing.Lines(plot, Ink::kCom, figure, [axis](const DrawnMotion&) { return axis; });
    plots.push_back(std::move(plot));
  }
  return {"", "", GridOfPlots(plots, kColumns, title)};
}

Plot ContactsOf(const Drawing& drawing) {
  SvgPlot::Options options = drawing.Options("Contact of the feet", "");
  options.x_label = "time [s]";
  for (const Foot& foot : drawing.model().feet) options.rows.push_back(foot.name);
  options.height_px = 76.0 + 30.0 * static_cast<double>(options.rows.size());
  SvgPlot plot(options);
  for (std::size_t m = 0; m < drawing.motions().size(); ++m) {
    const DrawnMotion& motion = drawing.motions()[m];
    const MotionRows& rows = *motion.rows;
    for (std::size_t f = 0; f < motion.model->feet.size(); ++f) {
      const int row = IndexOf(options.rows, motion.model->feet[f].name);
      for (std::size_t k = 0; row >= 0 && k < rows.contact.size();) {
        std::size_t end = k;
        while (end < rows.contact.size() && Contains(rows.contact[end], static_cast<int>(f))) ++end;
        if (end > k) {
          const double until = rows.time_s[std::min(end, rows.time_s.size() - 1)];
          plot.Bar(row, rows.time_s[k] - motion.offset_s, until - motion.offset_s, Ink::kFoot, drawing.StrokeOf(m),
                   motion.name);
        }
        k = std::max(end, k + 1);
      }
    }
  }
  drawing.Mark(plot, true);
  return {"contacts", "When each foot stands on the ground.", plot.Svg()};
}

/// The joints of the first motion that move in any motion.
std::vector<int> MovingDofs(const Drawing& drawing) {
  std::vector<int> moving;
  for (int dof = 0; dof < drawing.model().num_dofs(); ++dof) {
    bool moves = false;
    for (const DrawnMotion& motion : drawing.motions()) {
      const int own = IndexOf(motion.model->dof_names, drawing.model().dof_names[static_cast<std::size_t>(dof)]);
      double least = INFINITY, most = -INFINITY;
      for (std::size_t k = 0; own >= 0 && k < motion.rows->q.size(); ++k) {
        least = std::min(least, Position(*motion.rows, k, own));
        most = std::max(most, Position(*motion.rows, k, own));
      }
      moves = moves || most - least > kMoves;
    }
    if (moves) moving.push_back(dof);
  }
  return moving;
}

/// Names and labels of a plot of joint values.
struct JointFigure {
  const char *name, *title, *turning, *sliding, *caption;
  Ink ink;
  PlottedValue figure;
};

constexpr JointFigure kJointFigures[] = {
    {"joint_positions", "Positions of the joints", "angle [rad]", "position [m]", "Position of each joint that moves.",
     Ink::kDcm, Position},
    {"joint_speeds", "Speeds of the joints", "speed [rad/s]", "speed [m/s]", "Speed of each joint that moves.",
     Ink::kZmp, Speed},
    {"joint_torques", "Torques of the joints", "torque [N m]", "force [N]",
     "Torque of each joint that moves: feed-forward for a plan; for a log, mean over the log's interval.", Ink::kJoint,
     Torque}};

Plot JointPlot(const Drawing& drawing, const std::vector<int>& dofs, const JointFigure& what) {
  std::vector<SvgPlot> plots;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const std::string& joint = drawing.model().dof_names[static_cast<std::size_t>(dofs[i])];
    SvgPlot::Options options = drawing.Options(joint, Slides(drawing.model(), dofs[i]) ? what.sliding : what.turning);
    options.width_px = 320.0;
    options.height_px = 155.0;
    options.x_label_room = true;
    options.x_label = i + kColumns >= dofs.size() ? "time [s]" : "";
    options.y_least_span = 0.02;
    options.most_points = 300;
    options.legend = false;
    SvgPlot plot(options);
    drawing.Lines(plot, what.ink, what.figure,
                  [&](const DrawnMotion& motion) { return IndexOf(motion.model->dof_names, joint); });
    plots.push_back(std::move(plot));
  }
  return {what.name, what.caption, GridOfPlots(plots, kColumns, what.title)};
}

}  // namespace

std::vector<Plot> MotionPlots(const std::vector<DrawnMotion>& motions, const std::optional<double>& mark_s,
                              const std::string& mark_words) {
  if (motions.empty() || motions.size() > 2) {
    throw InvalidArgument(fmt::format("MotionPlots: {} motions; one or two can be drawn", motions.size()));
  }
  for (const DrawnMotion& motion : motions) {
    if (motion.rows->time_s.empty()) throw InvalidArgument("MotionPlots: motion '" + motion.name + "' has no rows");
  }
  const Drawing drawing(motions, mark_s, mark_words);
  const auto any = [&](const auto& has) { return std::any_of(motions.begin(), motions.end(), has); };
  std::vector<Plot> plots;
  if (any([](const DrawnMotion& m) { return m.rows->q.front().head<3>().allFinite(); })) {
    plots.push_back(TopViewOf(drawing));
    plots.push_back(BasePlot(drawing, "Position of the base", {"x", "y", "z"}, "position [m]", BasePosition));
    plots.back().name = "base_position";
    plots.back().caption = "Origin of the base over time.";
    plots.push_back(BasePlot(drawing, "Attitude of the base", {"roll", "pitch", "yaw"}, "angle [rad]", BaseAngle));
    plots.back().name = "base_attitude";
    plots.back().caption = "Roll, pitch and yaw of the base over time.";
  }
  if (any([](const DrawnMotion& m) { return !m.rows->contact.empty(); })) plots.push_back(ContactsOf(drawing));
  const std::vector<int> dofs = MovingDofs(drawing);
  if (dofs.empty()) return plots;
  for (const JointFigure& what : kJointFigures) {
    if (what.figure == Torque && !any([](const DrawnMotion& m) { return !m.rows->tau.empty(); })) continue;
    plots.push_back(JointPlot(drawing, dofs, what));
  }
  return plots;
}

}  // namespace gaitwright
