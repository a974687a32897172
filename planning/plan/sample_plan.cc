// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/sample_plan.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// Weights of (p0, v0 h, a0 h^2, p1, v1 h, a1 h^2) in the quintic Hermite polynomial at u in [0, 1], and in its
/// derivatives with respect to u.
struct HermiteWeights {
  double p[6], v[6], a[6];

  explicit HermiteWeights(double u) {
    const double u2 = u * u, u3 = u2 * u, u4 = u3 * u, u5 = u4 * u;
    const double basis[6] = {1.0 - 10.0 * u3 + 15.0 * u4 - 6.0 * u5,    u - 6.0 * u3 + 8.0 * u4 - 3.0 * u5,
                             0.5 * u2 - 1.5 * u3 + 1.5 * u4 - 0.5 * u5, 10.0 * u3 - 15.0 * u4 + 6.0 * u5,
                             -4.0 * u3 + 7.0 * u4 - 3.0 * u5,           0.5 * u3 - u4 + 0.5 * u5};
    const double first[6] = {-30.0 * u2 + 60.0 * u3 - 30.0 * u4, 1.0 - 18.0 * u2 + 32.0 * u3 - 15.0 * u4,
                             u - 4.5 * u2 + 6.0 * u3 - 2.5 * u4, 30.0 * u2 - 60.0 * u3 + 30.0 * u4,
                             -12.0 * u2 + 28.0 * u3 - 15.0 * u4, 1.5 * u2 - 4.0 * u3 + 2.5 * u4};
    const double second[6] = {-60.0 * u + 180.0 * u2 - 120.0 * u3,   -36.0 * u + 96.0 * u2 - 60.0 * u3,
                              1.0 - 9.0 * u + 18.0 * u2 - 10.0 * u3, 60.0 * u - 180.0 * u2 + 120.0 * u3,
                              -24.0 * u + 84.0 * u2 - 60.0 * u3,     3.0 * u - 12.0 * u2 + 10.0 * u3};
    std::copy(basis, basis + 6, p);
    std::copy(first, first + 6, v);
    std::copy(second, second + 6, a);
  }
};

/// A coordinate (or a vector of coordinates) at a node, with its rate and acceleration.
template <class Value>
struct NodeState {
  const Value &p, &v, &a;
};

/// The polynomial of one coordinate (or a vector of coordinates) over an interval of length h between two nodes.
template <class Value>
Value Blend(const double (&w)[6], double h, const NodeState<Value>& left, const NodeState<Value>& right) {
  return w[0] * left.p + w[1] * h * left.v + w[2] * h * h * left.a + w[3] * right.p + w[4] * h * right.v +
         w[5] * h * h * right.a;
}

/// Two neighbouring nodes and the position between them in [0, 1]; outside of the grid, both are the end node.
struct Interval {
  std::size_t left = 0, right = 0;
  double u = 0.0;
};

Interval Locate(double start_s, double step_s, int size, double time_s) {
  constexpr double kRounding = 1e-9;  // share of a step
  const auto last = static_cast<std::size_t>(size - 1);
  const double most = static_cast<double>(last), position = (time_s - start_s) / step_s;
  if (last == 0 || position < -kRounding) return {0, 0, 0.0};
  if (position > most + kRounding) return {last, last, 0.0};
  const auto left = std::min(static_cast<std::size_t>(std::max(position, 0.0)), last - 1);
  return {left, left + 1, std::clamp(position - static_cast<double>(left), 0.0, 1.0)};
}

void BlendBaseRotation(const WholeBodyTrajectory& t, const Interval& at, const HermiteWeights& weights,
                       WholeBodySample& s) {
  const double h = t.step_s;
  const Matrix3 R0 = BaseRotation(t.q[at.left]);
  const Vector3 turn = RotationLog(BaseRotation(t.q[at.right]) * R0.transpose());
  const Vector3 w0 = t.v[at.left].segment<3>(3), w1 = t.v[at.right].segment<3>(3);
  const Vector3 d0 = t.a[at.left].segment<3>(3), d1 = t.a[at.right].segment<3>(3);
  // Rates of the rotation vector: w = phi' + phi x phi' / 2 + ...; the rotation of one step is small.
  const Vector3 rate1 = w1 - 0.5 * turn.cross(w1);
  const Vector3 acceleration1 = d1 - 0.5 * turn.cross(d1);
  const Vector3 zero = Vector3::Zero();
  const NodeState<Vector3> left{zero, w0, d0}, right{turn, rate1, acceleration1};
  const Vector3 phi = Blend(weights.p, h, left, right);
  const Vector3 rate = Blend(weights.v, h, left, right) / h;
  const Vector3 acceleration = Blend(weights.a, h, left, right) / (h * h);
  s.q.segment<4>(3) = Quaternion(RotationExp(phi) * R0).coeffs();
  s.v.segment<3>(3) = rate + 0.5 * phi.cross(rate);
  s.a.segment<3>(3) = acceleration + 0.5 * phi.cross(acceleration);
}

