// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 4: the minimum-jerk curve of Flash and Hogan, J. Neuroscience 5(7), 1985, and a bump.
//   swing INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::Vector3;
using gaitwright::VectorX;
using Points = std::vector<Vector3>;

/// Value, first and second derivative with respect to u, at u in [0, 1], of the minimum-jerk curve from 0 to 1 that is
/// at rest at both ends.
Vector3 MinimumJerk(double u) {
  const double u2 = u * u, u3 = u2 * u;
  return {10.0 * u3 - 15.0 * u3 * u + 6.0 * u3 * u2, 30.0 * u2 - 60.0 * u3 + 30.0 * u3 * u,
          60.0 * u - 180.0 * u2 + 120.0 * u3};
}

/// 64 u^3 (1 - u)^3 and its derivatives with respect to u: rises to 1 at u = 1/2 and returns to 0, at rest at both
/// ends.
Vector3 Bump(double u) {
  const double w = u * (1.0 - u), slope = 1.0 - 2.0 * u;
  return {64.0 * w * w * w, 192.0 * w * w * slope, 384.0 * w * slope * slope - 384.0 * w * w};
}

struct Swing {
  Vector3 start_m, end_m;
  double lift_m, duration_s;
};

/// By the chain rule, a derivative with respect to time is the derivative with respect to u divided by the duration.
Points SwingAt(const Swing& swing, double time_s) {
  const double u = time_s / swing.duration_s;
  const Vector3 along = MinimumJerk(u), up = Bump(u), displacement_m = swing.end_m - swing.start_m;
  Points rows;
  double by = 1.0;
  for (int i = 0; i < 3; ++i) {
    rows.emplace_back((along[i] * displacement_m + up[i] * swing.lift_m * Vector3::UnitZ()) / by);
    by *= swing.duration_s;
  }
  rows[0] += swing.start_m;
  return rows;
}

struct Step {
  Vector3 start_m, end_m;
  double edge_x_m;  // the ground has the start's height before the edge, the end's height after it
  double clearance_m, duration_s;
};

/// Minimum-jerk curve from 0 at u = `first` to 1 at u = `last`.
double Between(double u, double first, double last) {
  return MinimumJerk(std::clamp((u - first) / (last - first), 0.0, 1.0)).x();
}

/// The foot moves up first, forward in the middle and down at the end: three minimum-jerk curves that overlap in time.
Points SwingOverStep(const Step& step, const VectorX& times_s) {
  const double top_m = std::max(step.start_m.z(), step.end_m.z()) + step.clearance_m + 0.05;
  Points points;
  for (const double time_s : times_s) {
    const double u = time_s / step.duration_s;
    Vector3 place_m = step.start_m + Between(u, 0.15, 0.85) * (step.end_m - step.start_m);
    place_m.z() = step.start_m.z() + (top_m - step.start_m.z()) * Between(u, 0.0, 0.4) +
                  (step.end_m.z() - top_m) * Between(u, 0.6, 1.0);
    points.push_back(place_m);
  }
  return points;
}

std::vector<double> Numbers(const Points& points) {
  std::vector<double> numbers;
  for (const Vector3& p : points) numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  return numbers;
}

std::vector<double> AnswerJerk(const AnswerCase& asked) { return Numbers({MinimumJerk(asked.Number("u"))}); }

std::vector<double> AnswerSwing(const AnswerCase& asked) {
  return Numbers(
      SwingAt({asked.Vector("start_m"), asked.Vector("end_m"), asked.Number("lift_m"), asked.Number("duration_s")},
              asked.Number("time_s")));
}

std::vector<double> AnswerStep(const AnswerCase& asked) {
  return Numbers(SwingOverStep({asked.Vector("start_m"), asked.Vector("end_m"), asked.Number("edge_x_m"),
                                asked.Number("clearance_m"), asked.Number("duration_s")},
                               asked.Vector("times_s")));
}

}  // namespace

int main(int argc, char** argv) {
  const auto written =
      gaitwright::WriteAnswers(argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : ".",
                               {{"minimum_jerk", AnswerJerk}, {"swing", AnswerSwing}, {"swing_over_step", AnswerStep}});
  if (!written) fmt::print(stderr, "swing: {}\n", written.failure().message);
  return written ? 0 : 1;
}
