// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 1. SI units; z is up.
//   zmp INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::Vector2;
using gaitwright::Vector3;
using Points = std::vector<Vector2>;

/// c - (h / g) c'': Kajita et al., ICRA 2003.
Vector2 PendulumZmp(const Vector3& com_m, const Vector3& acceleration_m_s2, double com_height_m) {
  return com_m.head<2>() - com_height_m / gaitwright::kGravity * acceleration_m_s2.head<2>();
}

/// The point Z where the horizontal moment vanishes: M + (P - Z) x F = 0 in x and y.
Vector2 WrenchZmp(const Vector3& point_m, const Vector3& force_n, const Vector3& moment_n_m, double ground_height_m) {
  const double height_m = point_m.z() - ground_height_m;
  return {point_m.x() - (moment_n_m.y() + height_m * force_n.x()) / force_n.z(),
          point_m.y() + (moment_n_m.x() - height_m * force_n.y()) / force_n.z()};
}

/// All forces as one wrench about the origin.
Vector2 ContactsZmp(const std::vector<Vector3>& points_m, const std::vector<Vector3>& forces_n,
                    double ground_height_m) {
  Vector3 force_n = Vector3::Zero(), moment_n_m = Vector3::Zero();
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    force_n += forces_n[i];
    moment_n_m += points_m[i].cross(forces_n[i]);
  }
  return WrenchZmp(Vector3::Zero(), force_n, moment_n_m, ground_height_m);
}

/// Twice the signed area of a triangle: positive if a, b, c turn left.
double Turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// One chain of the convex hull without its last corner: the lower chain of points sorted by x, or the upper chain of
/// points in the reverse order (Andrew 1979).
template <class Iterator>
void AddSide(Iterator begin, Iterator end, Points& corners) {
  const std::size_t before = corners.size();
  for (Iterator p = begin; p != end; ++p) {
    while (corners.size() > before + 1 && Turn(corners[corners.size() - 2], corners.back(), *p) <= 1e-12)
      corners.pop_back();
    corners.push_back(*p);
  }
  corners.pop_back();
}

/// Corners of the convex hull, counter-clockwise, none of them on an edge.
Points SupportPolygon(Points points_m) {
  std::sort(points_m.begin(), points_m.end(),
            [](const Vector2& a, const Vector2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  Points corners_m;
  AddSide(points_m.begin(), points_m.end(), corners_m);
  AddSide(points_m.rbegin(), points_m.rend(), corners_m);
  return corners_m;
}

/// Distance to the nearest point of all edges. The point is inside if it is to the left of every edge.
double SupportMargin(const Points& corners_m, const Vector2& point_m) {
  bool inside = true;
  double nearest_m = HUGE_VAL;
  for (std::size_t i = 0; i < corners_m.size(); ++i) {
    const Vector2 &a = corners_m[i], &b = corners_m[(i + 1) % corners_m.size()];
    const Vector2 edge = b - a;
    const double share = std::clamp((point_m - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest_m = std::min(nearest_m, (a + share * edge - point_m).norm());
    inside = inside && Turn(a, b, point_m) >= 0.0;
  }
  return inside ? nearest_m : -nearest_m;
}

std::vector<double> Numbers(const Vector2& p) { return {p.x(), p.y()}; }

Points PointsOf(const AnswerCase& asked, const char* name) {
  const gaitwright::MatrixX matrix = asked.Matrix(name);
  Points points;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) points.emplace_back(matrix.row(i));
  return points;
}

std::vector<Vector3> RowsOf(const AnswerCase& asked, const char* name) {
  const gaitwright::MatrixX matrix = asked.Matrix(name);
  std::vector<Vector3> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.emplace_back(matrix.row(i));
  return rows;
}

std::vector<double> AnswerPendulum(const AnswerCase& asked) {
  return Numbers(PendulumZmp(asked.Vector("com_m"), asked.Vector("acceleration_m_s2"), asked.Number("com_height_m")));
}

std::vector<double> AnswerWrench(const AnswerCase& asked) {
  return Numbers(WrenchZmp(asked.Vector("point_m"), asked.Vector("force_n"), asked.Vector("moment_n_m"),
                           asked.Number("ground_height_m")));
}

std::vector<double> AnswerContacts(const AnswerCase& asked) {
  return Numbers(ContactsZmp(RowsOf(asked, "points_m"), RowsOf(asked, "forces_n"), asked.Number("ground_height_m")));
}

/// The corners, padded with copies of the last one to the number of points.
std::vector<double> AnswerPolygon(const AnswerCase& asked) {
  const Points points_m = PointsOf(asked, "points_m");
  Points corners_m = SupportPolygon(points_m);
  corners_m.resize(points_m.size(), corners_m.back());
  std::vector<double> numbers;
  for (const Vector2& corner_m : corners_m) numbers.insert(numbers.end(), {corner_m.x(), corner_m.y()});
  return numbers;
}

std::vector<double> AnswerMargin(const AnswerCase& asked) {
  return {SupportMargin(PointsOf(asked, "corners_m"), asked.Vector("point_m"))};
}

}  // namespace

int main(int argc, char** argv) {
  const auto written = gaitwright::WriteAnswers(argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : ".",
                                                {{"pendulum_zmp", AnswerPendulum},
                                                 {"wrench_zmp", AnswerWrench},
                                                 {"contacts_zmp", AnswerContacts},
                                                 {"support_polygon", AnswerPolygon},
                                                 {"support_margin", AnswerMargin}});
  if (!written) fmt::print(stderr, "zmp: {}\n", written.failure().message);
  return written ? 0 : 1;
}
