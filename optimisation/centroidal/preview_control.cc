// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/preview_control.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

constexpr int kMostPreviews = 10000;  // steps; the gains for a robot's height are negligible long before

/// The cart-table in discrete time: x' = A x + b u, p = c x.
struct CartTable {
  Matrix3 A;
  Vector3 b;
  Vector3 c;

  explicit CartTable(const PreviewSetup& setup) {
    const double h = setup.step_s;
    A << 1.0, h, 0.5 * h * h, 0.0, 1.0, h, 0.0, 0.0, 1.0;
    b << h * h * h / 6.0, 0.5 * h * h, h;
    c << 1.0, 0.0, -setup.com_height_m / kGravity;
  }
};

/// P = A' P A - A' P b (R + b' P b)^-1 b' P A + Q, by doubling: each iteration squares the number of steps covered.
Matrix4 SolveRiccati(const Matrix4& A, const Vector4& b, const Matrix4& Q, double R) {
  Matrix4 A_k = A, G = b * b.transpose() / R, P = Q;
  for (int turn = 0; turn < 60; ++turn) {
    const Matrix4 W = (Matrix4::Identity() + G * P).inverse();
    const Matrix4 next = P + A_k.transpose() * P * W * A_k;
    G += (A_k * W * G * A_k.transpose()).eval();
    A_k = (A_k * W * A_k).eval();
    const double change = (next - P).norm();
    P = next;
    if (change <= 1e-15 * P.norm()) break;
  }
  return P;
}

void Check(const PreviewSetup& setup) {
  const std::pair<const char*, double> positive[] = {{"com_height_m", setup.com_height_m},
                                                     {"step_s", setup.step_s},
                                                     {"preview_s", setup.preview_s},
                                                     {"error_weight", setup.error_weight},
                                                     {"jerk_weight", setup.jerk_weight}};
  for (const auto& [name, value] : positive) {
    if (!std::isfinite(value) || value <= 0.0)
      throw InvalidArgument(fmt::format("preview control: {} is {}; it must be positive and finite", name, value));
  }
  const double most_s = kMostPreviews * setup.step_s;
  if (setup.preview_s > most_s) {
    throw InvalidArgument(fmt::format("preview control: a preview of {} s is {:.6g} steps of {} s; at most {} ({} s)",
                                      setup.preview_s, setup.preview_s / setup.step_s, setup.step_s, kMostPreviews,
                                      most_s));
  }
}

}  // namespace

PreviewGains ComputePreviewGains(const PreviewSetup& setup) {
  Check(setup);
  const CartTable model(setup);
  // State: the error of the ZMP, then the increment of x; input: the increment of the jerk.
  Matrix4 A = Matrix4::Zero();
  A(0, 0) = 1.0;
  A.topRightCorner<1, 3>() = (model.A.transpose() * model.c).transpose();
  A.bottomRightCorner<3, 3>() = model.A;
  Vector4 b;
  b << model.c.dot(model.b), model.b;
  Matrix4 Q = Matrix4::Zero();
  Q(0, 0) = setup.error_weight;
  const Matrix4 P = SolveRiccati(A, b, Q, setup.jerk_weight);
  const double scale = 1.0 / (setup.jerk_weight + b.dot(P * b));
  const Eigen::RowVector4d K = scale * b.transpose() * P * A;
  PreviewGains gains;
  gains.integral = K[0];
  gains.state = K.tail<3>().transpose();
  // f_j = (R + b' P b)^-1 b' (A_c')^(j-1) P e_0 with the closed loop A_c.
  const Matrix4 closed = A - b * K;
  Vector4 pulled = P.col(0);
  const int count = static_cast<int>(std::lround(setup.preview_s / setup.step_s));
  for (int j = 0; j < count; ++j) {
    gains.preview.push_back(scale * b.dot(pulled));
    pulled = (closed.transpose() * pulled).eval();
  }
  return gains;
}

PreviewMotion FollowZmp(const PreviewSetup& setup, const std::vector<double>& reference_m, double com_m) {
  const PreviewGains gains = ComputePreviewGains(setup);
  const CartTable model(setup);
  if (reference_m.empty()) throw InvalidArgument("preview control: the ZMP reference is empty");
  const auto reference = [&](std::size_t k) { return reference_m[std::min(k, reference_m.size() - 1)]; };
  // Beyond the preview the reference is taken as constant, so that a constant reference is followed exactly.
  const double beyond = gains.state[0] - std::accumulate(gains.preview.begin(), gains.preview.end(), 0.0);
  PreviewMotion motion;
  Vector3 x(com_m, 0.0, 0.0);
  double summed = 0.0;
  for (std::size_t k = 0; k < reference_m.size(); ++k) {
    const double zmp = model.c.dot(x);
    motion.com_m.push_back(x[0]);
    motion.com_rate_m_s.push_back(x[1]);
    motion.com_acceleration_m_s2.push_back(x[2]);
    motion.zmp_m.push_back(zmp);
    summed += zmp - reference(k);
    double jerk = -gains.integral * summed - gains.state.dot(x) + beyond * reference(k + gains.preview.size());
    for (std::size_t j = 0; j < gains.preview.size(); ++j) jerk += gains.preview[j] * reference(k + j + 1);
    x = model.A * x + model.b * jerk;
  }
  return motion;
}

}  // namespace gaitwright
