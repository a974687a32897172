// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/turning_rate.h"

#include <ceres/jet.h>

#include <cmath>

namespace gaitwright {
namespace {

template <typename T>
Eigen::Matrix<T, 3, 1> RatesOf(const Matrix3& inverse_B, const Eigen::Matrix<T, 3, 1>& angles,
                               const Eigen::Matrix<T, 3, 1>& momentum) {
  using std::cos, std::sin;
  const T sr = sin(angles.x()), cr = cos(angles.x()), sp = sin(angles.y()), cp = cos(angles.y());
  const T sy = sin(angles.z()), cy = cos(angles.z());
  // R^T l, one rotation after the other.
  const T forward = cy * momentum.x() + sy * momentum.y(), left = cy * momentum.y() - sy * momentum.x();
  const T down = sp * forward + cp * momentum.z();
  const Eigen::Matrix<T, 3, 1> in_body(cp * forward - sp * momentum.z(), cr * left + sr * down, cr * down - sr * left);
  const Eigen::Matrix<T, 3, 1> w = inverse_B.cast<T>() * in_body;
  const T yaw_rate = (sr * w.y() + cr * w.z()) / cp;
  return {w.x() + sp * yaw_rate, cr * w.y() - sr * w.z(), yaw_rate};
}

}  // namespace

Vector3 AngleRates(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum) {
  return RatesOf<double>(inverse_B, angles_rad, momentum);
}

TurningRate TurningRateOf(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum) {
  using Jet = ceres::Jet<double, 6>;
  Eigen::Matrix<Jet, 3, 1> angles, l;
  for (int i = 0; i < 3; ++i) {
    angles[i] = Jet(angles_rad[i], i);
    l[i] = Jet(momentum[i], 3 + i);
  }
  const Eigen::Matrix<Jet, 3, 1> rates = RatesOf<Jet>(inverse_B, angles, l);
  TurningRate turning;
  for (int i = 0; i < 3; ++i) {
    turning.rate[i] = rates[i].a;
    turning.by_angles.row(i) = rates[i].v.head<3>();
    turning.by_momentum.row(i) = rates[i].v.tail<3>();
  }
  return turning;
}

AnglesBetween::AnglesBetween(const Matrix3& inverse_B, double h, double u, const TurningState& from,
                             const TurningState& to)
    : rate_from(TurningRateOf(inverse_B, from.angles_rad, from.momentum)),
      rate_to(TurningRateOf(inverse_B, to.angles_rad, to.momentum)) {
  const double v = 1.0 - u, of_from = v * v * (1.0 + 2.0 * u), of_to = u * u * (1.0 + 2.0 * v);
  const double of_rate_from = h * u * v * v, of_rate_to = -h * v * u * u;
  value = of_from * from.angles_rad + of_to * to.angles_rad + of_rate_from * rate_from.rate + of_rate_to * rate_to.rate;
  by_from = of_from * Matrix3::Identity() + of_rate_from * rate_from.by_angles;
  by_to = of_to * Matrix3::Identity() + of_rate_to * rate_to.by_angles;
  by_l_from = of_rate_from * rate_from.by_momentum;
  by_l_to = of_rate_to * rate_to.by_momentum;
}

}  // namespace gaitwright
