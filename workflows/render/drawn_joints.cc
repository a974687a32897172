// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/report/svg_tools.h"
#include "workflows/render/drawn_view_internal.h"

namespace gaitwright {
namespace {

constexpr double kArrow = 30.0;       // length of an axis that lies in the plane [px]
constexpr double kShortest = 9.0;     // a shorter arrow is drawn as one that points at the reader or away [px]
constexpr double kNumberHigh = 12.0;  // height of a number with its margin [px]

/// A joint in a view.
struct DrawnJoint {
  std::size_t index;  // into the model's joints
  Vector2 at_px, tip_px;
  double depth;  // toward the reader [m]
};

/// Places numbers beside the tips of their arrows, without overlap with other numbers and joints.
class NumberPlacer {
 public:
  explicit NumberPlacer(const Eigen::AlignedBox2d& frame_px) : frame_px_(frame_px) {}

  void Block(const Vector2& at_px, double half_px) {
    taken_.emplace_back(at_px - Vector2::Constant(half_px), at_px + Vector2::Constant(half_px));
  }

  /// Centre of the number's place. @param preferred unit vector: direction that is tried first.
  Vector2 Place(const Vector2& tip_px, const Vector2& preferred, double width_px) {
    constexpr int kTurns = 16;
    const Vector2 half(0.5 * width_px, 0.5 * kNumberHigh);
    for (double away = 9.0; away < 90.0; away += 6.0) {
      for (int i = 0; i < kTurns; ++i) {
        // 0, +1, -1, +2, -2, ...: directions near `preferred` first
        const int turns = (i % 2 == 0 ? -1 : 1) * ((i + 1) / 2);
        const double turn = turns * 2.0 * std::numbers::pi / kTurns;
        Vector2 middle = tip_px + away * (Eigen::Rotation2Dd(turn) * preferred);
        if (Take({middle - half, middle + half})) return middle;
      }
    }
    return tip_px + 9.0 * preferred;
  }

 private:
  bool Take(const Eigen::AlignedBox2d& box) {
    if (!frame_px_.contains(box)) return false;
    if (std::any_of(taken_.begin(), taken_.end(), [&](const auto& other) { return other.intersects(box); }))
      return false;
    taken_.push_back(box);
    return true;
  }

  Eigen::AlignedBox2d frame_px_;
  std::vector<Eigen::AlignedBox2d> taken_;
};

/// Joints of a view, those in front first, without joints behind a parallel one.
std::vector<DrawnJoint> JointsInView(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch) {
  constexpr double kSamePlace = 16.0;  // [px]
  constexpr double kBehind = 0.01;     // [m]
  constexpr double kParallel = 0.95;
  std::vector<DrawnJoint> all;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Vector3 p_W = scratch.p_WB[j + 1];
    const Vector2 at = view.ToPx(p_W), along = view.InPlane(scratch.axis_W[j]);
    all.push_back({j, at, at + kArrow * Vector2(along.x(), -along.y()), view.toward_W.dot(p_W)});
  }
  std::stable_sort(all.begin(), all.end(), [](const DrawnJoint& a, const DrawnJoint& b) { return a.depth > b.depth; });
  std::vector<DrawnJoint> seen;
  for (const DrawnJoint& joint : all) {
    const bool hidden = std::any_of(seen.begin(), seen.end(), [&](const DrawnJoint& other) {
      return (other.at_px - joint.at_px).norm() < kSamePlace && other.depth > joint.depth + kBehind &&
             std::abs(scratch.axis_W[other.index].dot(scratch.axis_W[joint.index])) > kParallel;
    });
    if (!hidden) seen.push_back(joint);
  }
  return seen;
}

/// A ring with a dot (the axis points at the reader) or a cross (away).
std::string EndOnAxis(const Vector2& at, bool toward, const char* css) {
  std::string svg = fmt::format("<circle class=\"{} ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/>", css, at.x(), at.y());
  if (toward)
    return svg + fmt::format("<circle class=\"{} full\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>", css, at.x(), at.y());
  const std::string line = std::string(css) + " line";
  svg += SvgSegment(at + Vector2(-4.0, -4.0), at + Vector2(4.0, 4.0), line);
  return svg + SvgSegment(at + Vector2(-4.0, 4.0), at + Vector2(4.0, -4.0), line);
}

std::string ArrowOf(const DrawnJoint& drawn, const Joint& joint, const char* css) {
  const Vector2 along = (drawn.tip_px - drawn.at_px).normalized(), across(-along.y(), along.x());
  const Vector2 neck = drawn.tip_px - 8.0 * along;
  std::string svg = SvgSegment(drawn.at_px - 0.35 * (drawn.tip_px - drawn.at_px), neck,
                               fmt::format("{} line{}", css, joint.is_mimic ? " dash" : ""));
  const Vector2 a = neck + 4.0 * across, b = neck - 4.0 * across;
  svg += fmt::format("<polygon class=\"{} full\" points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\"/>", css,
                     drawn.tip_px.x(), drawn.tip_px.y(), a.x(), a.y(), b.x(), b.y());
  const char* origin = joint.is_prismatic()
                           ? "<rect class=\"{0} full\" x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"7\" height=\"7\"/>"
                           : "<circle class=\"{0} full\" cx=\"{3:.1f}\" cy=\"{4:.1f}\" r=\"3\"/>";
  return svg + fmt::format(fmt::runtime(origin), css, drawn.at_px.x() - 3.5, drawn.at_px.y() - 3.5, drawn.at_px.x(),
                           drawn.at_px.y());
}

}  // namespace

