// SPDX-License-Identifier: BSD-3-Clause
// For each check, a small violation in a good plan: it is found with place, time and size, and nothing else is
// reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/stability/zero_moment_point.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using Laws = std::vector<Law>;

class AuditLaw : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& good() const { return GoodPlanOf(GetParam()).plan; }
  const std::string& foot() const { return model().feet[0].name; }
  std::size_t row() const { return MidSwingRow(good()); }
  double row_s() const { return TimeOf(good(), row()); }
};

INSTANTIATE_TEST_SUITE_P(Robots, AuditLaw, testing::Values("a1", "nao"), [](const auto& robot) { return robot.param; });

/// The sample at which a figure of the plan is largest, and its value.
template <class Figure>
std::pair<double, double> LargestOf(const RobotModel& model, const MotionPlan& plan, const Figure& figure) {
  std::pair<double, double> largest = {0.0, -1e300};
  for (const double time_s : SampleTimes(plan)) {
    const double value = figure(Moment(model, plan, time_s));
    if (value > largest.second) largest = {time_s, value};
  }
  return largest;
}

/// A joint that moves in the good plan: the joint before foot 0.
int MovingDof(const RobotModel& model) { return model.joints[static_cast<std::size_t>(model.legs[0].knee_joint)].dof; }

Shape BallUnderFoot(int body, const std::string& link, const Vector3& p_BS, double radius_m) {
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.body = body;
  ball.link = link;
  ball.X_BS.translation() = p_BS;
  ball.size.x() = radius_m;
  return ball;
}

TEST_P(AuditLaw, AGoodPlanKeepsAll) {
  const AuditReport report = Audit(model(), good(), {}).value();
  EXPECT_TRUE(report.pass()) << AuditText(report);
  EXPECT_EQ(report.samples, static_cast<int>(SampleTimes(good()).size()));
}

TEST_P(AuditLaw, DynamicsFindsATorqueThatIsNotOfTheMotion) {
  const double limit =
      std::min(0.05 * model().dof_effort_limit(0), 0.02 * model().weight_n() * good().centroidal.p_WC[row()].z());
  MotionPlan plan = good();
  plan.whole_body.tau[row()][0] += 1.5 * limit;
  const auto found = ViolationsOf(model(), plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kDynamics);
  EXPECT_EQ(found[0].where, model().dof_names[0]);
  EXPECT_NEAR(found[0].at_s, row_s(), 1e-9);
  EXPECT_NEAR(found[0].value, 1.5 * limit, 0.1 * limit);
  EXPECT_NEAR(found[0].limit, limit, 1e-6);
}

TEST_P(AuditLaw, UnilateralFindsAFootThatPulls) {
  const double pull = 0.01 * model().weight_n();
  MotionPlan plan = good();
  plan.whole_body.wrenches[row()][0].force_W.z() -= pull;
  const auto found = ViolationsOf(model(), plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kUnilateral);
  EXPECT_EQ(found[0].where, foot());
  EXPECT_NEAR(found[0].at_s, row_s(), 1e-9);
  EXPECT_NEAR(found[0].value, -pull, 1e-9);
}

TEST_P(AuditLaw, FrictionConeFindsAGroundTooSlippery) {
  const auto use = [](const Moment& moment) {
    double most = 0.0;
    for (const ContactWrench& wrench : moment.sample.wrenches) {
      if (wrench.force_W.z() > 5.0) most = std::max(most, wrench.force_W.head<2>().norm() / wrench.force_W.z());
    }
    return most;
  };
  MotionPlan plan = good();
  plan.terrain = FlatTerrain(0.8 * LargestOf(model(), good(), use).second);
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), Laws{Law::kFrictionCone});
  for (std::size_t f = 0; f < model().feet.size(); ++f) {
    const auto at =
        std::find_if(found.begin(), found.end(), [&](const auto& v) { return v.where == model().feet[f].name; });
    if (at == found.end()) continue;
    const Vector3 force_W = Moment(model(), plan, at->at_s).sample.wrenches[f].force_W;
    EXPECT_NEAR(at->value, force_W.head<2>().norm(), 1e-9);
    EXPECT_NEAR(at->limit, plan.terrain.patches[0].friction * force_W.z(), 1e-9);
  }
}

