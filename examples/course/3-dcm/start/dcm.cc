// SPDX-License-Identifier: BSD-3-Clause
// Assignment 3: planning with the divergent component of motion. See ../README.md. SI units.
//   dcm INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::Vector2;
using gaitwright::Vector3;
using gaitwright::VectorX;
using Points = std::vector<Vector2>;

/// The divergent component of motion, from the centre of mass and its velocity. Gravity is gaitwright::kGravity
/// [m/s^2].
Vector2 Dcm(const Vector3& com_m, const Vector3& /*velocity_m_s*/, double /*com_height_m*/) {
  return com_m.head<2>();  // correct only for a body at rest
}

/// The DCM at the start of each step, for which the DCM is at rest on the last ZMP when the last step ends.
/// `zmp_m` has the ZMP of each step, which is constant for `step_s`.
Points DcmOfSteps(const Points& zmp_m, double /*step_s*/, double /*com_height_m*/) {
  return zmp_m;  // correct only for a body that stays over its foot
}

/// The DCM of the plan of DcmOfSteps at times since the start of the first step.
Points DcmAt(const Points& /*zmp_m*/, double /*step_s*/, double /*com_height_m*/, const VectorX& times_s) {
  return Points(static_cast<std::size_t>(times_s.size()), Vector2::Zero());
}

/// The centre of mass after a time with constant ZMP.
Vector2 ComAlongDcm(const Vector2& com_m, const Vector2& /*dcm_m*/, const Vector2& /*zmp_m*/, double /*com_height_m*/,
                    double /*time_s*/) {
  return com_m;
}

// Do not change the code below: it reads the inputs and writes the answers.

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
