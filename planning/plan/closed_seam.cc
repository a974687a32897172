// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/closed_seam_internal.h"

namespace gaitwright {
namespace {

/// Quintic from zero at rest to a value and rate with zero acceleration, over a given time.
class Quintic {
 public:
  Quintic(const VectorX& x, const VectorX& v, double time_s) {
    const double T = time_s;
    c3_ = (10.0 * x - 4.0 * T * v) / std::pow(T, 3);
    c4_ = (-15.0 * x + 7.0 * T * v) / std::pow(T, 4);
    c5_ = (6.0 * x - 3.0 * T * v) / std::pow(T, 5);
  }

  VectorX x(double t) const { return (c3_ + t * (c4_ + t * c5_)) * (t * t * t); }
  VectorX v(double t) const { return (3.0 * c3_ + t * (4.0 * c4_ + t * 5.0 * c5_)) * (t * t); }
  VectorX a(double t) const { return (6.0 * c3_ + t * (12.0 * c4_ + t * 20.0 * c5_)) * t; }

 private:
  VectorX c3_, c4_, c5_;
};

/// Difference of two configurations as a velocity vector: base position, rotation vector in W, joints.
VectorX Between(const VectorX& from, const VectorX& to) {
  VectorX difference(from.size() - 1);
  difference.head<3>() = to.head<3>() - from.head<3>();
  difference.segment<3>(3) = RotationLog(BaseRotation(to) * BaseRotation(from).transpose());
  difference.tail(from.size() - 7) = to.tail(from.size() - 7) - from.tail(from.size() - 7);
  return difference;
}

void Add(const VectorX& difference, VectorX& q) {
  const Matrix3 R_WB = RotationExp(difference.segment<3>(3)) * BaseRotation(q);
  q.head<3>() += difference.head<3>();
  q.segment<4>(3) = Quaternion(R_WB).normalized().coeffs();
  q.tail(q.size() - 7) += difference.tail(q.size() - 7);
}

}  // namespace

void CloseSeam(MotionPlan& plan, std::size_t row, const MotionPlan& then, std::size_t then_row) {
  WholeBodyTrajectory& w = plan.whole_body;
  const WholeBodyTrajectory& next = then.whole_body;
  const std::size_t rows = std::min(row, static_cast<std::size_t>(std::lround(kBend / w.step_s)));
  if (rows == 0) return;
  const double time_s = static_cast<double>(rows) * w.step_s;
  const Quintic bend(Between(w.q[row], next.q[then_row]), next.v[then_row] - w.v[row], time_s);
  CentroidalTrajectory& c = plan.centroidal;
  const bool centroidal = c.p_WC.size() > row && then.centroidal.p_WC.size() > then_row;
  const auto gap = [&](const std::vector<Vector3>& column, const std::vector<Vector3>& other) -> VectorX {
    return centroidal ? VectorX(other[then_row] - column[row]) : VectorX(VectorX::Zero(3));
  };
  const Quintic of_centre(gap(c.p_WC, then.centroidal.p_WC), gap(c.v_WC, then.centroidal.v_WC), time_s);
  const double omega2 = c.omega_rad_s * c.omega_rad_s;
  for (std::size_t k = row - rows + 1; k <= row; ++k) {
    const double t = static_cast<double>(k + rows - row) * w.step_s;
    Add(bend.x(t), w.q[k]);
    w.v[k] += bend.v(t);
    w.a[k] += bend.a(t);
    if (!centroidal) continue;
    c.p_WC[k] += of_centre.x(t);
    c.v_WC[k] += of_centre.v(t);
    c.a_WC[k] += of_centre.a(t);
    if (c.p_WZ.size() > k) c.p_WZ[k] += (of_centre.x(t) - of_centre.a(t) / omega2).head<2>();
  }
}

}  // namespace gaitwright
