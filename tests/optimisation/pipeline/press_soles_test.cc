// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "optimisation/pipeline/press_soles_internal.h"

namespace gaitwright {
namespace {

/// A problem of one knot at which one foot presses at points.
BodyProblem Pressing(const std::vector<Vector3>& points_F) {
  BodyProblem problem;
  PressingFoot foot;
  foot.contact.points_F = points_F;
  foot.friction = 0.8;
  problem.knots.emplace_back().pressing = {foot};
  return problem;
}

TEST(KeepFromEdges, MovesEachEdgeByTheMarginOrByAShareOfANarrowSole) {
  BodyProblem sole = Pressing({{0.1, 0.02, 0.0}, {0.1, -0.02, 0.0}, {-0.06, -0.02, 0.0}, {-0.06, 0.02, 0.0}});
  KeepFromEdges({0.008, 0.2}, sole);
  const std::vector<Vector3>& points = sole.knots.front().pressing.front().contact.points_F;
  EXPECT_TRUE(points[0].isApprox(Vector3(0.092, 0.016, 0.0), 1e-12)) << points[0].transpose();
  EXPECT_TRUE(points[2].isApprox(Vector3(-0.052, -0.016, 0.0), 1e-12)) << points[2].transpose();
}

TEST(KeepFromEdges, LeavesPointsAndTheDirectionAcrossALineAlone) {
  BodyProblem line = Pressing({{0.1, 0.05, 0.0}, {0.1, -0.05, 0.0}}), point = Pressing({{0.1, 0.2, 0.3}});
  KeepFromEdges({0.008, 0.2}, line);
  KeepFromEdges({0.008, 0.2}, point);
  EXPECT_TRUE(line.knots.front().pressing.front().contact.points_F[0].isApprox(Vector3(0.1, 0.042, 0.0), 1e-12));
  EXPECT_EQ(point.knots.front().pressing.front().contact.points_F[0], Vector3(0.1, 0.2, 0.3));
}

TEST(LowerSoleFriction, LowersTheFrictionOfSolesOnly) {
  BodyProblem sole = Pressing({{0.1, 0.05, 0.0}, {0.1, -0.05, 0.0}, {-0.1, 0.0, 0.0}});
  BodyProblem line = Pressing({{0.1, 0.05, 0.0}, {0.1, -0.05, 0.0}});
  LowerSoleFriction(sole);
  LowerSoleFriction(line);
  EXPECT_NEAR(PressingOf(sole)[0][0].friction, 0.2, 1e-12);
  EXPECT_EQ(PressingOf(line)[0][0].friction, 0.8);
}

}  // namespace
}  // namespace gaitwright
