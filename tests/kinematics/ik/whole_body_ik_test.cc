// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/whole_body_ik.h"

#include <numbers>

#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// A motion with fixed feet in which the centre of mass sways along all three axes, while the ground under spheres
/// rotates about their contact points.
class Sway {
 public:
  static constexpr double kStep = 0.001;

  explicit Sway(const RobotModel& model) : model_(model), scratch_(model) {
    ForwardKinematics(model, StandingConfiguration(model), scratch_);
    home_ = CentreOfMass(model, scratch_);
    for (const Foot& foot : model.feet) {
      const Pose X_WF = FramePose(scratch_, foot.body, foot.X_BF);
      FootTarget target;
      target.p_WF = X_WF.translation();
      target.R_WF = target.R_anchor = X_WF.linear();
      target_.feet.push_back(target);
      contacts_W_.push_back(target.p_WF - foot.radius * NormalAt(0.0).col(0));
    }
  }
  const BodyTarget& At(double time_s) {
    constexpr double kSwing = 0.015, kRate = 4.0;
    const Matrix3 normal = NormalAt(time_s);
    for (std::size_t f = 0; f < target_.feet.size(); ++f) {
      FootTarget& foot = target_.feet[f];
      const double radius = model_.feet[f].radius;
      foot.normal_anchor_W = 0.5 * (NormalAt(time_s - kStep).col(0) + normal.col(0));
      foot.normal_W = normal.col(0);
      foot.normal_rate_W = normal.col(1);
      foot.p_WF = contacts_W_[f] + radius * normal.col(0);
      foot.v_WF = radius * normal.col(1);
      foot.a_WF = radius * normal.col(2);
    }
    const Vector3 along = Vector3(1.0, 1.0, 1.0) * kSwing;
    target_.p_WC = home_ + along * (std::cos(kRate * time_s) - 1.0);
    target_.v_WC = -along * kRate * std::sin(kRate * time_s);
    target_.a_WC = -along * kRate * kRate * std::cos(kRate * time_s);
    MovePosture(time_s);
    return target_;
  }
  /// Updates the rolled distances of spheres.
  void RollOn(const WholeBodyIk& ik) {
    for (std::size_t f = 0; f < target_.feet.size(); ++f) {
      const Matrix3 R = ik.FootPose(static_cast<int>(f)).linear();
      FootTarget& foot = target_.feet[f];
      contacts_W_[f] += model_.feet[f].radius * RotationLog(R * foot.R_anchor.transpose()).cross(foot.normal_anchor_W);
      foot.R_anchor = R;
    }
  }

 private:
  /// Moves the target posture of all joints; only joints that no task uses follow it.
  void MovePosture(double time_s) {
    constexpr double kSwing = 0.2, kRate = 3.0;
    const VectorX ones = VectorX::Ones(model_.num_dofs());
    target_.posture.q = model_.standing_joints + kSwing * std::sin(kRate * time_s) * ones;
    target_.posture.v = kSwing * kRate * std::cos(kRate * time_s) * ones;
    target_.posture.a = -kSwing * kRate * kRate * std::sin(kRate * time_s) * ones;
  }

  /// The normal and its two derivatives.
  static Matrix3 NormalAt(double time_s) {
    constexpr double kTurns = 0.8;  // [rad/s]
    const double c = std::cos(kTurns * time_s), s = std::sin(kTurns * time_s);
    Matrix3 normal;
    normal << s, kTurns * c, -kTurns * kTurns * s, 0.0, 0.0, 0.0, c, -kTurns * s, -kTurns * kTurns * c;
    return normal;
  }

  const RobotModel& model_;
  DynamicsScratch scratch_;
  Vector3 home_;
  std::vector<Vector3> contacts_W_;  // by foot, under its frame
  BodyTarget target_;
};

class WholeBodyIkTest : public testing::TestWithParam<const char*> {};