void BlendStates(const WholeBodyTrajectory& t, const Interval& at, WholeBodySample& s) {
  const double h = t.step_s;
  const HermiteWeights weights(at.u);
  const VectorX &q0 = t.q[at.left], &q1 = t.q[at.right];
  const VectorX &v0 = t.v[at.left], &v1 = t.v[at.right];
  const VectorX &a0 = t.a[at.left], &a1 = t.a[at.right];
  const auto blend = [&](Eigen::Index iq, Eigen::Index iv) {
    const NodeState<double> left{q0[iq], v0[iv], a0[iv]}, right{q1[iq], v1[iv], a1[iv]};
    s.q[iq] = Blend(weights.p, h, left, right);
    s.v[iv] = Blend(weights.v, h, left, right) / h;
    s.a[iv] = Blend(weights.a, h, left, right) / (h * h);
  };
  for (Eigen::Index i = 0; i < 3; ++i) blend(i, i);
  for (Eigen::Index i = 6; i < v0.size(); ++i) blend(i + 1, i);
  BlendBaseRotation(t, at, weights, s);
}

}  // namespace

void SampleWholeBody(const WholeBodyTrajectory& trajectory, double time_s, WholeBodySample& sample) {
  const Interval at = Locate(trajectory.start_s, trajectory.step_s, trajectory.size(), time_s);
  sample.q = trajectory.q[at.left];
  sample.v = trajectory.v[at.left];
  sample.a = trajectory.a[at.left];
  if (at.left == at.right) {
    sample.v.setZero();
    sample.a.setZero();
  } else {
    BlendStates(trajectory, at, sample);
  }
  if (trajectory.tau.empty()) {
    sample.tau.resize(0);
  } else {
    sample.tau = (1.0 - at.u) * trajectory.tau[at.left] + at.u * trajectory.tau[at.right];
  }
  sample.wrenches.resize(trajectory.wrenches.empty() ? 0 : trajectory.wrenches[at.left].size());
  for (std::size_t f = 0; f < sample.wrenches.size(); ++f) {
    const ContactWrench &left = trajectory.wrenches[at.left][f], &right = trajectory.wrenches[at.right][f];
    sample.wrenches[f].force_W = (1.0 - at.u) * left.force_W + at.u * right.force_W;
    sample.wrenches[f].moment_W = (1.0 - at.u) * left.moment_W + at.u * right.moment_W;
  }
}

CentroidalSample SampleCentroidal(const CentroidalTrajectory& t, double time_s) {
  const Interval at = Locate(t.start_s, t.step_s, t.size(), time_s);
  CentroidalSample sample;
  sample.p_WZ = (1.0 - at.u) * t.p_WZ[at.left] + at.u * t.p_WZ[at.right];
  if (at.left == at.right) {
    sample.p_WC = t.p_WC[at.left];
    return sample;
  }
  const HermiteWeights w(at.u);
  const double h = t.step_s;
  const NodeState<Vector3> left{t.p_WC[at.left], t.v_WC[at.left], t.a_WC[at.left]};
  const NodeState<Vector3> right{t.p_WC[at.right], t.v_WC[at.right], t.a_WC[at.right]};
  const auto blend = [&](const double(&weights)[6]) { return Blend(weights, h, left, right); };
  sample.p_WC = blend(w.p);
  sample.v_WC = blend(w.v) / h;
  sample.a_WC = blend(w.a) / (h * h);
  return sample;
}

Vector3 CentreDisplacement(const CentroidalTrajectory& trajectory, double from_s, double to_s) {
  return SampleCentroidal(trajectory, to_s).p_WC - SampleCentroidal(trajectory, from_s).p_WC;
}

SwingCurve CurveOf(const SwingTrajectory& swing) {
  return {swing.start_s, swing.end_s, swing.X_WF_start, swing.X_WF_end, swing.lift_m, swing.detour_W, swing.cruise};
}

}  // namespace gaitwright
