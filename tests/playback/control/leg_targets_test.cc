// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/leg_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "tests/kinematics/ik/synthetic_legs.h"
#include "tests/kinematics/random_state.h"
#include "tests/playback/displaced.h"
#include "tests/playback/short_walk.h"

namespace gaitwright {
namespace {

constexpr double kMargin = 0.03;  // of targets to a joint's limit [rad]

/// Pose and velocity of a foot's controlled frame.
FootMotion MotionOf(const RobotModel& model, int foot, const VectorX& q, const VectorX& v) {
  DynamicsScratch scratch(model);
  ForwardVelocities(model, q, v, scratch);
  const Foot& f = model.feet[static_cast<std::size_t>(foot)];
  return {FramePose(scratch, f.body, f.X_BF), PointVelocity(scratch, f.body, f.X_BF.translation()), Vector3::Zero()};
}

/// Linear, then angular, about the contact point.
Vector6 ContactVelocity(const RobotModel& model, int foot, const VectorX& q, const VectorX& v) {
  DynamicsScratch scratch(model);
  ForwardVelocities(model, q, v, scratch);
  const auto body = static_cast<std::size_t>(model.feet[static_cast<std::size_t>(foot)].body);
  const Vector3 p_WQ = ContactFrame(model, scratch, foot).translation();
  return PointVelocity(scratch, static_cast<int>(body), scratch.R_WB[body].transpose() * (p_WQ - scratch.p_WB[body]));
}

/// Targets keep a margin from the limits, or the plan's distance if that is smaller.
void ExpectWithinLimits(const RobotModel& model, const VectorX& q_planned, const VectorX& q) {
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    EXPECT_GE(q[7 + dof], std::min(model.dof_lower(dof) + kMargin, q_planned[7 + dof]) - 1e-12) << dof;
    EXPECT_LE(q[7 + dof], std::max(model.dof_upper(dof) - kMargin, q_planned[7 + dof]) + 1e-12) << dof;
  }
}

class LegTargetsTest : public ::testing::TestWithParam<const char*> {
 protected:
  bool standing_quadruped() const { return model_.legs.size() == 4; }
  MotionPlan Walk() const {
    return standing_quadruped() ? ShortWalk(model_, "trot", 6, 0.05) : ShortWalk(model_, "", 4, 0.04);
  }

  const RobotModel model_ = Robot(GetParam());
  const VectorX standing_ = StandingConfiguration(model_), rest_ = VectorX::Zero(model_.nv());
  LegTargets legs_{model_};
};

TEST_P(LegTargetsTest, WantedAsPlannedAndMeasuredAsPlannedAreThePlansJoints) {
  const MotionPlan plan = Walk();
  WholeBodySample sample;
  double fastest = 0.0;
  for (double t = 0.0; t < plan.whole_body.end_s(); t += 0.037) {
    SampleWholeBody(plan.whole_body, t, sample);
    for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
      VectorX q = sample.q, v = sample.v;
      legs_.Solve(leg, MotionOf(model_, leg, sample.q, sample.v), sample.q, q, v);
      EXPECT_LT((q - sample.q).lpNorm<Eigen::Infinity>(), 1e-12) << t;
      EXPECT_LT((v - sample.v).lpNorm<Eigen::Infinity>(), 2e-3) << t;
      fastest = std::max(fastest, sample.v.lpNorm<Eigen::Infinity>());
    }
  }
  EXPECT_GT(fastest, 0.5);
}

TEST_P(LegTargetsTest, AFootMovedByACentimetreIsReachedWithItsSoleLevel) {
  for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
    const FootMotion stands = MotionOf(model_, leg, standing_, rest_);
    for (int axis = 0; axis < 6; ++axis) {
      FootMotion wanted = stands;
      wanted.X_WF.translation()[axis % 3] += axis < 3 ? 0.01 : -0.01;
      VectorX q = standing_, v = rest_;
      legs_.Solve(leg, wanted, standing_, q, v);
      const Pose X_WF = MotionOf(model_, leg, q, v).X_WF;
      EXPECT_LT((X_WF.translation() - wanted.X_WF.translation()).norm(), 2e-5) << leg << " along " << axis;
      if (!model_.feet[static_cast<std::size_t>(leg)].sole_F.empty()) {
        EXPECT_GT(X_WF.linear()(2, 2), std::cos(2e-3)) << leg << " along " << axis;
      }
      ExpectWithinLimits(model_, standing_, q);
    }
  }
}

