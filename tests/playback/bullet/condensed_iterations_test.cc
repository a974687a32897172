// SPDX-License-Identifier: BSD-3-Clause
// Our condensed solver of contacts moves bodies as Bullet's own solver does, with many iterations.
#include <gtest/gtest.h>

#include "playback/bullet/bullet_world.h"
#include "tests/playback/one_body.h"

namespace gaitwright {
namespace {

using one_body::Ball, one_body::Block, one_body::kRadius, one_body::OnSlope;

struct Fall {
  const char* name;
  RobotModel model;
  double distance_m, slope_rad, friction;
  Vector3 v_W = Vector3::Zero();
  int steps = 500;
};

std::vector<Fall> Falls() {
  return {{"BallRolls", Ball(), kRadius, 0.2, 0.8},
          {"BallSlides", Ball(), kRadius, 0.0, 0.3, {1.4, 0.0, 0.0}},
          {"BallDrops", Ball(), kRadius + 0.1, 0.0, 0.8},
          {"BlockRests", Block(0.4, 0.3, 0.05), 0.025, 0.1, 0.5},
          {"BlockSlides", Block(0.4, 0.3, 0.05), 0.025, 0.6, 0.5},
          {"TowerTips", Block(0.1, 0.1, 0.4), 0.2, 0.3, 2.0, Vector3::Zero(), 300}};
}

class OwnSolver : public testing::TestWithParam<Fall> {};

TEST_P(OwnSolver, MovesBodiesEqually) {
  const Fall& fall = GetParam();
  WorldOptions options;
  options.ground_slope_deg = -fall.slope_rad * 180.0 / M_PI;
  options.friction = fall.friction;
  options.solver_iterations = 500;
  const VectorX q = OnSlope(fall.distance_m, fall.slope_rad), none;
  BulletWorld ours(fall.model, FlatTerrain(), q, options), bullets(fall.model, FlatTerrain(), q, options, false);
  VectorX v = VectorX::Zero(6);
  v.head<3>() = fall.v_W;
  ours.SetState(q, v);
  bullets.SetState(q, v);
  for (int k = 0; k < fall.steps; ++k) {
    ours.Step({none, none, none, none, none});
    bullets.Step({none, none, none, none, none});
    ASSERT_LT((ours.q().head<3>() - bullets.q().head<3>()).norm(), 2e-3) << "at step " << k;
    const Quaternion a(ours.q().segment<4>(3)), b(bullets.q().segment<4>(3));
    ASSERT_LT(a.angularDistance(b), 0.02) << "at step " << k;
  }
  EXPECT_NEAR(ours.feet()[0].wrench.force_W.z(), bullets.feet()[0].wrench.force_W.z(), 0.05 * 9.81 * one_body::kMass);
}

INSTANTIATE_TEST_SUITE_P(Falls, OwnSolver, testing::ValuesIn(Falls()),
                         [](const auto& fall) { return std::string(fall.param.name); });

}  // namespace
}  // namespace gaitwright