TEST_P(AuditLaw, ZmpSupportFindsAnAccelerationThatPutsItOut) {
  const double height = good().centroidal.p_WC[row()].z(), out = 0.2;
  MotionPlan plan = good();
  plan.whole_body.a[row()][1] += out * kGravity / height;
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), (Laws{Law::kConsistency, Law::kZmpSupport, Law::kDynamics}));
  const Violation& zmp = At(found, "zero-moment point");
  EXPECT_NEAR(zmp.at_s, row_s(), 1e-9);
  EXPECT_LT(zmp.value, out);
  EXPECT_GT(zmp.value, 0.3 * out) << "the rest is the way to the edge";
}

TEST_P(AuditLaw, ZmpSupportFindsAReferenceOutside) {
  MotionPlan plan = good();
  plan.centroidal.p_WZ[row()].y() += 0.2;
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), (Laws{Law::kConsistency, Law::kZmpSupport}));
  EXPECT_NEAR(At(found, "reference of the zero-moment point").at_s, row_s(), 1e-9);
}

/// Between the rows before and after a change of stance, the reference may be of neither stance.
TEST_P(AuditLaw, ZmpSupportLooksAtTheReferenceInsideAStanceOnly) {
  const auto violated_by = [&](double time_s) {
    MotionPlan plan = good();
    const double row = std::round((time_s - plan.whole_body.start_s) / plan.whole_body.step_s);
    plan.centroidal.p_WZ[static_cast<std::size_t>(row)].y() += 0.2;
    const auto found = ViolationsOf(model(), plan);
    return std::ranges::any_of(found,
                               [](const Violation& v) { return v.where == "reference of the zero-moment point"; });
  };
  const ContactPhase& swing = good().schedule.phases[1];
  EXPECT_FALSE(violated_by(swing.start_s));
  EXPECT_FALSE(violated_by(swing.end_s));
  EXPECT_TRUE(violated_by(0.5 * (swing.start_s + swing.end_s)));
}

TEST_P(AuditLaw, JointPositionFindsALimitPassed) {
  const int dof = MovingDof(model());
  const auto [at_s, most] = LargestOf(model(), good(), [&](const Moment& moment) { return moment.sample.q[7 + dof]; });
  RobotModel stiff = model();
  stiff.joints[static_cast<std::size_t>(stiff.dof_joint[static_cast<std::size_t>(dof)])].upper = most - 0.01;
  const auto found = ViolationsOf(stiff, good());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kJointPosition);
  EXPECT_EQ(found[0].where, model().dof_names[static_cast<std::size_t>(dof)]);
  EXPECT_NEAR(found[0].value, most, 1e-12);
  EXPECT_NEAR(found[0].at_s, at_s, 1e-9);
  EXPECT_EQ(found[0].unit, "rad");
}

TEST_P(AuditLaw, JointVelocityFindsALimitPassed) {
  const int dof = MovingDof(model());
  const auto [at_s, most] =
      LargestOf(model(), good(), [&](const Moment& moment) { return std::abs(moment.sample.v[6 + dof]); });
  RobotModel slow = model();
  slow.joints[static_cast<std::size_t>(slow.dof_joint[static_cast<std::size_t>(dof)])].velocity_limit = 0.95 * most;
  const auto found = ViolationsOf(slow, good());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kJointVelocity);
  EXPECT_EQ(found[0].where, model().dof_names[static_cast<std::size_t>(dof)]);
  EXPECT_NEAR(found[0].value, most, 1e-9);
  EXPECT_NEAR(found[0].at_s, at_s, 1e-9);
  EXPECT_EQ(found[0].unit, "rad/s");
}

