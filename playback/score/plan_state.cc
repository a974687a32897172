// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/plan_state.h"

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

VectorX Blend(const std::vector<VectorX>& rows, std::size_t k, double s) {
  if (rows.size() <= k + 1) return rows.empty() ? VectorX() : rows.back();
  return (1.0 - s) * rows[k] + s * rows[k + 1];
}

double Hermite(double p0, double m0, double p1, double m1, double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * p0 + (s3 - 2.0 * s2 + s) * m0 + (3.0 * s2 - 2.0 * s3) * p1 + (s3 - s2) * m1;
}

VectorX Position(const WholeBodyTrajectory& motion, std::size_t k, double s) {
  if (motion.q.size() <= k + 1) return motion.q.back();
  const VectorX &q0 = motion.q[k], &q1 = motion.q[k + 1], &v0 = motion.v[k], &v1 = motion.v[k + 1];
  VectorX q(q0.size());
  const double h = motion.step_s;
  for (Eigen::Index i = 0; i < 3; ++i) q[i] = Hermite(q0[i], h * v0[i], q1[i], h * v1[i], s);
  for (Eigen::Index i = 7; i < q.size(); ++i) q[i] = Hermite(q0[i], h * v0[i - 1], q1[i], h * v1[i - 1], s);
  const Quaternion r0(Eigen::Vector4d(q0.segment<4>(3))), r1(Eigen::Vector4d(q1.segment<4>(3)));
  q.segment<4>(3) = r0.normalized().slerp(s, r1.normalized()).coeffs();
  return q;
}

std::vector<ContactWrench> Wrenches(const WholeBodyTrajectory& motion, std::size_t k, double s) {
  if (motion.wrenches.size() <= k) return {};
  std::vector<ContactWrench> blend = motion.wrenches[k];
  if (motion.wrenches.size() <= k + 1) return blend;
  for (std::size_t i = 0; i < blend.size(); ++i) {
    const ContactWrench& next = motion.wrenches[k + 1][i];
    blend[i].force_W += s * (next.force_W - blend[i].force_W);
    blend[i].moment_W += s * (next.moment_W - blend[i].moment_W);
  }
  return blend;
}

}  // namespace

PlanState PlanStateAt(const WholeBodyTrajectory& motion, double time_s) {
  if (motion.size() == 0) throw InvalidArgument("PlanStateAt: the plan has no whole-body rows; one or more are needed");
  const double last = static_cast<double>(motion.size() - 1);
  const double row = motion.step_s > 0.0 ? std::clamp((time_s - motion.start_s) / motion.step_s, 0.0, last) : 0.0;
  const double nearest = std::round(row);
  const double whole = std::abs(row - nearest) < 1e-9 ? nearest : std::floor(row);
  const std::size_t k = static_cast<std::size_t>(whole);
  const double s = std::max(0.0, row - whole);
  return {Position(motion, k, s), Blend(motion.v, k, s), Blend(motion.a, k, s), Blend(motion.tau, k, s),
          Wrenches(motion, k, s)};
}

}  // namespace gaitwright
