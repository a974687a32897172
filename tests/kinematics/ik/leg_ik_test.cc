// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_ik.h"

#include <cmath>
#include <random>

#include "kinematics/dynamics/dynamics.h"
#include "tests/kinematics/ik/synthetic_legs.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

using Method = LegIk::Method;

RobotModel MirrorSix() {  // two axes at the hip, three at the ankle
  return Made({{"0 0 0", "1 0 0"},
               {"0 0 0", "0 1 0"},
               {"0 0 -0.3", "0 1 0", "lower='-2' upper='2'"},
               {"0 0 -0.3", "0 1 0"},
               {"0 0 0", "1 0 0"},
               {"0 0 0", "0 0 1"}});
}
RobotModel RoundedSix() {  // axes rounded as in files: they meet only to a micrometre
  auto joints = SixJoints();
  joints[1].xyz = "0.000001 0 0.000002";
  joints[2].axis = "0.000002 1 0.000001";
  joints[5].xyz = "0 0 0.000001";
  return Made(joints);
}
RobotModel Seven() {
  auto joints = SixJoints();
  joints.insert(joints.begin() + 3, {"0 0 -0.1", "0 0 1"});
  return Made(joints);
}
RobotModel FiveLine() {
  auto joints = SixJoints();
  joints.pop_back();
  return Made(joints);
}
RobotModel ThreeOffset() {  // abduction axis apart from the pitch axis
  return Made(
      {{"0 0 0", "1 0 0"}, {"0.03 0.08 -0.05", "0 1 0"}, {"0.02 0.01 -0.2", "0 1 0", "lower='-2.5' upper='2.5'"}},
      kBallFoot);
}

RobotModel Named(const std::string& name) {
  if (name == "mirror_six") return MirrorSix();
  if (name == "rounded_six") return RoundedSix();
  if (name == "six") return Made(SixJoints());
  if (name == "seven") return Seven();
  if (name == "three_offset") return ThreeOffset();
  return Robot(name);
}

/// Seeded random positions within the limits of a leg.
class Places {
 public:
  Places(const RobotModel& model, const LegIk& ik) : model_(&model), dofs_(ik.dofs()) {}
  VectorX Next() {
    VectorX q(static_cast<Eigen::Index>(dofs_.size()));
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const int dof = dofs_[static_cast<std::size_t>(i)];
      std::uniform_real_distribution<double> within(model_->dof_lower(dof), model_->dof_upper(dof));
      q[i] = within(engine_);
    }
    return q;
  }
  void ExpectWithinLimits(const VectorX& q) const {
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const int dof = dofs_[static_cast<std::size_t>(i)];
      EXPECT_GE(q[i], model_->dof_lower(dof));
      EXPECT_LE(q[i], model_->dof_upper(dof));
    }
  }

 private:
  const RobotModel* model_;
  std::vector<int> dofs_;
  std::mt19937 engine_{3};
};

bool IsPlaced(const RobotModel& model, int leg) { return model.feet[static_cast<std::size_t>(leg)].sole_F.empty(); }

double PoseError(const Pose& a, const Pose& b, bool placed_only) {
  const double position = (a.translation() - b.translation()).norm();
  return placed_only ? position : std::max(position, RotationLog(a.linear().transpose() * b.linear()).norm());
}

/// X_BF by the kinematics of the whole body, which is independent of LegIk.
Pose WholeBodyFoot(const RobotModel& model, const LegIk& ik, int leg, const VectorX& joints) {
  VectorX q = StandingConfiguration(model);
  for (std::size_t i = 0; i < ik.dofs().size(); ++i) q[7 + ik.dofs()[i]] = joints[static_cast<Eigen::Index>(i)];
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const Foot& foot = model.feet[static_cast<std::size_t>(leg)];
  return FramePose(scratch, 0, Pose::Identity()).inverse() * FramePose(scratch, foot.body, foot.X_BF);
}

