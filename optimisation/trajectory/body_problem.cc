// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

int FootGoal::count() const { return static_cast<int>(std::count(rows.begin(), rows.end(), true)); }

std::vector<RowBounds> FootBoundsOf(const BodyKnot& knot) {
  std::vector<RowBounds> bounds;
  for (const FootGoal& goal : knot.feet) {
    for (std::size_t i = 0; i < goal.rows.size(); ++i) {
      if (goal.rows[i]) bounds.push_back({-goal.below[i], goal.above[i]});
    }
  }
  return bounds;
}

void StateOf(const TurningChart& chart, const VectorJet& jet, ChartedState& state) {
  const Eigen::Index n = jet.x.size();
  state.turn = chart.At({jet.x.segment<3>(3), jet.rate.segment<3>(3), jet.acceleration.segment<3>(3)});
  state.q.resize(n + 1);
  state.q.head<3>() = jet.x.head<3>();
  state.q.segment<4>(3) = Quaternion(state.turn.R).coeffs();
  state.q.tail(n - 6) = jet.x.tail(n - 6);
  state.v = jet.rate;
  state.v.segment<3>(3) = state.turn.w;
  state.a = jet.acceleration;
  state.a.segment<3>(3) = state.turn.alpha;
}

VectorJet JetOf(const TurningChart& chart, const VectorX& q, const VectorX& v, const VectorX& a, const VectorX& near) {
  const AngleJet turn = chart.JetOf(BaseRotation(q), v.segment<3>(3), a.segment<3>(3), near.segment<3>(3));
  VectorJet jet;
  jet.x.resize(v.size());
  jet.x << q.head<3>(), turn.x, q.tail(q.size() - 7);
  jet.rate = v;
  jet.rate.segment<3>(3) = turn.rate;
  jet.acceleration = a;
  jet.acceleration.segment<3>(3) = turn.acceleration;
  return jet;
}

BodyProblem WindowOf(const BodyProblem& whole, const ChainSpline& spline, const MatrixX& points, int first, int last) {
  BodyProblem part{whole.model,     whole.chart,      {},          {},
                   whole.weights,   whole.use,        whole.still, BodyWindow{{}, 0.0, 0.0},
                   whole.distances, whole.limits_jerk};
  part.window->start_s = whole.start_s();
  part.window->end_s = whole.end_s();
  for (int k = first; k <= last; ++k) {
    part.time_s.push_back(whole.time_s[static_cast<std::size_t>(k)]);
    part.knots.push_back(whole.knots[static_cast<std::size_t>(k)]);
    part.window->basis.push_back(spline.At(k));
  }
  if (first == 0) return part;
  BodyKnot& seam = part.knots.front();
  seam.is_given = seam.pins_place = seam.pins_motion = true;
  seam.pressing.clear();
  seam.apart.clear();
  seam.points.clear();
  VectorJet& given = seam.reference;
  given.x.setZero();
  given.rate.setZero();
  given.acceleration.setZero();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto point = points.col(first + static_cast<Eigen::Index>(i));
    given.x += spline.At(first).value[i] * point;
    given.rate += spline.At(first).rate[i] * point;
    given.acceleration += spline.At(first).acceleration[i] * point;
  }
  return part;
}

}  // namespace gaitwright
