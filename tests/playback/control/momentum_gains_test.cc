// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/momentum_gains.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/plan/sample_plan.h"
#include "tests/playback/hops.h"

namespace gaitwright {
namespace {

constexpr Eigen::Index kFeet = MomentumGains::kFeet;

constexpr MomentumErrors kErrors{0.05, 0.2, 0.1, 0.5, 0.06};

/// The change of the total force, and of the moment about the centre of mass, of feet that push as planned at their
/// actual places.
Vector6 Whole(const MomentumGains::Row& row, const RobotModel& model, const MotionPlan& plan, double time_s,
              const VectorX& error) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, time_s, sample);
  Vector6 whole = Vector6::Zero();
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    const Vector6 wrench = sample.wrenches[f].force_W.z() * (row.wrench_per_n[f] * error);
    const Vector3 arm = model.joints[3 * f].X_PJ.translation() - sample.q.head<3>();
    whole.head<3>() += wrench.head<3>();
    whole.tail<3>() += wrench.tail<3>() + arm.cross(Vector3(wrench.head<3>()));
  }
  return whole;
}

/// Vertically and about the vertical axis, a robot on four feet is a free mass, whose optimal feedback is known.
class OnFourPoints : public ::testing::Test {
 protected:
  /// For y'' = u, with cost rate (y / most)^2 + (y' / fastest)^2 + (u / strongest)^2.
  static Vector2 ForAFreeMass(double most, double fastest, double strongest) {
    const double k = strongest / most;
    return {k, std::sqrt(strongest * strongest / (fastest * fastest) + 2.0 * k)};
  }

  const RobotModel model_ = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan_ = synthetic::StandingPlan(model_, 4.0);
  // Slow errors, so that the steps of the grid are comparatively short.
  const MomentumErrors errors_{1.0, 2.0, 10.0, 50.0, 1.0};
  const MomentumGains gains_ = DeriveMomentumGains(model_, plan_, errors_);
  const Eigen::Index size_ = kFeet + 8;
};

TEST_F(OnFourPoints, HeightIsHeldAsAFreeMassIs) {
  // Four times the square of a quarter of the acceleration over g.
  const Vector2 best = ForAFreeMass(errors_.position_m, errors_.velocity_m_s, 0.5 * kGravity);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Vector6 asked = Whole(gains_.At(1.0), model_, plan_, 1.0, VectorX::Unit(size_, 3 * i + 2));
    EXPECT_NEAR(asked[2] / model_.total_mass_kg, -best[i], 0.02 * best[i]);
    EXPECT_LT(asked.tail<3>().norm(), 1e-6 * asked.norm());
  }
}

TEST_F(OnFourPoints, HeadingIsHeldLikewise) {
  // Each foot pushes perpendicular to its arm, with a quarter of the moment divided by the arm.
  const double mu = plan_.terrain.patches.front().friction, arm = std::hypot(0.2, 0.15), inertia = 0.2;
  const double strongest = 0.5 * mu * model_.weight_n() * arm / inertia;
  const Vector2 best = ForAFreeMass(errors_.turn_rad, errors_.rate_rad_s, strongest);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Vector6 asked = Whole(gains_.At(1.0), model_, plan_, 1.0, VectorX::Unit(size_, 6 + 3 * i + 2));
    EXPECT_NEAR(asked[5] / inertia, -best[i], 0.02 * best[i]);
    EXPECT_LT(asked.head<3>().norm(), 1e-6 * asked.norm());
  }
}

TEST_F(OnFourPoints, StepsAreNowhereWhereNoFootComesDown) {
  EXPECT_EQ(gains_.At(1.0).steps.norm(), 0.0);
  EXPECT_EQ(static_cast<int>(gains_.rows.size()), plan_.whole_body.size() - 1);
  EXPECT_EQ(&gains_.At(-1.0), &gains_.rows.front());
  EXPECT_EQ(&gains_.At(99.0), &gains_.rows.back());
  EXPECT_EQ(&gains_.At(synthetic::kStep * 7), &gains_.rows[7]);
  EXPECT_EQ(&gains_.At(synthetic::kStep * 7.5), &gains_.rows[7]);
}