TEST(LegIk, MethodFollowsFromGeometry) {
  const auto method = [](const std::string& name) { return LegIk(Named(name), 0).method(); };
  EXPECT_EQ(method("a1"), Method::kThreeJoint);
  EXPECT_EQ(method("three_offset"), Method::kThreeJoint);
  EXPECT_EQ(method("nao"), Method::kSixJoint);
  EXPECT_EQ(method("six"), Method::kSixJoint);
  EXPECT_EQ(method("mirror_six"), Method::kSixJoint);
  EXPECT_EQ(method("rounded_six"), Method::kSixJoint);
  EXPECT_EQ(method("seven"), Method::kDamped);
  auto apart = SixJoints();
  apart[5].xyz = "0 0 -0.03";  // ankle axes that do not meet
  EXPECT_EQ(LegIk(Made(apart), 0).method(), Method::kDamped);
}

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, EveryPoseIsFoundAgain) {
  const RobotModel model = Named(GetParam());
  int same = 0, solved = 0;
  for (int leg = 0; leg < static_cast<int>(model.legs.size()); ++leg) {
    const LegIk ik(model, leg);
    Places places(model, ik);
    const bool placed = IsPlaced(model, leg);
    int missed = 0;
    for (int i = 0; i < 500; ++i) {
      const VectorX q = places.Next();
      const Pose X_BF = WholeBodyFoot(model, ik, leg, q);
      ASSERT_LT(PoseError(ik.FootPose(q), X_BF, false), 1e-13);
      for (const VectorX& guess : {VectorX(q), places.Next()}) {
        const Result<LegIk::Solution> found = ik.Solve(X_BF, guess);
        if (!found.ok() && ik.method() == Method::kDamped && guess != q) {
          ++missed;
          continue;
        }
        ASSERT_TRUE(found.ok()) << i << ": " << found.failure().message;
        EXPECT_LT(PoseError(ik.FootPose(found->joints), X_BF, placed), 1e-10);
        EXPECT_GE(found->branches, 1);
        places.ExpectWithinLimits(found->joints);
        if (guess == q) ++solved;
        if (guess == q && (found->joints - q).norm() < 1e-6) ++same;
      }
      EXPECT_EQ(ik.Gap(X_BF).kind, ReachGap::Kind::kNone);
    }
    EXPECT_LE(missed, 1);  // a damped search from anywhere may miss a pose in a corner of the limits
  }
  // Only a knee within 0.02 rad of straight may bend to the other side.
  EXPECT_GT(same, static_cast<int>(0.97 * solved));
}

INSTANTIATE_TEST_SUITE_P(Legs, RoundTrip,
                         testing::Values("a1", "nao", "three_offset", "six", "mirror_six", "rounded_six", "seven"));

TEST(LegIk, ClosedFormsNeedNoIterations) {
  for (const char* name : {"a1", "nao", "six"}) {
    const RobotModel model = Named(name);
    const LegIk ik(model, 0);
    Places places(model, ik);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(ik.Solve(ik.FootPose(places.Next()))->iterations, 0);
  }
  const RobotModel model = RoundedSix();
  EXPECT_GT(LegIk(model, 0).Solve(LegIk(model, 0).FootPose(VectorX::Constant(6, 0.3)))->iterations, 0);
}

TEST(LegIk, MirroredTargetsGiveMirroredJoints) {
  const RobotModel a1 = Robot("a1");
  const LegIk left(a1, 0), right(a1, 1);
  ASSERT_EQ(a1.legs[0].mirror, 1);
  const Vector3 signs(-1.0, 1.0, 1.0);
  Places places(a1, left);
  for (int i = 0; i < 200; ++i) {
    const VectorX guess = places.Next();
    const Pose X_BF = left.FootPose(places.Next());
    Pose mirrored = X_BF;
    mirrored.translation().y() *= -1.0;
    const VectorX a = left.Solve(X_BF, guess)->joints;
    const VectorX b = right.Solve(mirrored, signs.cwiseProduct(guess))->joints;
    EXPECT_LT((signs.cwiseProduct(b) - a).norm(), 1e-9);
  }
}