TEST_P(WholeBodyIkTest, RatesAreDerivativesOfPositions) {
  const RobotModel model = AnyRobot(GetParam());
  WholeBodyIk ik(model);
  Sway sway(model);
  VectorX q = StandingConfiguration(model), v, a;
  std::vector<VectorX> positions, velocities, accelerations;
  constexpr double kStep = Sway::kStep;
  for (int k = 0; k < 300; ++k) {
    const BodyTarget& target = sway.At(k * kStep);
    const Result<int> solved = ik.SolvePosition(target, q);
    ASSERT_TRUE(solved.ok()) << solved.failure().message;
    ik.SolveRates(target, q, v, a);
    positions.push_back(q);
    velocities.push_back(v);
    accelerations.push_back(a);
    sway.RollOn(ik);
  }
  const Eigen::Index n = model.num_dofs();
  const auto derivative = [&](const std::vector<VectorX>& f, std::size_t k) -> VectorX {  // to the fourth order
    return (8.0 * (f[k + 1] - f[k - 1]) - (f[k + 2] - f[k - 2])) / (12.0 * kStep);
  };
  for (std::size_t k = 2; k + 2 < positions.size(); ++k) {
    EXPECT_LT((derivative(positions, k).tail(n) - velocities[k].tail(n)).norm(), 1e-3);
    EXPECT_LT((derivative(velocities, k) - accelerations[k]).norm(), 1e-2);
  }
  EXPECT_GT(velocities[100].tail(n).norm(), 0.1);
}

/// Robots with legs of limited length. A prismatic knee can be of any length here, because its limits are only checked
/// by the audit.
class OfFiniteLegs : public WholeBodyIkTest {};