/// Robots that hop on the spot are symmetric to the plane y = 0, with left and right feet exchanged.
class MirroredHops : public ::testing::TestWithParam<int> {
 protected:
  int feet() const { return GetParam(); }
  FootSet Mirror(FootSet set) const {
    FootSet mirrored = 0;
    for (int f = 0; f < feet(); ++f) {
      if (Contains(set, f)) mirrored |= FootBit(f ^ 1);
    }
    return mirrored;
  }
  VectorX Mirror(const VectorX& error) const {
    VectorX mirrored = error;
    for (const Eigen::Index row : {1, 4, 6, 8, 9, 11}) mirrored[row] *= -1.0;
    for (Eigen::Index f = 0; f < feet(); ++f) {
      mirrored[kFeet + 2 * (f ^ 1)] = error[kFeet + 2 * f];
      mirrored[kFeet + 2 * (f ^ 1) + 1] = -error[kFeet + 2 * f + 1];
    }
    return mirrored;
  }
  static Vector6 MirrorOf(const Vector6& wrench) {
    return wrench.cwiseProduct((Vector6() << 1.0, -1.0, 1.0, -1.0, 1.0, -1.0).finished());
  }
  synthetic::Hops HopsOf(bool mirrored) const {
    synthetic::Hops hops;
    if (feet() == 2) hops.groups = {0b01, 0b10};
    for (FootSet& group : hops.groups) group = mirrored ? Mirror(group) : group;
    return hops;
  }

  const RobotModel model_ = synthetic::Robot(feet(), feet() == 2 ? FootType::kSole : FootType::kPoint);
};

TEST_P(MirroredHops, HaveMirroredGains) {
  const MomentumGains one = DeriveMomentumGains(model_, synthetic::HoppingPlan(model_, HopsOf(false)), kErrors);
  const MomentumGains other = DeriveMomentumGains(model_, synthetic::HoppingPlan(model_, HopsOf(true)), kErrors);
  ASSERT_EQ(one.rows.size(), other.rows.size());
  double steps = 0.0, moments = 0.0;
  for (std::size_t k = 0; k < one.rows.size(); k += 3) {
    for (Eigen::Index i = 0; i < kFeet; ++i) {
      const VectorX error = VectorX::Unit(kFeet + 2 * feet(), i), mirrored = Mirror(error);
      for (Eigen::Index f = 0; f < feet(); ++f) {
        const Vector6 wrench = one.rows[k].wrench_per_n[static_cast<std::size_t>(f)] * error;
        const Vector6 to = other.rows[k].wrench_per_n[static_cast<std::size_t>(f ^ 1)] * mirrored;
        ASSERT_LT((MirrorOf(wrench) - to).norm(), 1e-8 * (1.0 + wrench.norm())) << k << " " << i;
        const Vector2 step = one.rows[k].steps.middleRows<2>(2 * f) * error;
        const Vector2 put = other.rows[k].steps.middleRows<2>(2 * (f ^ 1)) * mirrored;
        ASSERT_LT((Vector2(step.x(), -step.y()) - put).norm(), 1e-8 * (1.0 + step.norm())) << k << " " << i;
        steps = std::max(steps, step.norm());
        moments = std::max(moments, wrench.tail<3>().norm());
      }
    }
  }
  EXPECT_GT(steps, 0.1);
  EXPECT_EQ(moments > 1e-3, feet() == 2) << "a point has no moment";
}

INSTANTIATE_TEST_SUITE_P(Feet, MirroredHops, ::testing::Values(2, 4));

TEST(MomentumGains, AShiftOfAllIsMetByAShiftOfTheSteps) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  // The error against the plan's place does not count here: a foothold is judged relative to the body.
  const MomentumErrors anywhere{1e6, 0.2, 0.1, 0.5, 0.06};
  const MomentumGains gains = DeriveMomentumGains(model, synthetic::HoppingPlan(model), anywhere);
  VectorX shifted = VectorX::Zero(kFeet + 8);
  shifted.head<2>() << 0.3, -0.2;
  for (Eigen::Index f = 0; f < 4; ++f) shifted.segment<2>(kFeet + 2 * f) << 0.3, -0.2;
  const MomentumGains::Row& row = gains.At(0.55);  // all feet stand, about to leave for the first hop
  for (Eigen::Index f = 0; f < 4; ++f) {
    EXPECT_LT((row.wrench_per_n[static_cast<std::size_t>(f)] * shifted).norm(), 1e-6);
    EXPECT_LT((row.steps.middleRows<2>(2 * f) * shifted - Vector2(0.3, -0.2)).norm(), 1e-6) << f;
  }
}

}  // namespace
}  // namespace gaitwright
