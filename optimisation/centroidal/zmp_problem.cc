// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/zmp_problem.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

double FractionOf(const ZmpPhase& phase, double time_s) {
  return std::clamp((time_s - phase.start_s) / (phase.end_s - phase.start_s), 0.0, 1.0);
}

/// Transfers a point from one polygon to another, keeping its relative position to the corners: it stays on its edge,
/// at its corner or inside. The weights come from the triangle of the fan around the first corner that contains the
/// point or is nearest to it.
Vector2 Carried(const Polygon& from, const Vector2& p, const Polygon& to) {
  double best = -std::numeric_limits<double>::infinity();
  Vector2 carried = p;
  for (std::size_t i = 1; i + 1 < from.size(); ++i) {
    Eigen::Matrix2d edges, moved;
    edges << from[i] - from[0], from[i + 1] - from[0];
    moved << to[i] - to[0], to[i + 1] - to[0];
    if (!(std::abs(edges.determinant()) > 1e-12)) continue;
    const Vector2 share = edges.inverse() * (p - from[0]);
    const double inside = std::min({share.x(), share.y(), 1.0 - share.sum()});
    if (inside <= best) continue;
    best = inside;
    carried = to[0] + moved * share;
  }
  return carried;
}

}  // namespace

Polygon RegionAt(const ZmpPhase& phase, double time_s) {
  const double u = FractionOf(phase, time_s);
  Polygon region;
  for (std::size_t i = 0; i < phase.region_start.size(); ++i) {
    region.push_back((1.0 - u) * phase.region_start[i] + u * phase.region_end[i]);
  }
  return region;
}

Vector2 PreferredAt(const ZmpPhase& phase, double time_s) {
  const bool has_area = phase.region_start.size() >= 3;  // a ZMP on a line must follow the line, which moves evenly
  const double fraction = FractionOf(phase, time_s);
  if (!has_area) return (1.0 - fraction) * phase.preferred_start + fraction * phase.preferred_end;
  const Polygon now = RegionAt(phase, time_s);
  const double u = SmoothStep(fraction).value;
  return (1.0 - u) * Carried(phase.region_start, phase.preferred_start, now) +
         u * Carried(phase.region_end, phase.preferred_end, now);
}

std::size_t ZmpPhaseAt(const ZmpProblem& problem, double time_s) {
  constexpr double kTiny = 1e-9;
  const auto at = std::upper_bound(problem.phases.begin(), problem.phases.end(), time_s + kTiny,
                                   [](double t, const ZmpPhase& phase) { return t < phase.end_s; });
  return std::min(static_cast<std::size_t>(at - problem.phases.begin()), problem.phases.size() - 1);
}

CentroidalTrajectory PendulumMotion(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ) {
  const auto n = p_WZ.size();
  const double w = problem.omega_rad_s, h = problem.step_s, decay = std::exp(-w * h);
  std::vector<Vector2> input(n), xi(n), c(n);
  for (std::size_t k = 0; k < n; ++k) input[k] = p_WZ[k] - problem.zmp_offset[k];
  // Between samples the input is u + r t; the DCM is u + r t + r/w + A exp(w t), the CoM u + r t + A exp(w t)/2 + B
  // exp(-w t).
  xi[n - 1] = problem.end_W;
  for (std::size_t k = n - 1; k-- > 0;) {
    const Vector2 r_over_w = (input[k + 1] - input[k]) / (h * w);
    xi[k] = input[k] + r_over_w + decay * (xi[k + 1] - input[k + 1] - r_over_w);
  }
  c[0] = problem.start_W;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const Vector2 half_a = 0.5 * (xi[k] - input[k] - (input[k + 1] - input[k]) / (h * w));
    c[k + 1] = input[k + 1] + half_a / decay + decay * (c[k] - input[k] - half_a);
  }
  CentroidalTrajectory motion;
  motion.start_s = problem.start_s;
  motion.step_s = h;
  motion.omega_rad_s = w;
  motion.p_WZ = p_WZ;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector2 v = w * (xi[k] - c[k]), a = w * w * (c[k] - input[k]);
    motion.p_WC.emplace_back(c[k].x(), c[k].y(), problem.com_height_m);
    motion.v_WC.emplace_back(v.x(), v.y(), 0.0);
    motion.a_WC.emplace_back(a.x(), a.y(), 0.0);
  }
  return motion;
}

EndResponse RespondAtEnds(const ZmpProblem& problem) {
  const auto n = static_cast<std::size_t>(problem.samples);
  const double wh = problem.omega_rad_s * problem.step_s, decay = std::exp(-wh), gamma = (1.0 - decay) / wh;
  const double growth = 0.5 * (1.0 / decay - decay);
  EndResponse r;
  r.dcm_start.assign(n, 0.0);
  r.com_end.assign(n, 0.0);
  // One step of the DCM: xi_k = (1 - gamma) u_k + (gamma - decay) u_k+1 + decay xi_k+1.
  double weight = 1.0;
  for (std::size_t k = 0; k + 1 < n; ++k, weight *= decay) {
    r.dcm_start[k] += weight * (1.0 - gamma);
    r.dcm_start[k + 1] += weight * (gamma - decay);
  }
  r.dcm_start_by_end = weight;
  // One step of the CoM: c_k+1 = decay c_k + growth xi_k - (decay + growth - growth / wh) u_k + (1 - growth / wh)
  // u_k+1.
  std::vector<double> by_dcm(n, 0.0);
  weight = 1.0;
  for (std::size_t k = n - 1; k-- > 0; weight *= decay) {
    by_dcm[k] = weight * growth;
    r.com_end[k + 1] += weight * (1.0 - growth / wh);
    r.com_end[k] -= weight * (decay + growth - growth / wh);
  }
  r.com_end_by_start = weight;
  double carried = 0.0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    carried = by_dcm[k] + decay * carried;
    r.com_end[k] += carried * (1.0 - gamma);
    r.com_end[k + 1] += carried * (gamma - decay);
  }
  r.com_end_by_end = decay * carried;
  return r;
}

}  // namespace gaitwright
