// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/refine_swing.h"

#include <gtest/gtest.h>

#include <limits>

#include "kinematics/base/non_finite.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// A box across the path, from one place to another, with a height.
struct BoxAcross {
  double from_m, to_m, height_m;
};

GroundHeight Ground(const std::vector<BoxAcross>& boxes, double low_m = 0.0) {
  return [boxes, low_m](const Vector2& p) {
    double height = low_m;
    for (const BoxAcross& box : boxes) {
      if (p.x() > box.from_m && p.x() < box.to_m) height = std::max(height, box.height_m);
    }
    return height;
  };
}

Foot Sole() {
  Foot foot;
  foot.type = FootType::kSole;
  foot.sole_F = {{-0.08, -0.04}, {0.08, -0.04}, {0.08, 0.04}, {-0.08, 0.04}};
  return foot;
}

SwingCurve Straight(double length_m, double rise_m) {
  SwingCurve curve{1.0, 1.6, Pose::Identity(), Pose::Identity(), 0.05};
  curve.X_WF_end.translation() = Vector3(length_m, 0.0, rise_m);
  return curve;
}

struct Scene {
  const char* name;
  SwingCurve swing;
  std::vector<BoxAcross> boxes;
  double low_m = 0.0;  // the ground beside the boxes
};

std::vector<Scene> Scenes() {
  return {{"flat", Straight(0.4, 0.0), {}},
          {"onto a block of 0.2 m", Straight(0.4, 0.2), {{0.2, 9.0, 0.2}}},
          {"down from a block of 0.2 m", Straight(0.4, -0.2), {{-9.0, 0.2, 0.0}}, -0.2},
          {"over a wall of 0.15 m", Straight(0.5, 0.0), {{0.2, 0.3, 0.15}}},
          {"over a wall of 0.3 m", Straight(0.5, 0.0), {{0.2, 0.3, 0.3}}},
          {"up two stairs of 0.12 m", Straight(0.6, 0.24), {{0.15, 0.45, 0.12}, {0.45, 9.0, 0.24}}}};
}

double SquaredAcceleration(const SwingCurve& curve) {
  constexpr int kSamples = 400;
  double sum = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = curve.start_s + (curve.end_s - curve.start_s) * k / kSamples;
    sum += Evaluate(curve, t).a_WF.squaredNorm() * (curve.end_s - curve.start_s) / kSamples;
  }
  return sum;
}

double SquaredJerk(const SwingCurve& curve) {
  constexpr int kSamples = 400;
  const double step = (curve.end_s - curve.start_s) / kSamples;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double t = curve.start_s + k * step;
    sum += (Evaluate(curve, t + step).a_WF - Evaluate(curve, t).a_WF).squaredNorm() / step;
  }
  return sum;
}

double HighestOf(const SwingCurve& curve) {
  double highest = 0.0;
  for (double t = curve.start_s; t <= curve.end_s; t += 0.01)
    highest = std::max(highest, Evaluate(curve, t).X_WF.translation().z());
  return highest;
}

TEST(RefineSwing, ClearsEveryScene) {
  const auto underside = UndersideOf(Sole());
  for (const Scene& scene : Scenes()) {
    const GroundHeight ground = Ground(scene.boxes, scene.low_m);
    for (const int control_points : {10, 12, 14}) {
      const RefineChoice choice{0.04, control_points, 30};
      const Result<RefinedSwing> refined = RefineSwing(scene.swing, underside, ground, choice);
      ASSERT_TRUE(refined.ok()) << scene.name << ": " << refined.failure().message;
      EXPECT_GT(refined->margin_m, -0.0021) << scene.name;
      EXPECT_EQ(refined->curve.detour_W.size(), static_cast<std::size_t>(control_points - 6));
      for (const double t : {1.0, 1.6}) {
        const FrameMotion end = Evaluate(refined->curve, t);
        EXPECT_LT(end.v_WF.norm() + end.a_WF.norm(), 1e-9) << scene.name;
      }
      EXPECT_TRUE(Evaluate(refined->curve, 1.6).X_WF.isApprox(scene.swing.X_WF_end, 1e-12));
    }
  }
}

