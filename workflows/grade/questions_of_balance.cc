// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

constexpr double kCornersApart = 1e-9;  // [m], nearer corners are equal

Polygon PointsOf(const QuestionValue& value) {
  Polygon points;
  for (int i = 0; i < value.shape.front(); ++i) points.push_back(value.Vec2(i));
  return points;
}

std::vector<double> Numbers(const Vector2& p) { return {p.x(), p.y()}; }

std::vector<double> PendulumAnswer(const QuestionContext&, const Values& in) {
  return Numbers(PendulumZmp(in[0].Vec3(), in[1].Vec3(), std::sqrt(kQuestionGravity / in[2].number())));
}

std::vector<double> WrenchAnswer(const QuestionContext&, const Values& in) {
  return Numbers(ZeroMomentPoint(in[0].Vec3(), in[1].Vec3(), in[2].Vec3(), in[3].number()));
}

std::vector<double> ContactsAnswer(const QuestionContext& context, const Values& in) {
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (int i = 0; i < context.size; ++i) {
    force += in[1].Vec3(i);
    moment += in[0].Vec3(i).cross(in[1].Vec3(i));
  }
  return Numbers(ZeroMomentPoint(Vector3::Zero(), force, moment, in[2].number()));
}

/// The corners of an answer, without repetitions of the previous corner.
Polygon CornersOf(const QuestionValue& answer) {
  if (answer.shape.size() != 2 || answer.shape[1] != 2)
    throw InvalidArgument("the answer is " + ShapeWords(answer.shape) + "; corners x 2 numbers are needed");
  Polygon corners;
  for (const Vector2& corner : PointsOf(answer)) {
    if (corners.empty() || (corner - corners.back()).norm() > kCornersApart) corners.push_back(corner);
  }
  while (corners.size() > 1 && (corners.front() - corners.back()).norm() <= kCornersApart) corners.pop_back();
  return corners;
}

/// Largest distance between corresponding corners, for the best choice of the first corner.
double CornersApart(const Polygon& right, const Polygon& given) {
  if (right.size() != given.size()) return std::numeric_limits<double>::infinity();
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < right.size(); ++first) {
    double largest = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i)
      largest = std::max(largest, (right[(first + i) % right.size()] - given[i]).norm());
    best = std::min(best, largest);
  }
  return best;
}

double PolygonError(const QuestionContext&, const Values& in, const QuestionValue& answer) {
  return CornersApart(ConvexHull(PointsOf(in[0])), CornersOf(answer));
}

/// Rounds points to a grid of 1/64 m, on which the arithmetic of a hull is exact, and puts the last point in the middle
/// of an edge of the others. This tests that a hull has no corner on an edge, and how points with equal x are sorted.
void PutOneOnAnEdge(const QuestionContext& context, SplitMix&, Values& in) {
  if (context.size < 4) return;
  for (double& number : in[0].numbers) number = std::round(32.0 * number) / 32.0;
  Polygon others = PointsOf(in[0]);
  others.pop_back();
  const Polygon hull = ConvexHull(others);
  if (hull.size() < 3) return;
  const Vector2 middle = 0.5 * (hull[0] + hull[1]);
  const std::size_t last = 2 * (static_cast<std::size_t>(context.size) - 1);
  in[0].numbers[last] = middle.x();
  in[0].numbers[last + 1] = middle.y();
}

/// Puts points on a circle, in order of angle: a convex polygon without corners on an edge.
void MakeConvex(const QuestionContext& context, SplitMix&, Values& in) {
  Polygon points = PointsOf(in[0]);
  const double radius = std::max(0.05, points.front().norm());
  std::vector<double> angles;
  for (const Vector2& p : points) angles.push_back(std::atan2(p.y(), p.x()));
  std::sort(angles.begin(), angles.end());
  for (int i = 0; i < context.size; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    // The mean of uniform and drawn angles, so that no two points are close.
    const double angle = 0.5 * angles[at] + 0.5 * 2.0 * M_PI * i / context.size;
    in[0].numbers[2 * at] = radius * std::cos(angle);
    in[0].numbers[2 * at + 1] = radius * std::sin(angle);
  }
}

double MarginOf(const Values& in) { return SignedDistance(ConvexHull(PointsOf(in[0])), in[1].Vec2()); }

}  // namespace

std::vector<Question> BalanceQuestions() {
  Question polygon{"support_polygon",
                   "the corners of the convex hull",
                   {{"points_m", {kSize, 2}, {-0.3, 0.3}}},
                   "corners x 2, counter-clockwise"};
  polygon.shape = [](const QuestionContext& context, const Values&) { return std::vector<int>{context.size, 2}; };
  polygon.settle = PutOneOnAnEdge;
  polygon.error = PolygonError;
  polygon.off_by = "largest distance of a corner; infinite for a wrong number of corners, or a corner on an edge";
  Question margin{"support_margin",
                  "the signed distance of a point to the edge",
                  {{"corners_m", {kSize, 2}, {-0.3, 0.3}}, {"point_m", {2}, {-0.3, 0.3}}},
                  "a number"};
  margin.settle = MakeConvex;
  return {Compared(
              {"pendulum_zmp",
               "the ZMP of the linear inverted pendulum",
               {{"com_m", {3}, {-0.5, 0.5}}, {"acceleration_m_s2", {3}, {-3.0, 3.0}}, {"com_height_m", {}, {0.2, 1.0}}},
               "2 numbers"},
              {2}, PendulumAnswer),
          Compared({"wrench_zmp",
                    "the ZMP of a wrench on level ground",
                    {{"point_m", {3}, {-0.5, 0.5}},
                     {"force_n", {3}, {50.0, 500.0}},
                     {"moment_n_m", {3}, {-40.0, 40.0}},
                     {"ground_height_m", {}, {-0.2, 0.2}}},
                    "2 numbers"},
                   {2}, WrenchAnswer),
          Compared({"contacts_zmp",
                    "the ZMP of forces at contacts",
                    {{"points_m", {kSize, 3}, {-0.3, 0.3}},
                     {"forces_n", {kSize, 3}, {1.0, 100.0}},
                     {"ground_height_m", {}, {-0.2, 0.2}}},
                    "2 numbers"},
                   {2}, ContactsAnswer),
          polygon, Compared(margin, {}, [](const QuestionContext&, const Values& in) {
            return std::vector<double>{MarginOf(in)};
          })};
}

}  // namespace gaitwright
