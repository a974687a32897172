// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/link_distances_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

/// A posture in which some links overlap and others are near.
VectorX Tangled(const RobotModel& model, RandomState& random) {
  VectorX q = random.Configuration(model);
  for (int d = 0; d < model.num_dofs(); ++d) q[7 + d] = model.standing_joints[d] + 0.9 * random.Vector(1)[0];
  return q;
}

class DistancesOfLinks : public testing::TestWithParam<const char*> {
 protected:
  RobotModel model_ = Robot(GetParam());
  LinkDistances distances_{model_};
  DynamicsScratch scratch_{model_};
  RandomState random_{11};
};

TEST_P(DistancesOfLinks, HaveTheGradientOfFiniteDifferences) {
  int overlaps = 0, apart = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const VectorX q = Tangled(model_, random_);
    ForwardKinematics(model_, q, scratch_);
    const std::vector<NearPair> near = distances_.Near(scratch_, 0.03);
    ASSERT_FALSE(near.empty());
    for (const NearPair& pair : near) (pair.distance_m < 0.0 ? overlaps : apart) += 1;
    ExpectDerivative(
        [&](const VectorX& along, VectorX& value, MatrixX* J) {
          ForwardKinematics(model_, Moved(q, along, 1.0), scratch_);
          value.resize(static_cast<Eigen::Index>(near.size()));
          if (J != nullptr) J->setZero(value.size(), model_.nv());
          for (Eigen::Index i = 0; i < value.size(); ++i) {
            const int pair = near[static_cast<std::size_t>(i)].pair;
            const ConvexDistance at = distances_.At(pair, scratch_);
            value[i] = at.distance_m;
            VectorX gradient = VectorX::Zero(model_.nv());
            distances_.AddGradient(pair, at, scratch_, 1.0, gradient);
            if (J != nullptr) J->row(i) = gradient.transpose();
          }
        },
        VectorX::Zero(model_.nv()), 2e-4);
  }
  EXPECT_GT(overlaps, 10);
  EXPECT_GT(apart, 5);
}

TEST_P(DistancesOfLinks, AreThoseThatTheCollisionCheckerFinds) {
  CollisionChecker checker(model_);
  EXPECT_EQ(checker.num_pairs(), distances_.num_pairs());
  for (int trial = 0; trial < 20; ++trial) {
    ForwardKinematics(model_, Tangled(model_, random_), scratch_);
    std::vector<std::string> here, there;
    for (const NearPair& pair : distances_.Near(scratch_, 0.0)) here.push_back(distances_.NameOf(pair.pair));
    for (const Overlap& overlap : checker.Overlaps(scratch_))
      there.push_back("'" + overlap.link_a + "' and '" + overlap.link_b + "'");
    EXPECT_EQ(here, there);
  }
}

TEST_P(DistancesOfLinks, DoNotDependOnWhatWasSeenBefore) {
  std::size_t found = 0;
  const VectorX from = StandingConfiguration(model_), to = Tangled(model_, random_);
  for (int k = 0; k <= 40; ++k) {
    VectorX q = from;
    q.tail(model_.num_dofs()) += k / 40.0 * (to - from).tail(model_.num_dofs());
    ForwardKinematics(model_, q, scratch_);
    LinkDistances fresh(model_);
    const std::vector<NearPair>&near = distances_.Near(scratch_, 0.02), &wanted = fresh.Near(scratch_, 0.02);
    ASSERT_EQ(near.size(), wanted.size());
    for (std::size_t i = 0; i < near.size(); ++i) {
      EXPECT_EQ(near[i].pair, wanted[i].pair);
      EXPECT_EQ(near[i].distance_m, wanted[i].distance_m);
    }
    found += near.size();
  }
  EXPECT_GT(found, 0U);
}

TEST_P(DistancesOfLinks, ArePositiveAsTheRobotStands) {
  for (int i = 0; i < distances_.num_pairs(); ++i) EXPECT_GT(distances_.standing_m(i), 0.0) << distances_.NameOf(i);
}