TEST(RefineSwing, NeedsLessJerkThanALiftThatClears) {
  const auto underside = UndersideOf(Sole());
  for (const Scene& scene : Scenes()) {
    const GroundHeight ground = Ground(scene.boxes, scene.low_m);
    const RefineChoice choice{0.04, 12, 30};
    SwingCurve raised = scene.swing;
    while (ClearanceMargin(raised, underside, ground, choice.clearance_m) < 0.0 && raised.lift_m < 3.0) {
      raised.lift_m += 0.01;
    }
    const Result<RefinedSwing> refined = RefineSwing(scene.swing, underside, ground, choice);
    ASSERT_TRUE(refined.ok()) << scene.name << ": " << refined.failure().message;
    // The sides of a wall are replaced by slopes, which needs slightly more than a plain lift.
    const double most = std::string(scene.name).find("wall") == std::string::npos ? 1.0 : 1.25;
    EXPECT_LT(SquaredJerk(refined->curve), most * SquaredJerk(raised)) << scene.name;
    RecordProperty(std::string("refined ") + scene.name, std::to_string(SquaredJerk(refined->curve)));
    RecordProperty(std::string("raised ") + scene.name, std::to_string(SquaredJerk(raised)));
  }
}

TEST(RefineSwing, GoesStraightWhereThereIsNoGround) {
  const auto nothing = [](const Vector2&) { return -kInfinity; };
  const SwingCurve swing = Straight(0.4, 0.0);
  const Result<RefinedSwing> refined = RefineSwing(swing, UndersideOf(Sole()), nothing, {});
  ASSERT_TRUE(refined.ok()) << refined.failure().message;
  SwingCurve flat = swing;
  flat.lift_m = 0.0;
  for (double t = 1.0; t <= 1.6; t += 0.05) {
    EXPECT_NEAR(Evaluate(refined->curve, t).X_WF.translation().z(), 0.0, 1e-6);
    EXPECT_NEAR(Evaluate(refined->curve, t).X_WF.translation().y(), 0.0, 1e-12);
  }
  // Minimum jerk is not minimum acceleration: a small improvement is possible.
  EXPECT_LT(SquaredAcceleration(refined->curve), SquaredAcceleration(flat));
  EXPECT_GT(SquaredAcceleration(refined->curve), 0.7 * SquaredAcceleration(flat));
}

TEST(RefineSwing, RisesInFrontOfARiserHoweverNearTheToeStands) {
  for (double gap_m = 0.003; gap_m < 0.05; gap_m += 0.0025) {
    const Result<RefinedSwing> refined =
        RefineSwing(Straight(0.15, 0.02), UndersideOf(Sole()), Ground({{0.08 + gap_m, 9.0, 0.02}}), {0.0075, 12, 30});
    ASSERT_TRUE(refined.ok()) << gap_m << ": " << refined.failure().message;
    EXPECT_LT(HighestOf(refined->curve), 0.06) << gap_m;
  }
}

TEST(RefineSwing, IsTheSameInAnyDirection) {
  const auto underside = UndersideOf(Sole());
  const Pose X_WN = Pose(Eigen::Translation3d(3.0, -2.0, 0.5)) * Pose(YawRotation(2.1));
  const GroundHeight ground = Ground({{0.141, 0.241, 0.15}});  // nearer to the start, and not on the edge of a cell
  const GroundHeight moved = [&](const Vector2& p_W) {
    const Vector3 p_N = X_WN.inverse() * Vector3(p_W.x(), p_W.y(), 0.0);
    return ground(p_N.head<2>()) + 0.5;
  };
  const SwingCurve swing = Straight(0.5, 0.0);
  SwingCurve turned = swing;
  turned.X_WF_start = X_WN * swing.X_WF_start;
  turned.X_WF_end = X_WN * swing.X_WF_end;
  const Result<RefinedSwing> here = RefineSwing(swing, underside, ground, {}),
                             there = RefineSwing(turned, underside, moved, {});
  ASSERT_TRUE(here.ok() && there.ok());
  for (double t = 1.0; t <= 1.6; t += 0.05) {
    const Vector3 expected = X_WN * Evaluate(here->curve, t).X_WF.translation();
    EXPECT_LT((Evaluate(there->curve, t).X_WF.translation() - expected).norm(), 1e-3);
  }
}

