// SPDX-License-Identifier: BSD-3-Clause
// Assignment 4: swing trajectories of a foot. See ../README.md. SI units; z is up.
//   swing INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

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
  return {u, 1.0, 0.0};  // constant speed: the foot is not at rest at lift-off and touch-down
}

struct Swing {
  Vector3 start_m, end_m;
  double lift_m, duration_s;
};

/// Position [m], velocity [m/s] and acceleration [m/s^2] at a time: minimum jerk from start to end, and a bump of
/// `lift_m` along z at half time.
Points SwingAt(const Swing& swing, double time_s) {
  const Vector3 displacement_m = swing.end_m - swing.start_m;
  return {swing.start_m + time_s / swing.duration_s * displacement_m, displacement_m / swing.duration_s,
          Vector3::Zero()};
}

struct Step {
  Vector3 start_m, end_m;
  double edge_x_m;  // the ground has the start's height before the edge, the end's height after it
  double clearance_m, duration_s;
};

/// Positions at `times_s` of a swing up or down a step.
Points SwingOverStep(const Step& step, const VectorX& times_s) {
  Points points;
  for (const double time_s : times_s)
    points.push_back(step.start_m + time_s / step.duration_s * (step.end_m - step.start_m));  // straight, hits the edge
  return points;
}

// Do not change the code below: it reads the inputs and writes the answers.

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
