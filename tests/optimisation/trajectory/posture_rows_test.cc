// SPDX-License-Identifier: BSD-3-Clause
// Rows of a knot's posture: what they are, and that the solver keeps links apart. Their derivatives are checked with
// those of all rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimisation/trajectory/body_rows_internal.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

/// A robot that stands still over five knots, with the spline of that.
struct StandingRows {
  explicit StandingRows(const char* name) : model(AnyRobot(name)), distances(model), problem(LiftingProblem(model, 5)) {
    problem.distances = &distances;
  }
  VectorX Still() const {
    Eigen::Index size = model.nv() * 7;
    for (const BodyKnot& knot : problem.knots) {
      for (const PressingFoot& foot : knot.pressing)
        size += 3 * static_cast<Eigen::Index>(foot.contact.points_F.size());
    }
    VectorX z = VectorX::Zero(size);
    const MatrixX values = problem.knots.front().reference.x.replicate(1, 5);
    const MatrixX points =
        ChainSpline(problem.time_s).Through(values, VectorX::Zero(model.nv()), VectorX::Zero(model.nv()));
    z.head(points.size()) = Eigen::Map<const VectorX>(points.data(), points.size());
    return z;
  }

  RobotModel model;
  LinkDistances distances;
  BodyProblem problem;
};

TEST(PostureRows, OfDistancesAreTheDistancesAndAskForTheirMargin) {
  for (const char* name : {"a1", "nao"}) {
    StandingRows standing(name);
    standing.problem.knots[2].apart = {{0, 0.01}, {5, 0.02}};
    standing.problem.use.apart = 0.5;
    const BodyRows rows(standing.problem, standing.Still());
    int found = 0;
    for (Eigen::Index row = rows.residuals(); row < rows.count(); ++row) {
      if (!rows.NameOf(row).starts_with("distance")) continue;
      const ApartPair& pair = standing.problem.knots[2].apart[static_cast<std::size_t>(found++)];
      EXPECT_EQ(rows.NameOf(row), "distance of " + standing.distances.NameOf(pair.pair) + " at 0.020 s");
      EXPECT_NEAR(rows.value()[row], kApartUnit * standing.distances.standing_m(pair.pair), 1e-8);
      EXPECT_DOUBLE_EQ(rows.BoundsOf(row).lower, kApartUnit * 0.5 * pair.least_m);
      EXPECT_TRUE(std::isinf(rows.BoundsOf(row).upper));
    }
    EXPECT_EQ(found, 2);
  }
}

TEST(PostureRows, OfPointsAreZeroAtTheirPlaces) {
  StandingRows standing("nao");
  const VectorX still = standing.Still();
  DynamicsScratch scratch(standing.model);
  ForwardKinematics(standing.model, StandingConfiguration(standing.model), scratch);
  const int body = static_cast<int>(standing.model.bodies.size()) - 1;
  const Vector3 p_BQ(0.05, 0.0, 0.02), p_WQ = scratch.p_WB.back() + scratch.R_WB.back() * p_BQ,
                                       p_BaseQ = scratch.R_WB[0].transpose() * (p_WQ - scratch.p_WB[0]);
  const auto cost_with = [&](const std::vector<PointGoal>& points) {
    standing.problem.knots[2].points = points;
    const BodyRows rows(standing.problem, still);
    return rows.value().head(rows.residuals()).squaredNorm();
  };
  const double without = cost_with({});
  EXPECT_NEAR(cost_with({{body, p_BQ, p_WQ, false, 7.0}, {body, p_BQ, p_BaseQ, true, 7.0}}), without, 1e-12);
  const Vector3 off(0.03, 0.0, -0.04);
  EXPECT_NEAR(cost_with({{body, p_BQ, p_WQ + off, false, 7.0}}) - without, std::pow(7.0 * 0.05, 2.0), 1e-9);
  EXPECT_NEAR(cost_with({{body, p_BQ, p_BaseQ + off, true, 7.0}}) - without, std::pow(7.0 * 0.05, 2.0), 1e-9);
}

}  // namespace
}  // namespace gaitwright