/// A tilted half space and a box among the links.
FixedSolids SomeSolids() {
  FixedSolids solids;
  solids.half_spaces.push_back({"slope", Vector3(0.1, -0.2, 1.0).normalized(), 0.1});
  Shape box;
  box.type = ShapeType::kBox;
  box.size = Vector3(0.3, 0.2, 0.4);
  box.link = "box";
  box.X_BS.translation() = Vector3(0.1, 0.1, 0.3);
  solids.shapes.push_back(box);
  return solids;
}

TEST_P(DistancesOfLinks, ToSolidsMoveWithTheBaseToo) {
  const LinkDistances all(model_, SomeSolids());
  EXPECT_GT(all.num_pairs(), distances_.num_pairs());
  int overlaps = 0, apart = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const VectorX q = Tangled(model_, random_);
    ForwardKinematics(model_, q, scratch_);
    for (int pair = distances_.num_pairs(); pair < all.num_pairs(); ++pair) {
      const double distance_m = all.At(pair, scratch_).distance_m;
      EXPECT_GT(all.standing_m(pair), 0.0) << "above the ground";
      (distance_m < 0.0 ? overlaps : apart) += 1;
    }
    ExpectDerivative(
        [&](const VectorX& along, VectorX& value, MatrixX* J) {
          ForwardKinematics(model_, Moved(q, along, 1.0), scratch_);
          const int first = distances_.num_pairs();
          value.resize(all.num_pairs() - first);
          if (J != nullptr) J->setZero(value.size(), model_.nv());
          for (int pair = first; pair < all.num_pairs(); ++pair) {
            const ConvexDistance at = all.At(pair, scratch_);
            value[pair - first] = at.distance_m;
            VectorX gradient = VectorX::Zero(model_.nv());
            all.AddGradient(pair, at, scratch_, 1.0, gradient);
            if (J != nullptr) J->row(pair - first) = gradient.transpose();
          }
        },
        VectorX::Zero(model_.nv()), 2e-4);
  }
  EXPECT_GT(apart, 5);
}

/// The nearest point first; over a plane side other corners of the link, with their own distances to it.
TEST_P(DistancesOfLinks, ToSolidsHaveSeveralPoints) {
  const LinkDistances all(model_, SomeSolids());
  std::vector<ConvexDistance> points;
  int corners = 0;
  for (int trial = 0; trial < 6; ++trial) {
    ForwardKinematics(model_, Tangled(model_, random_), scratch_);
    all.PointsAt(0, scratch_, points);
    EXPECT_EQ(points.size(), 1U) << "of two links";
    for (int pair = distances_.num_pairs(); pair < all.num_pairs(); ++pair) {
      all.PointsAt(pair, scratch_, points);
      ASSERT_EQ(static_cast<int>(points.size()), all.num_points(pair));
      EXPECT_EQ(points.front().distance_m, all.At(pair, scratch_).distance_m);
      for (const ConvexDistance& at : points) {
        EXPECT_GE(at.distance_m, points.front().distance_m - 1e-9);
        EXPECT_LT((at.n_W - points.front().n_W).norm(), 1e-9);
        EXPECT_LT((at.p_WB - at.p_WA - at.distance_m * at.n_W).norm(), 1e-9);
        corners += (at.p_WA - points.front().p_WA).norm() > 1e-3 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(corners, 10);
}

TEST_P(DistancesOfLinks, NameSolidsThatAreNear) {
  LinkDistances all(model_, SomeSolids());
  ForwardKinematics(model_, StandingConfiguration(model_), scratch_);
  const std::vector<NearPair> near = all.Near(scratch_, 10.0);
  EXPECT_EQ(static_cast<int>(near.size()), all.num_pairs());
  std::set<std::string> solids;
  for (const NearPair& pair : near) {
    EXPECT_EQ(pair.distance_m, all.At(pair.pair, scratch_).distance_m);
    const std::string name = all.NameOf(pair.pair);
    solids.insert(name.substr(name.find(" and ") + 5));
  }
  EXPECT_TRUE(solids.contains("'slope'"));
  EXPECT_TRUE(solids.contains("'box'"));
}

INSTANTIATE_TEST_SUITE_P(Robots, DistancesOfLinks, testing::Values("a1", "nao", "h1"));

}  // namespace
}  // namespace gaitwright
