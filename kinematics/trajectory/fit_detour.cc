// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/fit_detour.h"

#include "kinematics/base/result.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/trajectory/bspline.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {

std::vector<Vector3> FitDetour(const std::vector<double>& shares, const std::vector<Vector3>& off_W, int points) {
  if (shares.size() != off_W.size() || points < 1 || static_cast<std::size_t>(points) > shares.size())
    throw InvalidArgument(
        "FitDetour: the number of offsets must equal the number of fractions and be at least the number of control "
        "points");
  const auto samples = static_cast<Eigen::Index>(shares.size());
  MatrixX basis = MatrixX::Zero(samples, points), off(samples, 3);
  for (Eigen::Index k = 0; k < samples; ++k) {
    const auto sample = static_cast<std::size_t>(k);
    const QuinticBasis at = EvaluateQuinticBasis(points + 2 * kFixedSwingPoints, shares[sample]);
    for (int i = 0; i < 6; ++i) {
      const int point = at.first + i - kFixedSwingPoints;
      if (point >= 0 && point < points) basis(k, point) = at.value[static_cast<std::size_t>(i)];
    }
    off.row(k) = off_W[sample];
  }
  const MatrixX found = SolveLeastNorm(basis, off);
  std::vector<Vector3> detour_W;
  for (int i = 0; i < points; ++i) detour_W.emplace_back(found.row(i));
  return detour_W;
}

}  // namespace gaitwright