TEST_P(LegTargetsTest, TheBaseIsWhereItIsAndOnlyTheLegsOwnJointsMove) {
  const MotionPlan plan = Walk();
  const VectorX q0 = plan.whole_body.q.front();
  const VectorX measured = CarriedState(Pose(RotationExp({0.05, -0.03, 0.1})), q0);
  for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
    const FootMotion wanted = MotionOf(model_, leg, q0, rest_);
    VectorX q = measured, v = rest_;
    legs_.Solve(leg, wanted, q0, q, v);
    const Vector3 error = MotionOf(model_, leg, q, v).X_WF.translation() - wanted.X_WF.translation();
    EXPECT_GT((MotionOf(model_, leg, measured, v).X_WF.translation() - wanted.X_WF.translation()).norm(), 0.005);
    EXPECT_LT(error.norm(), 1e-4) << leg;
    const std::vector<int>& own = legs_.dofs(leg);
    EXPECT_EQ(q.head<7>(), measured.head<7>());
    for (int dof = 0; dof < model_.num_dofs(); ++dof) {
      if (std::find(own.begin(), own.end(), dof) == own.end()) {
        EXPECT_EQ(q[7 + dof], measured[7 + dof]);
      }
    }
  }
}

TEST_P(LegTargetsTest, FarTargetsStopInsideOfTheLimits) {
  RandomState random(5);
  int at_margin = 0;
  for (int trial = 0; trial < 100; ++trial) {
    for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
      FootMotion wanted = MotionOf(model_, leg, standing_, rest_);
      wanted.X_WF.translation() += random.Vector(3);
      VectorX q = standing_, v = rest_;
      legs_.Solve(leg, wanted, standing_, q, v);
      ASSERT_TRUE(q.allFinite());
      ExpectWithinLimits(model_, standing_, q);
      for (const int dof : legs_.dofs(leg)) {
        at_margin += static_cast<int>(std::abs(q[7 + dof] - model_.dof_lower(dof) - kMargin) < 1e-9);
        at_margin += static_cast<int>(std::abs(q[7 + dof] - model_.dof_upper(dof) + kMargin) < 1e-9);
      }
    }
  }
  EXPECT_GT(at_margin, 100);
}

TEST_P(LegTargetsTest, RatesStayWithinTheirLimits) {
  RandomState random(6);
  int at_limit = 0;
  for (int trial = 0; trial < 50; ++trial) {
    FootMotion wanted = MotionOf(model_, 0, standing_, rest_);
    wanted.v_WF = 20.0 * random.Vector(6);
    VectorX q = standing_, v = rest_;
    legs_.Solve(0, wanted, standing_, q, v);
    for (const int dof : legs_.dofs(0)) {
      EXPECT_LE(std::abs(v[6 + dof]), model_.dof_velocity_limit(dof));
      at_limit += static_cast<int>(std::abs(v[6 + dof]) == model_.dof_velocity_limit(dof));
    }
  }
  EXPECT_GT(at_limit, 50);
}

TEST_P(LegTargetsTest, HeldFeetStandStillUnderAMovingBase) {
  RandomState random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const VectorX start = 0.1 * random.Vector(model_.nv());
    for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
      VectorX v = start;
      EXPECT_GT(ContactVelocity(model_, leg, standing_, v).head<3>().norm(), 1e-3);
      legs_.Hold(leg, Vector3::UnitZ(), 0.0, standing_, v);
      const Vector6 held = ContactVelocity(model_, leg, standing_, v);
      EXPECT_LT(held.head<3>().norm(), 2e-3 * start.norm());
      if (!standing_quadruped()) {
        EXPECT_LT(held.segment<2>(3).norm(), 0.05 * start.norm()) << "yaw yields, not roll and pitch";
      }
      EXPECT_EQ(v.head<6>(), start.head<6>());
    }
  }
}

TEST_P(LegTargetsTest, HeldFeetMayCreepInTheDirectionTheyMove) {
  RandomState random(8);
  for (const double creep : {0.01, 1.0}) {
    for (int trial = 0; trial < 20; ++trial) {
      const VectorX start = 0.1 * random.Vector(model_.nv());
      for (int leg = 0; leg < static_cast<int>(model_.legs.size()); ++leg) {
        VectorX v = start;
        const Vector3 before = ContactVelocity(model_, leg, standing_, v).head<3>();
        legs_.Hold(leg, Vector3::UnitZ(), creep, standing_, v);
        const Vector3 after = ContactVelocity(model_, leg, standing_, v).head<3>();
        if (creep > 0.5) {
          EXPECT_LT((after - before).norm(), 2e-3 * start.norm()) << "slow enough to be left as it is";
        } else {
          EXPECT_LT(after.norm(), creep + 2e-3 * start.norm());
          EXPECT_LT(after.cross(before.normalized()).norm(), 2e-3 * start.norm()) << "not turned aside";
        }
      }
    }
  }
}

