// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/roll_moments.h"

#include <gtest/gtest.h>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// The hopper's motion over contacts whose displacement is a function of the share u of a stance.
template <class Moved>
struct Rolling {
  RigidBodyProblem problem = rigid_bodies::Hopper();
  RigidBodyMotion motion;
  std::vector<RigidBodySample> samples;
  std::vector<Vector3> moments;

  explicit Rolling(const Moved& moved) {
    for (RigidStance& stance : problem.stances) {
      constexpr int kSteps = 1000;
      for (int k = 0; k <= kSteps; ++k)
        stance.moved_W.emplace_back(moved(static_cast<double>(k) / kSteps) * Vector3::UnitX());
    }
    const Result<RigidBodyPlan> plan = PlanRigidBody(problem, {});
    EXPECT_TRUE(plan.ok()) << (plan.ok() ? "" : plan.failure().message);
    if (!plan.ok()) return;
    motion = plan->motion;
    samples = Sample(motion, 0.005);
    moments = RollMoments(problem, motion, samples);
  }
};

TEST(RollMoments, AreNoneOfContactsThatMoveEvenly) {
  const Rolling rolling([](double u) { return 0.02 * u; });
  ASSERT_EQ(rolling.moments.size(), rolling.samples.size());
  for (const Vector3& moment : rolling.moments) EXPECT_LT(moment.norm(), 1e-9);
}

TEST(RollMoments, AreThoseOfTheDistanceBetweenArcAndChord) {
  constexpr double kMoved = 0.02;  // times u^2
  const Rolling rolling([](double u) { return kMoved * u * u; });
  ASSERT_FALSE(rolling.moments.empty());
  double largest = 0.0;
  for (std::size_t k = 0; k < rolling.samples.size(); ++k) {
    const RigidBodySample& sample = rolling.samples[k];
    const RigidBodyInterval& in = rolling.motion.intervals[sample.interval];
    if (in.forces.empty()) {
      EXPECT_EQ(rolling.moments[k], Vector3::Zero()) << "in the air, at " << sample.time_s;
      continue;
    }
    ASSERT_EQ(in.forces.size(), 1U);
    const RigidStance& stance = rolling.problem.stances[in.forces[0].stance];
    const double whole = stance.end_s - stance.start_s;
    // A parabola is below its chord by its curvature times the distances from both ends.
    const double below = kMoved * (sample.time_s - in.start_s) * (in.end_s - sample.time_s) / (whole * whole);
    const Vector3 expected = -below * Vector3::UnitX().cross(sample.force_W[0]);
    EXPECT_LT((rolling.moments[k] - expected).norm(), 1e-4 * 0.25 * kMoved * rolling.motion.mass_kg * kGravity)
        << sample.time_s;
    largest = std::max(largest, rolling.moments[k].norm());
  }
  EXPECT_GT(largest, 1e-3);
}

}  // namespace
}  // namespace gaitwright
