// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 3: Englsberger, Ott and Albu-Schaeffer, T-RO 31(2), 2015.
//   dcm INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::kGravity;
using gaitwright::Vector2;
using gaitwright::Vector3;
using gaitwright::VectorX;
using Points = std::vector<Vector2>;

double OmegaOf(double com_height_m) { return std::sqrt(kGravity / com_height_m); }

/// xi = c + c' / omega.
Vector2 Dcm(const Vector3& com_m, const Vector3& velocity_m_s, double com_height_m) {
  return com_m.head<2>() + velocity_m_s.head<2>() / OmegaOf(com_height_m);
}

/// Backward recursion: each step ends where the next one starts, and the last step ends on its own ZMP.
Points DcmOfSteps(const Points& zmp_m, double step_s, double com_height_m) {
  const double shrink = std::exp(-OmegaOf(com_height_m) * step_s);
  Points starts_m(zmp_m.size());
  Vector2 end_m = zmp_m.back();
  for (std::size_t i = zmp_m.size(); i-- > 0;) {
    starts_m[i] = zmp_m[i] + shrink * (end_m - zmp_m[i]);
    end_m = starts_m[i];
  }
  return starts_m;
}

/// The DCM of the plan of DcmOfSteps at times since the start of the first step.
Points DcmAt(const Points& zmp_m, double step_s, double com_height_m, const VectorX& times_s) {
  const Points starts_m = DcmOfSteps(zmp_m, step_s, com_height_m);
  Points at_m;
  for (const double time_s : times_s) {
    const double last = static_cast<double>(zmp_m.size() - 1), number = std::floor(time_s / step_s);
    const auto step = static_cast<std::size_t>(std::clamp(number, 0.0, last));
    const double since_s = time_s - static_cast<double>(step) * step_s;
    at_m.push_back(zmp_m[step] + std::exp(OmegaOf(com_height_m) * since_s) * (starts_m[step] - zmp_m[step]));
  }
  return at_m;
}

/// Solution of c' = omega (xi - c) with xi = p + e^{omega t} (xi_0 - p).
Vector2 ComAlongDcm(const Vector2& com_m, const Vector2& dcm_m, const Vector2& zmp_m, double com_height_m,
                    double time_s) {
  const double away = std::exp(OmegaOf(com_height_m) * time_s);
  return zmp_m + 0.5 * away * (dcm_m - zmp_m) + 0.5 / away * (2.0 * com_m - dcm_m - zmp_m);
}

Points PointsOf(const AnswerCase& asked, const char* name) {
  const gaitwright::MatrixX matrix = asked.Matrix(name);
  Points points;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) points.emplace_back(matrix.row(i));
  return points;
}

std::vector<double> Numbers(const Points& points) {
  std::vector<double> numbers;
  for (const Vector2& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
  return numbers;
}

std::vector<double> AnswerDcm(const AnswerCase& asked) {
  return Numbers({Dcm(asked.Vector("com_m"), asked.Vector("velocity_m_s"), asked.Number("com_height_m"))});
}

std::vector<double> AnswerSteps(const AnswerCase& asked) {
  return Numbers(DcmOfSteps(PointsOf(asked, "zmp_m"), asked.Number("step_s"), asked.Number("com_height_m")));
}

std::vector<double> AnswerTimes(const AnswerCase& asked) {
  return Numbers(
      DcmAt(PointsOf(asked, "zmp_m"), asked.Number("step_s"), asked.Number("com_height_m"), asked.Vector("times_s")));
}

std::vector<double> AnswerCom(const AnswerCase& asked) {
  return Numbers({ComAlongDcm(asked.Vector("com_m"), asked.Vector("dcm_m"), asked.Vector("zmp_m"),
                              asked.Number("com_height_m"), asked.Number("time_s"))});
}

}  // namespace

int main(int argc, char** argv) {
  const auto written = gaitwright::WriteAnswers(
      argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : ".",
      {{"dcm", AnswerDcm}, {"dcm_of_steps", AnswerSteps}, {"dcm_at", AnswerTimes}, {"com_along_dcm", AnswerCom}});
  if (!written) fmt::print(stderr, "dcm: {}\n", written.failure().message);
  return written ? 0 : 1;
}
