// SPDX-License-Identifier: BSD-3-Clause
// Assignment 2: preview control of the zero-moment point. See ../README.md. SI units.
//   preview INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::kGravity;
using gaitwright::Matrix3;
using gaitwright::Vector3;
using gaitwright::VectorX;

struct Setup {
  double com_height_m, step_s, preview_s;
  double error_weight;  // Q [1/m^2]
  double jerk_weight;   // R [s^6/m^2]
};

/// Cart-table model in discrete time: x' = A x + b jerk, zmp = c . x, with x = (position, rate, acceleration).
struct CartTable {
  Matrix3 A;
  Vector3 b, c;
};

[[maybe_unused]] CartTable MakeCartTable(const Setup& setup) {
  const double h = setup.step_s;
  CartTable cart;
  cart.A << 1.0, h, h * h / 2.0, 0.0, 1.0, h, 0.0, 0.0, 1.0;
  cart.b << h * h * h / 6.0, h * h / 2.0, h;
  cart.c << 1.0, 0.0, -setup.com_height_m / kGravity;
  return cart;
}

/// The gains of the preview controller: K_i, the three elements of K_x, then f_1 to f_N, N = preview / step.
std::vector<double> PreviewGains(const Setup& setup) {
  const auto count = static_cast<std::size_t>(std::lround(setup.preview_s / setup.step_s));
  return std::vector<double>(4 + count, 0.0);  // zero gains: the cart does not move
}

/// The centre of mass at each sample, for which the ZMP follows the reference (one value per step) [m]. It starts at
/// rest at `com_m`. Beyond the end of the reference, its last value holds.
std::vector<double> FollowZmp(const Setup& /*setup*/, const VectorX& reference_m, double com_m) {
  return std::vector<double>(static_cast<std::size_t>(reference_m.size()), com_m);  // the body does not move
}

// Do not change the code below: it reads the inputs and writes the answers.

Setup SetupOf(const AnswerCase& asked) {
  return {asked.Number("com_height_m"), asked.Number("step_s"), asked.Number("preview_s"), asked.Number("error_weight"),
          asked.Number("jerk_weight")};
}

std::vector<double> AnswerGains(const AnswerCase& asked) { return PreviewGains(SetupOf(asked)); }

std::vector<double> AnswerFollow(const AnswerCase& asked) {
  return FollowZmp(SetupOf(asked), asked.Vector("reference_m"), asked.Number("com_m"));
}

}  // namespace

int main(int argc, char** argv) {
  const auto written = gaitwright::WriteAnswers(argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : ".",
                                                {{"preview_gains", AnswerGains}, {"follow_zmp", AnswerFollow}});
  if (!written) fmt::print(stderr, "preview: {}\n", written.failure().message);
  return written ? 0 : 1;
}