TEST(RefineSwing, ATouchingEdgeIsRefusedWithTheLack) {
  // The toe is under the block that begins in front of it: no swing is clear of that.
  const Result<RefinedSwing> refined =
      RefineSwing(Straight(0.4, 0.3), UndersideOf(Sole()), Ground({{0.07, 9.0, 0.3}}), {});
  ASSERT_FALSE(refined.ok());
  EXPECT_EQ(refined.failure().code, FailureCode::kNoClearance);
  EXPECT_NE(refined.failure().message.find(" mm"), std::string::npos);
}

TEST(RefineSwing, RefusesNumbersOutsideTheirRange) {
  const auto flat = Ground({});
  EXPECT_THROW((void)RefineSwing(Straight(0.4, 0.0), UndersideOf(Sole()), flat, {0.02, 8, 30}), InvalidArgument);
  EXPECT_THROW((void)RefineSwing(Straight(0.4, 0.0), UndersideOf(Sole()), flat, {0.02, 12, 50}), InvalidArgument);
}

TEST(ClearanceMargin, IsKnownForABumpOnFlatGround) {
  SwingCurve swing = Straight(0.3, 0.0);
  swing.lift_m = 0.08;
  // The height in mid swing is 80 mm; 20 mm are required. The smallest margin is near the ends, where both are zero and
  // half a millimetre less is required.
  EXPECT_LT(ClearanceMargin(swing, {Vector3::Zero()}, Ground({}), 0.02), 5e-4);
  EXPECT_GT(ClearanceMargin(swing, {Vector3::Zero()}, Ground({}), 0.02), 0.0);
  // If far more is required than the height, the smallest margin is at the end of the ramp, 35 % into the swing.
  const double least = 0.08 * 64.0 * std::pow(0.35 * 0.65, 3) - 2.0;
  EXPECT_NEAR(ClearanceMargin(swing, {Vector3::Zero()}, Ground({}), 2.0), least, 5e-3);
}

TEST(ClearanceRamp, RisesSlowerThanAFootAtRest) {
  EXPECT_EQ(ClearanceRamp(0.0), 0.0);
  EXPECT_EQ(ClearanceRamp(0.5), 1.0);
  EXPECT_EQ(ClearanceRamp(1.0), 0.0);
  for (double u = 0.0; u <= 0.5; u += 0.05) EXPECT_NEAR(ClearanceRamp(u), ClearanceRamp(1.0 - u), 1e-12);
  for (double u = 0.01; u < 1.0; u += 0.01) EXPECT_LT(0.25 * ClearanceRamp(u), SmoothBump(u).value + 1e-12) << u;
}

TEST(UndersideOf, SolesAreCoveredAndSpheresAreRound) {
  const auto sole = UndersideOf(Sole());
  EXPECT_EQ(sole.size(), 33U);
  for (const Vector3& p : sole) EXPECT_EQ(p.z(), 0.0);
  Foot ball;
  ball.type = FootType::kPoint;
  ball.radius = 0.02;
  for (const Vector3& p : UndersideOf(ball)) EXPECT_NEAR((p - Vector3(0.0, 0.0, 0.02)).norm(), 0.02, 1e-12);
}

}  // namespace
}  // namespace gaitwright
