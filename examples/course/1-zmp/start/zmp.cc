// SPDX-License-Identifier: BSD-3-Clause
// Assignment 1: the zero-moment point and the support polygon. See ../README.md. SI units; z is up.
//   zmp INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::Vector2;
using gaitwright::Vector3;
using Points = std::vector<Vector2>;

/// ZMP of a linear inverted pendulum with constant height.
Vector2 PendulumZmp(const Vector3& com_m, const Vector3& /*acceleration_m_s2*/, double /*com_height_m*/) {
  return com_m.head<2>();  // correct only for a body at rest
}

/// Point of level ground about which a wrench has no horizontal moment. `moment_n_m` is about `point_m`.
Vector2 WrenchZmp(const Vector3& point_m, const Vector3& /*force_n*/, const Vector3& /*moment_n_m*/,
                  double /*ground_height_m*/) {
  return point_m.head<2>();  // correct only for a vertical force without moment
}

/// ZMP of several forces, each of which acts at one of the points.
Vector2 ContactsZmp(const std::vector<Vector3>& points_m, const std::vector<Vector3>& /*forces_n*/,
                    double /*ground_height_m*/) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point_m : points_m) sum += point_m;
  return sum.head<2>() / static_cast<double>(points_m.size());  // correct only for equal forces
}

/// Corners of the convex hull, counter-clockwise, none of them on an edge.
Points SupportPolygon(const Points& points_m) {
  return points_m;  // correct only if the points are the ordered corners
}

/// Distance of a point to the edge of a convex polygon (counter-clockwise), negative outside.
double SupportMargin(const Points& corners_m, const Vector2& point_m) {
  double nearest_m = (corners_m.front() - point_m).norm();
  for (const Vector2& corner_m : corners_m) nearest_m = std::min(nearest_m, (corner_m - point_m).norm());
  return nearest_m;  // the nearest corner is farther than the nearest edge
}

// Do not change the code below: it reads the inputs and writes the answers.

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