TEST_P(AuditLaw, JointTorqueFindsALimitPassed) {
  const int dof = MovingDof(model());
  const auto [at_s, most] =
      LargestOf(model(), good(), [&](const Moment& moment) { return std::abs(moment.sample.tau[dof]); });
  RobotModel weak = model();
  weak.joints[static_cast<std::size_t>(weak.dof_joint[static_cast<std::size_t>(dof)])].effort_limit = 0.95 * most;
  const auto found = ViolationsOf(weak, good());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kJointTorque);
  EXPECT_EQ(found[0].where, model().dof_names[static_cast<std::size_t>(dof)]);
  EXPECT_NEAR(found[0].value, most, 1e-9);
  EXPECT_NEAR(found[0].at_s, at_s, 1e-9);
}

TEST_P(AuditLaw, ReachFindsAFootholdFartherThanTheLegIsLong) {
  MotionPlan plan = good();
  Foothold& last = plan.footsteps.footholds[static_cast<std::size_t>(FootholdAt(plan.footsteps, 0, 1e9))];
  last.X_WF.translation().x() += 2.0 * model().leg_length_m();
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), (Laws{Law::kConsistency, Law::kReach}));
  const Violation& reach = found.back();
  EXPECT_EQ(reach.where, foot());
  EXPECT_GE(reach.at_s, last.touchdown_s);
  const int hip = model().legs[0].joints.front() + 1;
  const Vector3 p_WH = Moment(model(), plan, reach.at_s).scratch.p_WB[static_cast<std::size_t>(hip)];
  EXPECT_NEAR(reach.value, (last.X_WF.translation() - p_WH).norm(), 1e-9);
  EXPECT_GT(reach.value, reach.limit);
}

TEST_P(AuditLaw, SelfCollisionFindsHowDeepAFootGoesIntoABodyInFrontOfIt) {
  // A ball on the foot, and another one fixed to the base in front of it. They meet only where the foot swings farthest
  // forward.
  const Foot& lifted = model().feet[0];
  const auto in_base = [&](const Moment& moment) {
    const Vector3 p_WF = FramePose(moment.scratch, lifted.body, lifted.X_BF).translation();
    return Vector3(moment.scratch.R_WB[0].transpose() * (p_WF - moment.scratch.p_WB[0]));
  };
  const Vector3 forward = in_base(Moment(model(), good(), row_s())) + Vector3(0.1, 0.0, 0.0);
  const auto [at_s, nearness] =
      LargestOf(model(), good(), [&](const Moment& moment) { return -(in_base(moment) - forward).norm(); });
  constexpr double kSmall = 0.01, kDepth = 0.003, kGrain = 1e-4;
  RobotModel balls = model();
  balls.collision_shapes = {BallUnderFoot(lifted.body, lifted.link, lifted.X_BF.translation(), kSmall),
                            BallUnderFoot(0, model().feet[1].link, forward, -nearness - kSmall + kDepth)};
  // Foot links may touch the ground. Bodies without shapes would connect the two balls.
  for (int body = 1; body < static_cast<int>(model().bodies.size()); ++body) {
    if (body != lifted.body) balls.collision_shapes.push_back(BallUnderFoot(body, "grain", Vector3::Zero(), kGrain));
  }
  const auto found = ViolationsOf(balls, good());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kSelfCollision);
  EXPECT_EQ(found[0].where, lifted.link + " and " + model().feet[1].link);
  EXPECT_NEAR(found[0].value, kDepth, 1e-5);
  EXPECT_NEAR(found[0].at_s, at_s, 1.5e-3);
  EXPECT_EQ(found[0].unit, "m");
}