const char* AxisClass(const Vector3& axis_W) {
  constexpr double kAlong = 0.94;  // within 20 degrees
  constexpr const char* kClasses[] = {"jx", "jy", "jz"};
  for (int i = 0; i < 3; ++i) {
    if (std::abs(axis_W[i]) > kAlong) return kClasses[i];
  }
  return "jo";
}

std::string AxisText(const Vector3& axis_W) {
  constexpr double kExactly = 0.9999;
  constexpr char kNames[] = "xyz";
  for (int i = 0; i < 3; ++i) {
    if (std::abs(axis_W[i]) > kExactly) return fmt::format("{}{}", axis_W[i] > 0.0 ? '+' : '-', kNames[i]);
  }
  const auto part = [&](int i) { return std::round(100.0 * axis_W[i]) / 100.0 + 0.0; };
  return fmt::format("({:.2g}, {:.2g}, {:.2g})", part(0), part(1), part(2));
}

std::string DrawnJoints(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch) {
  const std::vector<DrawnJoint> joints = JointsInView(view, model, scratch);
  NumberPlacer placer(view.frame_px);
  placer.Block(view.ToPx(CentreOfMass(model, scratch)), 9.0);
  for (const DrawnJoint& drawn : joints) {
    placer.Block(drawn.at_px, 4.0);
    placer.Block(drawn.tip_px, 3.0);
  }
  std::string arrows, numbers;
  for (std::size_t i = joints.size(); i-- > 0;) {  // the nearest is drawn last
    const DrawnJoint& drawn = joints[i];
    const Joint& joint = model.joints[drawn.index];
    const Vector3& axis_W = scratch.axis_W[drawn.index];
    const char* css = AxisClass(axis_W);
    const Vector2 along = drawn.tip_px - drawn.at_px;
    const bool end_on = along.norm() < kShortest;
    arrows +=
        fmt::format("<g data-joint=\"{}\">{}</g>", EscapedXml(joint.name),
                    end_on ? EndOnAxis(drawn.at_px, axis_W.dot(view.toward_W) > 0.0, css) : ArrowOf(drawn, joint, css));
    const std::string number = fmt::format("{}", drawn.index + 1);
    const Vector2 from = end_on ? drawn.at_px : drawn.tip_px;
    const Vector2 preferred = end_on ? Vector2(Vector2(1.0, -1.0).normalized()) : Vector2(along.normalized());
    const Vector2 at = placer.Place(from, preferred, 4.0 + 7.0 * static_cast<double>(number.size()));
    if ((at - from).norm() > 14.0) arrows += SvgSegment(from, at, std::string(css) + " lead");
    numbers += SvgText(at.x(), at.y() + 4.0, std::string(css) + " number", number);
  }
  return arrows + numbers;
}

}  // namespace gaitwright