TEST(LegIk, StretchedLegsKeepTheirPose) {
  for (const char* name : {"nao", "six", "mirror_six", "three_offset"}) {
    const RobotModel model = Named(name);
    const LegIk ik(model, 0);
    const int knee = std::string(name) == "nao" || std::string(name) == "six" ? 3 : 2;
    VectorX q = VectorX::Constant(static_cast<Eigen::Index>(ik.dofs().size()), 0.1);
    for (const double bend : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, -1e-9, -1e-5}) {
      q[knee] = bend;
      const Pose X_BF = ik.FootPose(q);
      const Result<LegIk::Solution> found = ik.Solve(X_BF, q);
      ASSERT_TRUE(found.ok()) << name << " " << bend << ": " << found.failure().message;
      EXPECT_LT(PoseError(ik.FootPose(found->joints), X_BF, IsPlaced(model, 0)), 1e-10) << name << " " << bend;
    }
  }
}

TEST(LegIk, KneesBendAsTheGuessOrAsStanding) {
  const RobotModel model = Made(SixJoints());
  const LegIk ik(model, 0);
  VectorX q = ik.Solve(ik.FootPose(VectorX::Constant(6, 0.3)))->joints;
  const Pose X_BF = ik.FootPose(q);
  VectorX guess = VectorX::Zero(6);
  guess[3] = 0.5;
  EXPECT_GT(ik.Solve(X_BF, guess)->joints[3], 0.0);
  guess[3] = -0.5;
  EXPECT_LT(ik.Solve(X_BF, guess)->joints[3], 0.0);
  EXPECT_GT(ik.Solve(X_BF)->joints[3] * model.legs[0].knee_sign, 0.0);
}

double A1Radius() { return std::hypot(0.4, 0.0838); }  // thigh and shank 0.2 m, offset 0.0838 m

TEST(LegIk, GapIsTheDistanceToTheReachOfA1) {
  const RobotModel a1 = Robot("a1");
  const LegIk ik(a1, 0);
  const Vector3 hip(0.1805, 0.047, 0.0);
  RandomState random(5);
  Pose X_BF = Pose::Identity();
  for (int i = 0; i < 50; ++i) {
    Vector3 direction = random.Vector(3).normalized();
    if (direction.tail<2>().norm() < 0.3) continue;  // near the abduction axis the sphere has a hole
    X_BF.translation() = hip + (A1Radius() + 0.0123) * direction;
    const ReachGap gap = ik.Gap(X_BF);
    EXPECT_EQ(gap.kind, ReachGap::Kind::kTooFar);
    EXPECT_NEAR(gap.distance_m, 0.0123, 1e-9);
  }
  const auto failure = ik.Solve(X_BF).failure();
  EXPECT_EQ(failure.kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure.code, FailureCode::kOutOfReach);
  EXPECT_EQ(failure.message, "foot 'FL_foot' cannot reach its target: it is too far from the hip by 12.3 mm");
}

TEST(LegIk, GapIsTheDistanceToTheAbductionAxis) {
  const LegIk ik(Robot("a1"), 0);
  Pose X_BF = Pose::Identity();
  X_BF.translation() = Vector3(0.1805 + 0.2, 0.047, -0.05);
  const ReachGap gap = ik.Gap(X_BF);
  EXPECT_EQ(gap.kind, ReachGap::Kind::kTooNearAxis);
  EXPECT_NEAR(gap.distance_m, 0.0838 - 0.05, 1e-9);
  EXPECT_EQ(ik.Solve(X_BF).failure().message,
            "foot 'FL_foot' cannot reach its target: it is too near the axis of joint 'FL_hip_joint' by 33.8 mm");
}

TEST(LegIk, GapIsTheDistanceToTheReachOfABiped) {
  const double thigh = std::hypot(0.3, 0.01), far = thigh + 0.3;
  const RobotModel model = Made(SixJoints());
  for (int leg = 0; leg < 2; ++leg) {
    const LegIk ik(model, leg);
    VectorX q = VectorX::Zero(6);
    q[3] = -std::atan2(0.01, 0.3);  // straight
    Pose X_BF = ik.FootPose(q);
    ASSERT_TRUE(ik.Solve(X_BF).ok());
    const Vector3 hip(0.0, leg == 0 ? 0.1 : -0.1, 0.0);
    const Vector3 foot_from_ankle = Vector3(0.02, 0.0, -0.05);
    const Vector3 ankle = X_BF * Vector3(-foot_from_ankle) - hip;
    ASSERT_NEAR(ankle.norm(), std::hypot(far, 0.005), 1e-12);
    X_BF.translation() += 0.02 * ankle.normalized();
    EXPECT_EQ(ik.Gap(X_BF).kind, ReachGap::Kind::kTooFar);
    EXPECT_NEAR(ik.Gap(X_BF).distance_m, 0.02, 1e-9);
    EXPECT_NE(ik.Solve(X_BF).failure().message.find("too far from the hip by 20.0 mm"), std::string::npos);
    X_BF.translation() -= (0.02 + ankle.norm() - 0.001) * ankle.normalized();
    EXPECT_EQ(ik.Gap(X_BF).kind, ReachGap::Kind::kTooNear);
    EXPECT_NEAR(ik.Gap(X_BF).distance_m, std::hypot(thigh - 0.3, 0.005) - 0.001, 1e-9);
  }
}

