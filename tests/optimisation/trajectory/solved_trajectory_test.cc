// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "optimisation/trajectory/solved_trajectory_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

class Solved : public testing::TestWithParam<const char*> {
 protected:
  /// A motion near the standing posture with accelerations of some 100 rad/s^2, and forces that do not balance it.
  Solved() : any_(GetParam()) {
    const ChainSpline spline(any_.problem.time_s);
    const Eigen::Index nv = any_.problem.model->nv();
    RandomState random(3);
    MatrixX values(nv, spline.knots());
    for (int k = 0; k < spline.knots(); ++k) {
      const BodyKnot& knot = any_.problem.knots[static_cast<std::size_t>(k)];
      values.col(k) = knot.reference.x + 2e-3 * random.Vector(nv);
      Eigen::Index size = 0;
      for (const PressingFoot& foot : knot.pressing)
        size += static_cast<Eigen::Index>(3 * foot.contact.points_F.size());
      forces_.push_back(0.3 * random.Vector(size));
    }
    points_ = spline.Through(values, VectorX::Zero(nv), VectorX::Zero(nv));
  }

  AnyProblem any_;
  MatrixX points_;
  std::vector<VectorX> forces_;
};

TEST_P(Solved, IsTheSplineAtKnotsAndForJoints) {
  const SolvedTrajectory solved(any_.problem, points_, forces_);
  const ChainSpline spline(any_.problem.time_s);
  const std::vector<double>& times = any_.problem.time_s;
  VectorJet jet, of_spline;
  for (std::size_t k = 0; k < times.size(); ++k) {
    solved.Sample(times[k], jet);
    spline.Sample(points_, times[k], of_spline);
    EXPECT_LT((jet.x - of_spline.x).norm(), 1e-12) << k;
  }
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double middle = 0.5 * (times[k] + times[k + 1]);
    solved.Sample(middle, jet);
    spline.Sample(points_, middle, of_spline);
    const Eigen::Index joints = jet.x.size() - 6;
    EXPECT_EQ(jet.x.tail(joints), of_spline.x.tail(joints));
    EXPECT_EQ(jet.acceleration.tail(joints), of_spline.acceleration.tail(joints));
  }
}

TEST_P(Solved, DerivativesAreThoseOfThePosition) {
  const SolvedTrajectory solved(any_.problem, points_, forces_);
  const std::vector<double>& times = any_.problem.time_s;
  constexpr double kStep = 1e-5;
  VectorJet before, at, after;
  for (std::size_t k = 1; k + 2 < times.size(); ++k) {
    const double time_s = times[k] + 0.3 * (times[k + 1] - times[k]);
    solved.Sample(time_s - kStep, before);
    solved.Sample(time_s, at);
    solved.Sample(time_s + kStep, after);
    const VectorX rate = (after.x - before.x) / (2.0 * kStep), turn = (after.rate - before.rate) / (2.0 * kStep);
    EXPECT_LT((rate - at.rate).norm(), 1e-4 * (1.0 + at.rate.norm())) << k;
    EXPECT_LT((turn - at.acceleration).norm(), 1e-4 * (1.0 + at.acceleration.norm())) << k;
  }
}

/// Newton and Euler: between knots nothing is left unbalanced, where the spline alone leaves much.
TEST_P(Solved, BalancesTheBaseBetweenKnots) {
  const SolvedTrajectory solved(any_.problem, points_, forces_);
  const RobotModel& model = *any_.problem.model;
  const ChainSpline spline(any_.problem.time_s);
  const std::vector<double>& times = any_.problem.time_s;
  KnotModel knot(model);
  ChartedState state;
  VectorJet jet;
  std::vector<KnotContact> contacts;
  VectorX forces, needed;
  double of_spline = 0.0, of_solved = 0.0;
  for (std::size_t k = 1; k + 2 < times.size(); ++k) {
    const double time_s = times[k] + 0.4 * (times[k + 1] - times[k]);
    solved.ForcesAt(time_s, contacts, forces);
    for (const bool corrected : {false, true}) {
      if (corrected) {
        solved.Sample(time_s, jet);
      } else {
        spline.Sample(points_, time_s, jet);
      }
      StateOf(any_.problem.chart, jet, state);
      knot.Evaluate(state.q, state.v, state.a, contacts, model.weight_n() * forces, needed);
      double& worst = corrected ? of_solved : of_spline;
      worst = std::max(worst, needed.head<3>().norm() / model.weight_n());
    }
  }
  EXPECT_LT(of_solved, 0.02 * of_spline);
}

TEST_P(Solved, AsksTheKnotsForWhatMakesTheVelocityContinuous) {
  const SolvedTrajectory solved(any_.problem, points_, forces_);
  EXPECT_GT(solved.largest_jump(), 0.0);
  ASSERT_EQ(solved.ResidualsAtKnots().size(), any_.problem.time_s.size());
  EXPECT_EQ(solved.ResidualsAtKnots().front().norm(), 0.0) << "the robot rests";
  for (const Vector6& residual_W : solved.ResidualsAtKnots()) EXPECT_TRUE(residual_W.allFinite());
}

INSTANTIATE_TEST_SUITE_P(Robots, Solved, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
