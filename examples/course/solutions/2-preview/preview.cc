// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 2: Kajita et al., ICRA 2003, with the summed error of Katayama et al., 1985.
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
using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

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

CartTable MakeCartTable(const Setup& setup) {
  const double h = setup.step_s;
  CartTable cart;
  cart.A << 1.0, h, h * h / 2.0, 0.0, 1.0, h, 0.0, 0.0, 1.0;
  cart.b << h * h * h / 6.0, h * h / 2.0, h;
  cart.c << 1.0, 0.0, -setup.com_height_m / kGravity;
  return cart;
}

/// P of the discrete algebraic Riccati equation, by backward iteration until P does not change.
Matrix4 Riccati(const Matrix4& A, const Vector4& b, const Matrix4& Q, double R) {
  Matrix4 P = Q;
  for (int i = 0; i < 100000; ++i) {
    const Vector4 Pb = P * b;
    const Matrix4 PA = P * A;
    const Matrix4 following = A.transpose() * PA - (A.transpose() * Pb) * (b.transpose() * PA) / (R + b.dot(Pb)) + Q;
    const double change = (following - P).cwiseAbs().maxCoeff();
    P = following;
    if (change <= 1e-13 * P.cwiseAbs().maxCoeff()) break;
  }
  return P;
}

/// The gains of the preview controller: K_i, the three elements of K_x, then f_1 to f_N, N = preview / step.
std::vector<double> PreviewGains(const Setup& setup) {
  const CartTable cart = MakeCartTable(setup);
  // The first state is the ZMP error; the others are the increments of x.
  Matrix4 A = Matrix4::Zero(), Q = Matrix4::Zero();
  A(0, 0) = 1.0;
  A.topRightCorner<1, 3>() = (cart.A.transpose() * cart.c).transpose();
  A.bottomRightCorner<3, 3>() = cart.A;
  Vector4 b;
  b << cart.c.dot(cart.b), cart.b;
  Q(0, 0) = setup.error_weight;
  const Matrix4 P = Riccati(A, b, Q, setup.jerk_weight);
  const double scale = 1.0 / (setup.jerk_weight + b.dot(P * b));
  const Vector4 K = scale * (A.transpose() * (P * b));
  const Matrix4 closed = A - b * K.transpose();
  std::vector<double> gains(K.begin(), K.end());
  Vector4 pulled = P.col(0);
  for (long j = std::lround(setup.preview_s / setup.step_s); j > 0; --j) {
    gains.push_back(scale * b.dot(pulled));
    pulled = (closed.transpose() * pulled).eval();
  }
  return gains;
}

/// The centre of mass at each sample, for which the ZMP follows the reference (one value per step) [m].
std::vector<double> FollowZmp(const Setup& setup, const VectorX& reference_m, double com_m) {
  const CartTable cart = MakeCartTable(setup);
  const std::vector<double> gains = PreviewGains(setup);
  const Vector3 K_x(gains[1], gains[2], gains[3]);
  const VectorX f = Eigen::Map<const VectorX>(gains.data() + 4, static_cast<Eigen::Index>(gains.size()) - 4);
  const double beyond = K_x[0] - f.sum();  // beyond the preview the reference is constant
  VectorX padded(reference_m.size() + f.size());
  padded << reference_m, VectorX::Constant(f.size(), reference_m[reference_m.size() - 1]);
  Vector3 x(com_m, 0.0, 0.0);
  double summed = 0.0;
  std::vector<double> path_m;
  for (Eigen::Index k = 0; k < reference_m.size(); ++k) {
    path_m.push_back(x[0]);
    summed += cart.c.dot(x) - reference_m[k];
    const auto future = padded.segment(k + 1, f.size());
    const double jerk = -gains[0] * summed - K_x.dot(x) + f.dot(future) + beyond * future[f.size() - 1];
    x = cart.A * x + cart.b * jerk;
  }
  return path_m;
}

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
