// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "optimisation/trajectory/body_rows_internal.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

/// A robot that stands for ten knots, and control points of a small random motion.
struct SmallMotion {
  SmallMotion() : model(AnyRobot("a1")), problem(LiftingProblem(model, 10)) {
    std::vector<VectorX> forces;
    Eigen::Index points = 0;
    for (const BodyKnot& knot : problem.knots) {
      points = 0;
      for (const PressingFoot& foot : knot.pressing) points += static_cast<Eigen::Index>(foot.contact.points_F.size());
      forces.emplace_back(0.1 * random.Vector(3 * points));
    }
    MatrixX control(model.nv(), 12);
    for (Eigen::Index j = 0; j < control.cols(); ++j)
      control.col(j) = problem.knots.front().reference.x + 0.05 * random.Vector(model.nv());
    z = Unknowns(control, forces);
  }

  RandomState random{11};
  RobotModel model;
  BodyProblem problem;
  VectorX z;
};

/// A problem whose time passes twice as fast is one whose knots are half as far apart.
TEST(ChosenMotion, AConstantPaceIsAnotherStep) {
  SmallMotion of;
  BodyRows paced(of.problem, of.z);
  const std::vector<KnotPace> twice(10, KnotPace{2.0, 0.0});
  const std::vector<std::vector<Vector3>> none(10, std::vector<Vector3>(of.model.legs.size(), Vector3::Zero()));
  paced.SetChosen(twice, none);
  paced.Evaluate(of.z);
  BodyProblem faster = of.problem;
  for (double& time_s : faster.time_s) time_s *= 0.5;
  const BodyRows rows(faster, of.z);
  for (std::size_t k = 0; k < 10; ++k) {
    for (const auto& [first, end] : paced.RowsOf(k))
      EXPECT_LT((paced.value() - rows.value()).segment(first, end - first).norm(), 1e-9) << k;
  }
}

TEST(ChosenMotion, AShiftedGoalIsAnotherGoal) {
  SmallMotion of;
  BodyRows shifted(of.problem, of.z);
  std::vector<std::vector<Vector3>> shifts_W(10, std::vector<Vector3>(of.model.legs.size(), Vector3::Zero()));
  shifts_W[4][1] = {0.01, -0.02, 0.03};
  shifted.SetChosen(std::vector<KnotPace>(10), shifts_W);
  shifted.Evaluate(of.z);
  BodyProblem other = of.problem;
  other.knots[4].feet[1].p_W += shifts_W[4][1];
  EXPECT_LT((shifted.value() - BodyRows(other, of.z).value()).norm(), 1e-12);
}

/// Powers are torque times speed: with twice the weight their residuals are twice as large, and nothing else changes.
TEST(ChosenMotion, PowerIsWeighedAlone) {
  SmallMotion of;
  const BodyRows without(of.problem, of.z);
  of.problem.weights.power = 1.0;
  const BodyRows once(of.problem, of.z);
  of.problem.weights.power = 2.0;
  const BodyRows twice(of.problem, of.z);
  EXPECT_EQ(once.residuals(), twice.residuals());
  EXPECT_EQ(once.residuals(), without.residuals() + 10 * static_cast<Eigen::Index>(ActuatorsOf(of.model).size()));
  const auto squares = [](const BodyRows& rows) { return rows.value().head(rows.residuals()).squaredNorm(); };
  const double power = squares(once) - squares(without);
  EXPECT_GT(power, 0.0);
  EXPECT_NEAR(squares(twice) - squares(without), 4.0 * power, 1e-9 * power);
}

}  // namespace
}  // namespace gaitwright