/// With the ankle 0.1 m beside the hip, the roll axis of the foot cannot pass nearer to the hip than that.
TEST(LegIk, GapIsTheAngleThatAnAnkleLacks) {
  auto joints = SixJoints();
  joints[3].xyz = "0 0.1 -0.3";
  const LegIk ik(Made(joints), 0);
  ASSERT_EQ(ik.method(), Method::kSixJoint);
  const Pose X_BF_near = ik.FootPose(VectorX::Constant(6, 0.2));
  const Vector3 p_FA(-0.02, 0.0, 0.05), p_BH(0.0, 0.1, 0.0);
  const Vector3 hip = p_BH - X_BF_near * p_FA;
  const double least = std::asin(0.1 / hip.norm());
  for (const double angle : {0.01, 0.05, 0.1}) {
    ASSERT_LT(angle, least);
    const Vector3 perpendicular = hip.unitOrthogonal();
    Pose X_BF;
    X_BF.linear() =
        Quaternion::FromTwoVectors(Vector3::UnitX(), RotationExp(angle * perpendicular) * hip).toRotationMatrix();
    X_BF.translation() = p_BH - hip - X_BF.linear() * p_FA;
    const ReachGap gap = ik.Gap(X_BF);
    EXPECT_EQ(gap.kind, ReachGap::Kind::kTurned);
    EXPECT_NEAR(gap.angle_rad, least - angle, 1e-9);
    EXPECT_NE(ik.Solve(X_BF).failure().message.find("deg farther than the leg allows"), std::string::npos);
  }
}

TEST(LegIk, ALimitIsNamedWithItsJoint) {
  const RobotModel a1 = Robot("a1");
  for (const Method method : {Method::kThreeJoint, Method::kDamped}) {
    const LegIk ik(a1, 0, method);
    const Pose X_BF = ik.FootPose(Vector3(0.0, 0.4, -0.5));  // nearly straight; the calf stops at -0.916
    const Result<LegIk::Solution> found = ik.Solve(X_BF);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.failure().code, FailureCode::kJointLimit);
    const std::string reaches = method == Method::kDamped ? "was found to reach" : "reaches";
    EXPECT_EQ(found.failure().message,
              "foot 'FL_foot' " + reaches +
                  " its target only with joint 'FL_calf_joint' at -0.500 rad, beyond its limit of -0.916");
  }
}

TEST(LegIk, DampedAgreesWithTheClosedForms) {
  for (const char* name : {"a1", "nao", "six"}) {
    const RobotModel model = Named(name);
    const LegIk closed(model, 0), damped(model, 0, Method::kDamped);
    Places places(model, closed);
    for (int i = 0; i < 200; ++i) {
      const VectorX q = places.Next();
      const Pose X_BF = closed.FootPose(q);
      const VectorX near = q + 0.02 * (places.Next() - q);
      const Result<LegIk::Solution> a = closed.Solve(X_BF, near), b = damped.Solve(X_BF, near);
      ASSERT_TRUE(a.ok() && b.ok()) << name << " " << i;
      EXPECT_GT(b->iterations, 0);
      EXPECT_LT(PoseError(closed.FootPose(a->joints), closed.FootPose(b->joints), IsPlaced(model, 0)), 1e-10);
      if (std::abs(q[q.size() == 3 ? 2 : 3]) < 0.2) continue;  // nearly straight: either bend may be nearer
      EXPECT_LT((a->joints - b->joints).norm(), 1e-6) << name << " " << i;
    }
  }
}