TEST_P(LegTargetsTest, ExtraTorqueAcceleratesTheFootAsWanted) {
  DynamicsScratch scratch(model_);
  MatrixX M, J(6, model_.nv());
  MassMatrix(model_, standing_, scratch, M);
  const std::vector<int>& own = legs_.dofs(0);
  const auto n = static_cast<Eigen::Index>(own.size());
  MatrixX M_own(n, n), J_own(6, n);
  const Foot& foot = model_.feet[0];
  PointJacobian(model_, scratch, foot.body, foot.X_BF.translation(), J);
  for (Eigen::Index i = 0; i < n; ++i) {
    J_own.col(i) = J.col(6 + own[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < n; ++j)
      M_own(i, j) = M(6 + own[static_cast<std::size_t>(i)], 6 + own[static_cast<std::size_t>(j)]);
  }
  FootMotion wanted = MotionOf(model_, 0, standing_, rest_);
  wanted.a_extra_WF = {3.0, -2.0, 5.0};
  VectorX q = standing_, v = rest_;
  legs_.Solve(0, wanted, standing_, q, v);
  const VectorX a = J_own * M_own.colPivHouseholderQr().solve(legs_.ExtraTorque(0, wanted, M));
  EXPECT_LT((a.head<3>() - wanted.a_extra_WF).norm(), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Robots, LegTargetsTest, ::testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

TEST(LegTargets, AMotorThatLegsShareIsNobodys) {
  const RobotModel nao = Robot("nao");
  const LegTargets legs(nao);
  const int shared = nao.DofIndex("LHipYawPitch");
  for (int leg = 0; leg < 2; ++leg) {
    EXPECT_EQ(legs.dofs(leg).size(), 5U);
    EXPECT_EQ(std::count(legs.dofs(leg).begin(), legs.dofs(leg).end(), shared), 0);
  }
  const LegTargets own(Robot("a1"));
  EXPECT_EQ(own.dofs(0).size(), 3U);
}

TEST(LegTargets, YawYieldsBeforePlaceRollAndPitch) {
  const RobotModel nao = Robot("nao");
  const VectorX standing = StandingConfiguration(nao), rest = VectorX::Zero(nao.nv());
  LegTargets legs(nao);
  FootMotion wanted = MotionOf(nao, 0, standing, rest);
  wanted.X_WF.linear() = YawRotation(0.2) * wanted.X_WF.linear();
  VectorX q = standing, v = rest;
  legs.Solve(0, wanted, standing, q, v);
  const Pose X_WF = MotionOf(nao, 0, q, v).X_WF;
  const Vector3 turn = RotationLog(wanted.X_WF.linear() * X_WF.linear().transpose());
  EXPECT_LT((X_WF.translation() - wanted.X_WF.translation()).norm(), 1e-4);
  EXPECT_LT(turn.head<2>().norm(), 2e-3);
  EXPECT_GT(turn.z(), 0.1) << "the motor for it is shared";
}

TEST(LegTargets, AKneeUnreachedStretchesToItsMargin) {
  const RobotModel a1 = Robot("a1");
  const VectorX standing = StandingConfiguration(a1), rest = VectorX::Zero(a1.nv());
  LegTargets legs(a1);
  FootMotion wanted = MotionOf(a1, 0, standing, rest);
  wanted.X_WF.translation().z() -= 0.3;
  VectorX q = standing, v = rest;
  for (int k = 0; k < 5; ++k) legs.Solve(0, wanted, standing, q, v);
  const int knee = a1.DofIndex("FL_calf_joint");
  EXPECT_NEAR(q[7 + knee], a1.dof_upper(knee) - kMargin, 1e-9);
  const Vector3 p_WF = MotionOf(a1, 0, q, v).X_WF.translation();
  EXPECT_LT(p_WF.z(), MotionOf(a1, 0, standing, rest).X_WF.translation().z() - 0.02) << "on towards the target";
  wanted.v_WF.z() = -1.0;
  legs.Solve(0, wanted, standing, q, v);
  EXPECT_EQ(v[6 + knee], 0.0) << "nor is it driven on";

  VectorX planned = standing;
  planned[7 + knee] = a1.dof_upper(knee) - 0.01;
  q = planned;
  for (int k = 0; k < 5; ++k) legs.Solve(0, wanted, planned, q, v);
  EXPECT_NEAR(q[7 + knee], planned[7 + knee], 1e-9) << "as near to the limit as the plan goes";
}

/// Hip roll, hip pitch, a knee, and an ankle geared to the knee with factor -0.5.
RobotModel Geared() {
  const std::string gear = "<mimic joint='j_SIDE2' multiplier='-0.5' offset='0.1'/>";
  const std::string urdf =
      SyntheticUrdf({{"0 0.1 0", "1 0 0"},
                     {"0 0 0", "0 1 0"},
                     {"0 0 -0.3", "0 1 0", "lower='-0.1' upper='2.0'"},
                     {"0 0 -0.3", "0 1 0", "lower='-0.5' upper='0.3'", gear}},
                    "<collision><origin xyz='0 0 -0.04'/><geometry><sphere radius='0.02'/></geometry></collision>");
  const Result<RobotModel> model = LoadRobotFromText(urdf, "", "geared");
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return *model;
}

TEST(LegTargets, GearsInsideALegFollowWithinTheirOwnLimits) {
  const RobotModel model = Geared();
  ASSERT_EQ(model.legs.size(), 2U);
  LegTargets legs(model);
  ASSERT_EQ(legs.dofs(0).size(), 3U) << "the geared joint has no coordinate";
  VectorX q0 = StandingConfiguration(model);
  const VectorX rest = VectorX::Zero(model.nv());
  for (const int dof : legs.dofs(0)) q0[7 + dof] = 0.4;
  FootMotion wanted = MotionOf(model, 0, q0, rest);
  wanted.X_WF.translation() += Vector3(0.01, 0.01, 0.01);
  VectorX q = q0, v = rest;
  legs.Solve(0, wanted, q0, q, v);
  EXPECT_LT((MotionOf(model, 0, q, v).X_WF.translation() - wanted.X_WF.translation()).norm(), 1e-5);
  // The ankle stops the folding at -0.5 = 0.1 - 0.5 * 1.2, long before the knee reaches 2.0.
  wanted.X_WF.translation() += Vector3(0.0, 0.0, 1.0);
  for (int k = 0; k < 5; ++k) legs.Solve(0, wanted, q0, q, v);
  double highest = -1.0;
  for (const int dof : legs.dofs(0)) highest = std::max(highest, q[7 + dof]);
  EXPECT_NEAR(highest, 1.2 - kMargin, 1e-9);
}

TEST(LegTargets, LegsWithFewMotorsAreLeftAlone) {
  const Result<RobotModel> model = LoadRobotFromText(
      SyntheticUrdf({{"0 0.1 0", "0 1 0"}, {"0 0 -0.3", "0 1 0"}},
                    "<collision><origin xyz='0 0 -0.3'/><geometry><sphere radius='0.02'/></geometry></collision>"),
      "", "two");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->legs.size(), 2U);
  EXPECT_TRUE(LegTargets(*model).dofs(0).empty());
}

TEST(SettlingShares, AreSmallAtTheAnkleAndOneForYawAndForFeetWithoutASole) {
  const RobotModel nao = Robot("nao");
  LegTargets legs(nao);
  VectorX v = VectorX::Zero(nao.nv());
  legs.Hold(0, Vector3::UnitZ(), 0.0, StandingConfiguration(nao), v);
  const VectorX shares = legs.SettlingShares(0, Vector3::UnitZ());
  double radius = 0.0;
  for (const Vector2& p_F : nao.feet[0].sole_F) radius = std::max(radius, p_F.norm());
  const double edge = std::pow(radius / nao.legs[0].length_m, 2);
  EXPECT_NEAR(shares.tail<2>().maxCoeff(), edge, 1e-9) << "ankle pitch and roll are nearer than the sole's edge";
  EXPECT_GE(shares.minCoeff(), edge - 1e-9);
  EXPECT_LE(shares.maxCoeff(), 1.0);

  const RobotModel a1 = Robot("a1");
  LegTargets points(a1);
  v = VectorX::Zero(a1.nv());
  points.Hold(0, Vector3::UnitZ(), 0.0, StandingConfiguration(a1), v);
  EXPECT_EQ(points.SettlingShares(0, Vector3::UnitZ()), VectorX::Ones(3));
}

}  // namespace
}  // namespace gaitwright