TEST_P(AuditLaw, FootClearanceFindsABumpUnderASwing) {
  const std::vector<Vector3> points = ContactPoints(model(), Moment(model(), good(), row_s()).scratch, 0);
  MotionPlan plan = good();
  TerrainPatch bump = plan.terrain.patches[0];
  constexpr double kHalf = 1e-3, kOver = 2e-3;
  bump.X_WT.translation() = points[0] + Vector3(0.0, 0.0, kOver);
  bump.outline_T = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
  plan.terrain.patches.push_back(bump);
  const auto found = ViolationsOf(model(), plan);
  // Other parts that pass there, such as a shank, may hit it, too.
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].law, Law::kFootClearance);
  for (const Violation& violation : found)
    EXPECT_TRUE(violation.law == Law::kFootClearance || violation.law == Law::kBodyClearance) << violation.law;
  const Violation& hit = At(found, foot());
  EXPECT_NEAR(hit.at_s, row_s(), 0.01);
  EXPECT_NEAR(hit.value, -kOver, 5e-4);
}

TEST_P(AuditLaw, BodyClearanceFindsAPostThatTheTrunkPassesInFourMilliseconds) {
  constexpr double kRadius = 0.02, kOver = 2e-3, kHalf_s = 2e-3, kSample_s = 1e-3;
  RobotModel ball = model();
  ball.collision_shapes = {BallUnderFoot(0, "ball", Vector3::Zero(), kRadius)};
  const double middle_s = good().whole_body.start_s + 0.5 * good().duration_s();
  const Moment middle(model(), good(), middle_s);
  MotionPlan plan = good();
  TerrainPatch post = plan.terrain.patches[0];
  post.X_WT.translation() = middle.scratch.p_WB[0] + Vector3(0.0, 0.0, kOver - kRadius);
  const double along = kHalf_s * middle.sample.v.head<2>().norm();
  ASSERT_GT(along, 1e-5);
  post.outline_T = {{-along, -along}, {along, -along}, {along, along}, {-along, along}};
  plan.terrain.patches.push_back(post);
  const auto found = ViolationsOf(ball, plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kBodyClearance);
  EXPECT_EQ(found[0].where, "ball");
  EXPECT_NEAR(found[0].at_s, middle_s, 2.0 * kHalf_s + kSample_s);
  EXPECT_NEAR(found[0].value, -kOver, 2e-4);
  EXPECT_EQ(found[0].unit, "m");
}

/// A plan with one row in mid swing, on two feet, in which the whole robot falls, so that only a share of its weight
/// presses on the ground, with a moment about the line of its feet, in m g h.
MotionPlan Falling(const GoodPlan& good, double share, double moment) {
  MotionPlan plan = good.plan;
  const std::size_t row = MidSwingRow(plan);
  const Moment at(good.model, plan, TimeOf(plan, row));
  std::vector<Vector2> feet;
  for (const int foot : {0, 1, 2, 3}) {
    const Foothold& on =
        plan.footsteps.footholds[static_cast<std::size_t>(FootholdAt(plan.footsteps, foot, TimeOf(plan, row)))];
    if (on.liftoff_s > TimeOf(plan, row))
      feet.emplace_back(ContactFrame(good.model, at.scratch, foot).translation().head<2>());
  }
  EXPECT_EQ(feet.size(), 2U);
  const Vector2 along = (feet[1] - feet[0]).normalized(), across(-along.y(), along.x());
  DynamicsScratch scratch(good.model);
  VectorX needed;
  const auto off = [&]() {
    InverseDynamics(good.model, plan.whole_body.q[row], plan.whole_body.v[row], plan.whole_body.a[row], scratch,
                    needed);
    return across.dot(ZeroMomentPoint(scratch.p_WB[0], needed.head<3>(), needed.segment<3>(3), 0.0) - feet[0]);
  };
  (void)off();
  plan.whole_body.a[row][2] += share * kGravity - needed[2] / good.model.total_mass_kg;
  const double wanted = moment * good.plan.centroidal.p_WC[0].z() / share, before = off();
  plan.whole_body.a[row].head<2>() += 0.01 * across;
  const double by_push = (off() - before) / 0.01;
  plan.whole_body.a[row].head<2>() += ((wanted - before) / by_push - 0.01) * across;
  EXPECT_NEAR(off(), wanted, 1e-9);
  EXPECT_NEAR(needed[2], share * good.model.weight_n(), 1e-6);
  return plan;
}