TEST(LegIk, DampedSaysWhatIsMissing) {
  const LegIk ik(Robot("a1"), 0, Method::kDamped);
  Pose X_BF = Pose::Identity();
  X_BF.translation() = Vector3(0.1805, 0.047 + 0.0838, -0.42);
  const double beyond = std::hypot(0.42, 0.0838) - A1Radius();
  EXPECT_NEAR(ik.Gap(X_BF).distance_m, beyond, 1e-6);
  EXPECT_EQ(ik.Solve(X_BF).failure().code, FailureCode::kOutOfReach);
  EXPECT_NE(ik.Solve(X_BF).failure().message.find("too far from the hip by 19.6 mm"), std::string::npos);
}

TEST(LegIk, ALineFootYieldsItsRoll) {
  const RobotModel model = FiveLine();
  ASSERT_EQ(model.feet[0].type, FootType::kLine);
  const LegIk ik(model, 0);
  ASSERT_EQ(ik.method(), Method::kDamped);
  VectorX q(5);
  q << 0.1, -0.15, -0.3, 0.7, -0.4;
  Pose X_BF = ik.FootPose(q);
  X_BF.linear() = (X_BF.linear() * RotationExp(Vector3(0.2, 0.0, 0.0))).eval();
  const Result<LegIk::Solution> found = ik.Solve(X_BF);
  ASSERT_TRUE(found.ok()) << found.failure().message;
  const Pose reached = ik.FootPose(found->joints);
  EXPECT_LT((reached.translation() - X_BF.translation()).norm(), 1e-10);
  EXPECT_LT((reached.linear().col(0) - X_BF.linear().col(0)).norm(), 1e-10);
  EXPECT_NEAR(std::abs(RotationLog(reached.linear().transpose() * X_BF.linear()).x()), 0.2, 0.05);
}

TEST(LegIk, SharedMotorsAreListedAndKeepTheirLimits) {
  const RobotModel nao = Robot("nao"), a1 = Robot("a1");
  EXPECT_TRUE(LegIk(a1, 0).shared_dofs().empty());
  for (int leg = 0; leg < 2; ++leg) {
    const LegIk ik(nao, leg);
    ASSERT_EQ(ik.shared_dofs().size(), 1U);
    EXPECT_EQ(nao.dof_names[static_cast<std::size_t>(ik.shared_dofs()[0])], "LHipYawPitch");
    EXPECT_EQ(ik.dofs()[0], ik.shared_dofs()[0]);
  }
}

TEST(LegIk, FollowersKeepTheirMultiplierAndOffset) {
  auto joints = SixJoints();
  joints[4].extra = "<mimic joint='j_SIDE3' multiplier='-0.5' offset='0.1'/>";
  const RobotModel inside = Made(joints);  // the ankle follows the knee of its own leg
  const LegIk ik(inside, 0);
  EXPECT_EQ(ik.method(), Method::kDamped);
  ASSERT_EQ(ik.dofs().size(), 5U);
  Places places(inside, ik);
  for (int i = 0; i < 50; ++i) {
    const VectorX q = places.Next();
    ASSERT_LT(PoseError(ik.FootPose(q), WholeBodyFoot(inside, ik, 0, q), false), 1e-13);
  }
  auto across = SixJoints();
  across[0].extra = "<mimic joint='j_SIDE1' multiplier='-0.5' offset='0.1'/>";
  EXPECT_THROW(LegIk(Made(across), 0, Method::kSixJoint), InvalidArgument);
}

TEST(LegIk, WhatACallerCanGetWrongIsRefused) {
  const RobotModel a1 = Robot("a1");
  EXPECT_THROW(LegIk(a1, 4), InvalidArgument);
  EXPECT_THROW(LegIk(a1, -1), InvalidArgument);
  EXPECT_THROW(LegIk(a1, 0, Method::kSixJoint), InvalidArgument);
  const LegIk ik(a1, 0);
  Pose X_BF = Pose::Identity();
  EXPECT_THROW((void)ik.Solve(X_BF, VectorX::Zero(12)), InvalidArgument);
  X_BF.translation().x() = std::nan("");
  EXPECT_THROW((void)ik.Solve(X_BF), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
