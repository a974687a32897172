// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/model/upper_body.h"
#include "optimisation/pipeline/apart_pairs_internal.h"
#include "tests/named_robot.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

constexpr double kDuration = 1.0, kStep = 0.01;

/// A humanoid that stands still but for a joint of its left arm, which turns by an angle and back.
struct ArmMotion {
  explicit ArmMotion(double angle_rad, double first_rad = 0.0) {
    const UpperBody upper = FindUpperBody(model);
    const int dof = upper.left_arm->dofs[1];  // of the shoulder, about the forward axis
    for (int k = 0; k <= std::lround(kDuration / kStep); ++k) {
      VectorX q = StandingConfiguration(model);
      q[7 + dof] += first_rad + angle_rad * std::pow(std::sin(M_PI * k * kStep / kDuration), 2.0);
      motion.q.push_back(q);
    }
    motion.step_s = kStep;
    motion.v.assign(motion.q.size(), VectorX::Zero(model.nv()));
    motion.a = motion.v;
    motion.tau.assign(motion.q.size(), VectorX::Zero(model.num_dofs()));
    motion.wrenches.assign(motion.q.size(), std::vector<ContactWrench>(model.feet.size()));
    problem = LiftingProblem(model, static_cast<int>(motion.q.size()));
    for (std::size_t k = 0; k < motion.q.size(); ++k)
      problem.knots[k].reference.x.tail(model.num_dofs()) = motion.q[k].tail(model.num_dofs());
  }
  std::size_t Listed() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(problem.knots, [](const BodyKnot& knot) { return !knot.apart.empty(); }));
  }

  const RobotModel& model = NamedRobot("h1");
  WholeBodyTrajectory motion;
  BodyProblem problem;
};

TEST(ApartPairs, ListNothingWhereNothingTouches) {
  ArmMotion out(0.3);
  ApartPairs pairs(out.model, 0.004);
  EXPECT_FALSE(pairs.Watch(out.motion, out.problem));
  EXPECT_EQ(out.Listed(), 0U);
  EXPECT_TRUE(pairs.Listed().empty());
}

TEST(ApartPairs, ListAPairAroundTheTimeAtWhichItTouches) {
  ArmMotion in(-0.5);
  ApartPairs pairs(in.model, 0.004);
  EXPECT_TRUE(pairs.Watch(in.motion, in.problem));
  EXPECT_GT(in.Listed(), 10U);
  EXPECT_LT(in.Listed(), 95U) << "far from it the pair costs nothing";
  EXPECT_TRUE(in.problem.knots.front().apart.empty());
  EXPECT_FALSE(in.problem.knots[50].apart.empty());
  ASSERT_FALSE(pairs.Listed().empty());
  EXPECT_NE(pairs.Listed().front().find("left"), std::string::npos) << pairs.Listed().front();
  const double margin_m = in.problem.knots[50].apart.front().least_m;
  EXPECT_LE(margin_m, 0.004);
  EXPECT_GT(margin_m, 0.0);

  const std::size_t listed = in.Listed();
  EXPECT_TRUE(pairs.Watch(in.motion, in.problem)) << "it touches still";
  EXPECT_EQ(in.Listed(), listed);
  EXPECT_GT(in.problem.knots[50].apart.front().least_m, margin_m) << "and is to keep more distance then";

  const ArmMotion out(0.3);
  EXPECT_FALSE(pairs.Watch(out.motion, in.problem));
  EXPECT_EQ(in.Listed(), listed) << "pairs stay listed";
  ApartPairs::Clear(in.problem);
  EXPECT_EQ(in.Listed(), 0U);
}

/// A wall on the left, into which the arm swings.
TEST(ApartPairs, ListLinksThatTouchASolid) {
  ArmMotion out(0.6);
  const FixedSolids wall{{}, {{"wall", -Vector3::UnitY(), -0.5}}};
  ApartPairs pairs(out.model, 0.004, wall);
  EXPECT_TRUE(pairs.Watch(out.motion, out.problem));
  EXPECT_GT(out.Listed(), 10U);
  EXPECT_LT(out.Listed(), out.problem.knots.size());
  ASSERT_FALSE(pairs.Listed().empty());
  for (const std::string& pair : pairs.Listed()) {
    EXPECT_NE(pair.find("left"), std::string::npos) << pair;
    EXPECT_NE(pair.find("and 'wall'"), std::string::npos) << pair;
  }
  EXPECT_EQ(out.problem.knots[50].apart.front().least_m, 0.004);
  ApartPairs without(out.model, 0.004);
  EXPECT_FALSE(without.Watch(out.motion, out.problem));
}

TEST(ApartPairs, RiseToTheirMarginFromAPostureThatIsPinned) {
  ArmMotion in(-0.5);
  in.problem.knots.front().reference.x = in.problem.knots[50].reference.x;  // touches
  ApartPairs pairs(in.model, 0.004);
  ASSERT_TRUE(pairs.Watch(in.motion, in.problem));
  const auto least_at = [&](std::size_t k) { return in.problem.knots[k].apart.front().least_m; };
  std::size_t first = 0;
  while (in.problem.knots[first].apart.empty()) ++first;
  ASSERT_LT(first, 30U);
  EXPECT_LT(least_at(first), least_at(first + 1));
  EXPECT_GT(least_at(50), 0.0);
  EXPECT_EQ(least_at(50), least_at(45)) << "after 0.3 s";
}

TEST(ApartPairs, NeedAMargin) { EXPECT_THROW(ApartPairs(NamedRobot("a1"), 0.0), InvalidArgument); }

}  // namespace
}  // namespace gaitwright