TEST(AuditOfLines, WhereLittlePressesAThousandthOfTheWeightTimesItsHeightIsNoMoment) {
  const GoodPlan& a1 = GoodPlanOf("a1");
  const double height = a1.plan.centroidal.p_WC[0].z();
  const auto found = [&](double share, double moment) {
    const auto all = ViolationsOf(a1.model, Falling(a1, share, moment));
    return std::count_if(all.begin(), all.end(), [](const Violation& v) { return v.where == "zero-moment point"; });
  };
  for (const double share : {0.06, 0.08, 0.1}) {
    const double usual = 2e-3 * share / height;  // 2 mm as a moment
    ASSERT_LT(usual, 0.9e-3);
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(found(share, side * 0.9e-3), 0) << share;
      EXPECT_EQ(found(share, side * 1.1e-3), 1) << share;
    }
  }
  // Above an eighth of the weight, the distance is checked.
  for (const double share : {0.3, 0.9}) {
    EXPECT_EQ(found(share, 1.8e-3 * share / height), 0) << share;
    EXPECT_EQ(found(share, 2.2e-3 * share / height), 1) << share;
  }
}

TEST(AuditOfLines, TheReferenceMayBeOffTheJointsByNoMoreThanSuchAMoment) {
  const GoodPlan& a1 = GoodPlanOf("a1");
  const double height = a1.plan.centroidal.p_WC[0].z();
  const auto found = [&](double share, double off_m) {
    MotionPlan plan = Falling(a1, share, 0.0);
    const std::size_t row = MidSwingRow(plan);
    DynamicsScratch scratch(a1.model);
    VectorX needed;
    InverseDynamics(a1.model, plan.whole_body.q[row], plan.whole_body.v[row], plan.whole_body.a[row], scratch, needed);
    const Vector2 p_WZ = ZeroMomentPoint(scratch.p_WB[0], needed.head<3>(), needed.segment<3>(3), 0.0);
    plan.centroidal.p_WZ[row] = p_WZ + off_m * Vector2::UnitX();
    const auto all = ViolationsOf(a1.model, plan);
    return std::count_if(all.begin(), all.end(), [](const Violation& v) {
      return v.where == "reference of the zero-moment point against joints";
    });
  };
  for (const double share : {0.06, 0.1}) {
    EXPECT_EQ(found(share, 0.9e-3 * height / share), 0) << share;
    EXPECT_EQ(found(share, 1.1e-3 * height / share), 1) << share;
  }
  for (const double share : {0.3, 0.9}) {
    EXPECT_EQ(found(share, 1.8e-3), 0) << share;
    EXPECT_EQ(found(share, 2.2e-3), 1) << share;
  }
}

TEST(AuditOfSlides, GivesLengthsAndForces) {
  // A joint that stays at zero, changed to a prismatic joint: it carries the weight of everything above it.
  const GoodPlan& nao = GoodPlanOf("nao");
  RobotModel slides = nao.model;
  slides.joints[0].type = JointType::kPrismatic;
  slides.joints[0].lower = 0.01;
  const auto found = ViolationsOf(slides, nao.plan);
  EXPECT_EQ(LawsOf(found), (Laws{Law::kJointPosition, Law::kDynamics}));
  EXPECT_EQ(found[0].where, nao.model.dof_names[0]);
  EXPECT_EQ(found[0].unit, "m");
  EXPECT_EQ(At({found[1]}, nao.model.dof_names[0]).unit, "N");
}

TEST(AuditOfTorques, FindsAQuarterNewtonMetreOnASmallJoint) {
  const GoodPlan& nao = GoodPlanOf("nao");
  MotionPlan plan = nao.plan;
  const int head = nao.model.DofIndex("HeadYaw");
  for (VectorX& tau : plan.whole_body.tau) tau[head] += 0.25;
  const auto found = ViolationsOf(nao.model, plan);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kDynamics);
  EXPECT_EQ(found[0].where, "HeadYaw");
  EXPECT_NEAR(found[0].value, 0.25, 1e-3);
}

}  // namespace
}  // namespace gaitwright