TEST_P(OfFiniteLegs, OutOfReachNamesAFoot) {
  const RobotModel model = AnyRobot(GetParam());
  WholeBodyIk ik(model);
  Sway sway(model);
  BodyTarget target = sway.At(0.0);
  target.p_WC.z() += 0.5;
  VectorX q = StandingConfiguration(model);
  const Result<int> solved = ik.SolvePosition(target, q);
  ASSERT_FALSE(solved.ok());
  EXPECT_NE(solved.failure().message.find("cannot reach"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Robots, WholeBodyIkTest, testing::ValuesIn(kAnyRobots));
INSTANTIATE_TEST_SUITE_P(Robots, OfFiniteLegs, testing::Values("a1", "nao", "continuous", "hollow", "mimic"));

/// The target rotated by a yaw angle about the vertical through the origin.
BodyTarget Turned(const BodyTarget& target, const Matrix3& R) {
  BodyTarget turned = target;
  for (Vector3* v : {&turned.p_WC, &turned.v_WC, &turned.a_WC, &turned.w_WB, &turned.alpha_WB}) *v = R * *v;
  turned.R_WB = R * target.R_WB;
  for (FootTarget& foot : turned.feet) {
    for (Vector3* v : {&foot.p_WF, &foot.v_WF, &foot.w_WF, &foot.a_WF, &foot.alpha_WF, &foot.normal_anchor_W,
                       &foot.normal_W, &foot.normal_rate_W})
      *v = R * *v;
    foot.R_WF = R * foot.R_WF;
    foot.R_anchor = R * foot.R_anchor;
  }
  return turned;
}

class Headings : public WholeBodyIkTest {};

TEST_P(Headings, JointsDoNotDependOnTheHeading) {
  const RobotModel model = AnyRobot(GetParam());
  WholeBodyIk ik(model);
  Sway sway(model);
  const BodyTarget& target = sway.At(0.2);
  VectorX q = StandingConfiguration(model), v, a;
  ASSERT_TRUE(ik.SolvePosition(target, q).ok());
  ik.SolveRates(target, q, v, a);
  const Eigen::Index n = model.num_dofs();
  for (const double yaw : {0.4, 0.5 * std::numbers::pi, -2.5}) {
    const Matrix3 R = YawRotation(yaw);
    VectorX turned_q = StandingConfiguration(model), turned_v, turned_a;
    turned_q.segment<4>(3) = Quaternion(R).coeffs();
    const Result<int> solved = ik.SolvePosition(Turned(target, R), turned_q);
    ASSERT_TRUE(solved.ok()) << solved.failure().message;
    ik.SolveRates(Turned(target, R), turned_q, turned_v, turned_a);
    EXPECT_LT((turned_q.tail(n) - q.tail(n)).norm(), 1e-8) << yaw;
    EXPECT_LT((turned_v.tail(n) - v.tail(n)).norm(), 1e-7) << yaw;
    EXPECT_LT((turned_a.tail(n) - a.tail(n)).norm(), 1e-6) << yaw;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Headings, testing::ValuesIn(kAnyRobots));

TEST(WholeBodyIk, JointsOutsideTheLegsFollowThePosture) {
  const RobotModel model = Robot("nao");
  WholeBodyIk ik(model);
  Sway sway(model);
  BodyTarget target = sway.At(0.2);
  VectorX q = StandingConfiguration(model), v, a;
  ASSERT_TRUE(ik.SolvePosition(target, q).ok());
  ik.SolveRates(target, q, v, a);
  const int elbow = model.DofIndex("RElbowRoll"), knee = model.DofIndex("RKneePitch");
  EXPECT_EQ(q[7 + elbow], target.posture.q[elbow]);
  EXPECT_EQ(v[6 + elbow], target.posture.v[elbow]);
  EXPECT_EQ(a[6 + elbow], target.posture.a[elbow]);
  EXPECT_GT(std::abs(v[6 + elbow]), 0.1);
  EXPECT_NE(q[7 + knee], target.posture.q[knee]);
  target.posture = {};  // without a posture they stay at the initial guess, at rest
  q = StandingConfiguration(model);
  ASSERT_TRUE(ik.SolvePosition(target, q).ok());
  ik.SolveRates(target, q, v, a);
  EXPECT_EQ(q[7 + elbow], model.standing_joints[elbow]);
  EXPECT_EQ(v[6 + elbow], 0.0);
}

TEST(WholeBodyIk, OnlyTheYawOfNaoYields) {
  const RobotModel nao = Robot("nao"), a1 = Robot("a1");
  EXPECT_TRUE(WholeBodyIk(a1).notes().empty());
  const WholeBodyIk ik(nao);
  ASSERT_EQ(ik.notes().size(), 1U);
  EXPECT_NE(ik.notes()[0].find("base yaw is not tracked"), std::string::npos);
}

/// Two legs of six joints below a waist of two.
std::string LegsBelowAWaist() {
  struct Part {
    std::string name, axis, at;
  };
  const auto joint = [](const Part& part, const std::string& parent) {
    return Replaced(PitchJoint(part.name + "_joint", parent, part.name, part.at), "<axis xyz='0 1 0'/>",
                    "<axis xyz='" + part.axis + "'/>");
  };
  std::string text = "<robot name='waist'>" + SmallLink("trunk", "<box size='0.1 0.2 0.2'/>") + SmallLink("girdle") +
                     SmallLink("pelvis") + joint({"girdle", "0 0 1", "0 0 -0.1"}, "trunk") +
                     joint({"pelvis", "1 0 0", "0 0 -0.02"}, "girdle");
  for (const std::string side : {"left", "right"}) {
    std::string parent = "pelvis";
    for (const Part& part : std::vector<Part>{{"_turn", "0 0 1", side == "left" ? "0 0.1 -0.05" : "0 -0.1 -0.05"},
                                              {"_splay", "1 0 0", "0 0 0"},
                                              {"_thigh", "0 1 0", "0 0 0"},
                                              {"_shank", "0 1 0", "0 0 -0.3"},
                                              {"_ankle", "0 1 0", "0 0 -0.3"},
                                              {"_foot", "1 0 0", "0 0 -0.05"}}) {
      const std::string name = side + part.name;
      text += SmallLink(name, part.name == "_foot" ? "<box size='0.2 0.1 0.02'/>" : "") +
              joint({name, part.axis, part.at}, parent);
      parent = name;
    }
  }
  return text + "</robot>";
}

TEST(WholeBodyIk, AWaistIsHeldBeforeJointsOfOneLeg) {
  const Result<RobotModel> model = LoadRobotFromText(LegsBelowAWaist(), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const WholeBodyIk ik(*model);
  ASSERT_EQ(ik.notes().size(), 2U);
  EXPECT_NE(ik.notes()[0].find("girdle_joint is held"), std::string::npos) << ik.notes()[0];
  EXPECT_NE(ik.notes()[1].find("pelvis_joint is held"), std::string::npos) << ik.notes()[1];
}

}  // namespace
}  // namespace gaitwright
