// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stance_feedback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/playback/hops.h"
#include "tests/playback/reaction.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using displaced::BaseMoved;
using displaced::OnPlan;

/// Inertia of the whole robot about its centre of mass, body by body.
Matrix3 InertiaOf(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const Vector3 p_WC = CentreOfMass(model, scratch);
  Matrix3 inertia = Matrix3::Zero();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Matrix3& R = scratch.R_WB[b];
    const Matrix3 arm = Skew(scratch.p_WB[b] + R * model.bodies[b].p_BC - p_WC);
    inertia += R * model.bodies[b].I_C * R.transpose() - model.bodies[b].mass * arm * arm;
  }
  return inertia;
}

/// A quadruped on four points: every wrench within the friction limits is possible.
class OnFourFeet : public ::testing::TestWithParam<const char*> {
 protected:
  static RobotModel Named(const std::string& name) {
    return name == "block" ? synthetic::Robot(4, FootType::kPoint) : standing::Load(name);
  }
  static MotionPlan Standing(const RobotModel& model) {
    return model.hash.empty() ? synthetic::StandingPlan(model, 1.0) : standing::Plan(model, 1.0);
  }
  /// On the plan, except for the base pose.
  ControlInput Off(const Vector3& offset, const Vector3& turn) const {
    ControlInput input = on_plan_;
    input.q = BaseMoved(model_, input.q, offset, turn);
    return input;
  }
  /// On the plan, except for the base's velocity; feet at rest.
  ControlInput Moving(const Vector3& v_WC, const Vector3& w_WB) const {
    ControlInput input = on_plan_;
    DynamicsScratch scratch(model_);
    ForwardKinematics(model_, input.q, scratch);
    const Vector3 arm = scratch.p_WB[0] - CentreOfMass(model_, scratch);
    input.v.setZero();
    input.v.head<3>() = v_WC + w_WB.cross(arm);
    input.v.segment<3>(3) = w_WB;
    return input;
  }

  const RobotModel model_ = Named(GetParam());
  StanceCase case_{model_, Standing(model_)};
  const ControlInput on_plan_ = OnPlan(case_.plan(), 0.5);
  const double m_ = model_.total_mass_kg;
};

TEST_P(OnFourFeet, NoErrorAsksForThePlannedWrench) {
  const Reaction asked = case_.Ask(on_plan_);
  EXPECT_LT((asked.force_W - Vector3(0.0, 0.0, model_.weight_n())).norm(), 1e-5 * model_.weight_n());
  EXPECT_LT(asked.moment_W.norm(), 1e-5 * model_.weight_n());
}

TEST_P(OnFourFeet, ATiltMeetsTheMomentOfACriticallyDampedSpring) {
  const double k = StabilisedOptions{}.attitude_rad_s;
  const Matrix3 inertia = InertiaOf(model_, on_plan_.q);
  const Vector3 none = case_.Ask(on_plan_).moment_W;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 unit = Vector3::Unit(axis);
    for (const double side : {-1.0, 1.0}) {
      const Vector3 turn = side * 0.01 * unit, spin = side * 0.05 * unit;
      const Vector3 spring = case_.Ask(Off(Vector3::Zero(), turn)).moment_W - none;
      EXPECT_NEAR(spring[axis], -k * k * inertia(axis, axis) * side * 0.01, 0.02 * k * k * inertia(axis, axis) * 0.01);
      const Vector3 damper = case_.Ask(Moving(Vector3::Zero(), spin)).moment_W - none;
      EXPECT_NEAR(damper[axis], -2.0 * k * inertia(axis, axis) * side * 0.05, 0.02 * k * inertia(axis, axis) * 0.05);
    }
  }
}

TEST_P(OnFourFeet, HeightIsHeldLikewise) {
  const double k = StabilisedOptions{}.height_rad_s, weight = model_.weight_n();
  const ControlInput raised = Off({0.0, 0.0, 0.01}, Vector3::Zero());
  const double lift = case_.Ask(raised).force_W.z() - weight;
  const double rise = case_.now.measured.p_WC.z() - case_.now.planned.p_WC.z();
  EXPECT_GT(rise, 0.005);
  EXPECT_NEAR(lift, -m_ * k * k * rise, 1e-3 * weight);
  const double brake = case_.Ask(Moving({0.0, 0.0, 0.1}, Vector3::Zero())).force_W.z() - weight;
  EXPECT_NEAR(brake, -m_ * 2.0 * k * case_.now.measured.v_WC.z(), 1e-3 * weight);
  EXPECT_LT(brake, -0.01 * weight);
}

TEST_P(OnFourFeet, TheZmpGoesBeyondTheDcmByTheGain) {
  const double gain = StabilisedOptions{}.dcm_gain;
  const Vector2 home = case_.Ask(on_plan_).zmp_W;
  for (const Vector3& offset : {Vector3(0.005, 0.0, 0.0), Vector3(0.0, -0.005, 0.0), Vector3(-0.003, 0.002, 0.0)}) {
    const Vector2 moved = case_.Ask(Off(offset, Vector3::Zero())).zmp_W - home;
    const Vector2 error = (case_.now.measured.p_WC - case_.now.planned.p_WC).head<2>();
    EXPECT_GT(error.norm(), 0.5 * offset.norm());
    EXPECT_LT((moved - gain * error).norm(), 0.02 * gain * error.norm());
    const Vector2 caught = case_.Ask(Moving(5.0 * offset, Vector3::Zero())).zmp_W - home;
    const Vector2 forward = case_.now.measured.v_WC.head<2>() / case_.now.omega_rad_s;
    EXPECT_LT((caught - gain * forward).norm(), 0.02 * gain * forward.norm());
  }
}

TEST_P(OnFourFeet, AWrenchScalesWithASmallError) {
  const Reaction none = case_.Ask(on_plan_);
  const Vector3 offset(0.002, -0.001, 0.001), turn(0.002, 0.003, -0.002);
  const Reaction one = case_.Ask(Off(offset, turn)), half = case_.Ask(Off(0.5 * offset, 0.5 * turn));
  const Vector3 force = one.force_W - none.force_W, moment = one.moment_W - none.moment_W;
  EXPECT_GT(force.norm(), 1.0);
  EXPECT_GT(moment.norm(), 0.05);
  EXPECT_LT((force - 2.0 * (half.force_W - none.force_W)).norm(), 0.02 * force.norm());
  EXPECT_LT((moment - 2.0 * (half.moment_W - none.moment_W)).norm(), 0.02 * moment.norm());
}

TEST_P(OnFourFeet, TheZmpStaysInTheUsableSupportWhateverTheError) {
  MotionPlan sticky = Standing(model_);
  sticky.terrain = FlatTerrain(5.0);  // friction must not be the limit
  StanceCase rough(model_, sticky);
  const Vector2 home = rough.Ask(on_plan_).zmp_W;
  Polygon feet;
  for (const Pose& X_WF : rough.now.measured.X_WF) feet.push_back(X_WF.translation().head<2>());
  Polygon usable = ConvexHull(feet);
  Polygon reached = usable;
  for (Vector2& corner : usable) corner = home + StabilisedOptions{}.support_use * (corner - home);
  for (Vector2& corner : reached) corner = home + 0.9 * (corner - home);
  for (int i = 0; i < 16; ++i) {
    const Vector3 direction(std::cos(0.4 * i), std::sin(0.4 * i), 0.0);
    for (const double speed : {0.1, 1.0, 10.0, 1000.0}) {
      const Vector2 zmp = rough.Ask(Moving(speed * direction, Vector3::Zero())).zmp_W;
      const double inside = SignedDistance(usable, zmp);
      EXPECT_GT(inside, -1e-5) << speed << " m/s towards " << direction.transpose();
      EXPECT_GT((zmp - home).dot(direction.head<2>()), 0.01) << "towards the error";
      if (speed > 5.0) {
        EXPECT_LT(SignedDistance(reached, zmp), 0.002) << "as far as it goes, but for what the other feet keep";
      }
    }
  }
}

TEST_P(OnFourFeet, ForcesStayInTheUsedPartOfTheFrictionCone) {
  const double mu = 0.8 * StabilisedOptions{}.friction_use;
  double most = 0.0;
  for (int i = 0; i < 50; ++i) {
    const Vector3 v(3.0 * std::sin(1.0 * i), 3.0 * std::sin(2.3 * i), std::sin(0.7 * i));
    const Vector3 w(4.0 * std::sin(1.3 * i), 4.0 * std::sin(1.9 * i), 4.0 * std::sin(0.3 * i));
    for (const Vector3& force : case_.Ask(Moving(v, w)).foot_W) {
      ASSERT_GE(force.z(), -1e-6);
      ASSERT_LE(force.head<2>().norm(), mu * force.z() + 1e-6);
      if (force.z() > 1.0) most = std::max(most, force.head<2>().norm() / force.z());
    }
  }
  EXPECT_GT(most, 0.98 * mu) << "some are on the cone, but for what each foot keeps";
}

TEST_P(OnFourFeet, FeetInTheAirAreNotAskedForAnything) {
  ControlInput input = Off({0.02, 0.01, 0.0}, Vector3::Zero());
  input.time_s = 0.4;
  case_.now.Update(model_, input);
  input.time_s = 0.5;
  input.contact = 0b0011;
  case_.now.Update(model_, input);
  ASSERT_EQ(case_.now.bearing, FootSet{0b0011});
  VectorX tau = VectorX::Zero(model_.num_dofs());
  case_.stance.Update(case_.now, case_.footing, tau);
  VectorX planned = VectorX::Zero(model_.nv());
  for (std::size_t f = 2; f < 4; ++f) {
    Vector6 wrench;
    wrench << case_.now.sample.wrenches[f].force_W, case_.now.sample.wrenches[f].moment_W;
    AddPointWrench(model_, case_.now.planned.scratch, model_.feet[f].body, case_.now.planned.X_WF[f].translation(),
                   wrench, planned);
  }
  planned.tail(model_.num_dofs()) += case_.BorneWeight();
  for (const std::size_t leg : {2U, 3U}) {
    for (const int joint : model_.legs[leg].joints) {
      const int dof = model_.joints[static_cast<std::size_t>(joint)].dof;
      EXPECT_NEAR(tau[dof], planned[6 + dof], 1e-9)
          << "takes back what the plan holds the ground with, and bears its own weight";
    }
  }
  EXPECT_GT(planned.tail(model_.num_dofs()).norm(), 1.0);
}

TEST_P(OnFourFeet, TheBaseStaysUprightOnTiltedGround) {
  const Vector3 turn(0.02, -0.03, 0.0);
  const ControlInput leaning = displaced::Carried(Pose(RotationExp(turn)), on_plan_);
  const Reaction level = case_.Ask(leaning);
  case_.footing.ground_tilt_W = turn;
  const Reaction tilted = case_.Ask(leaning);
  EXPECT_GT(level.moment_W.norm(), 0.1);
  EXPECT_LT((tilted.moment_W - level.moment_W).norm(), 1e-9);
  EXPECT_LT((tilted.zmp_W - level.zmp_W).norm(), 1e-9);
}

TEST_P(OnFourFeet, TheSameElsewhereAsksForTheSame) {
  ControlInput input = Off({0.004, -0.003, 0.002}, {0.01, 0.02, -0.01});
  input.v.head<6>() << 0.02, -0.03, 0.01, 0.05, 0.04, -0.03;
  const VectorX here = case_.Torques(input), none = case_.Torques(on_plan_);
  EXPECT_GT((here - none).norm(), 0.5);
  for (const Vector3& shift : {Vector3(5.0, -3.0, 0.0), Vector3(0.0, 0.0, 0.4), Vector3(0.0, 0.0, -1.0)}) {
    for (const double yaw : {0.0, 1.5707963, 2.2}) {
      Pose X(YawRotation(yaw));
      X.translation() = shift;
      StanceCase there(model_, displaced::Carried(X, case_.plan()));
      const VectorX tau = there.Torques(displaced::Carried(X, input));
      EXPECT_LT((tau - here).lpNorm<Eigen::Infinity>(), 1e-4 * here.lpNorm<Eigen::Infinity>())
          << "turned by " << yaw << ", moved by " << shift.transpose();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, OnFourFeet, ::testing::Values("block", "a1"), [](const auto& i) { return i.param; });

/// The block robots are symmetric to the plane y = 0: feet and joints by the table.
class Mirrored : public ::testing::TestWithParam<int> {
 protected:
  VectorX Mirror(const VectorX& joints) const {
    VectorX mirrored(joints.size());
    for (Eigen::Index leg = 0; leg < joints.size() / 3; ++leg) {
      const Eigen::Index other = leg % 2 == 0 ? leg + 1 : leg - 1;
      mirrored.segment<3>(3 * other) = joints.segment<3>(3 * leg).cwiseProduct(Vector3(1.0, -1.0, 1.0));
    }
    return mirrored;
  }
  ControlInput Mirror(ControlInput input) const {
    const Eigen::Index n = model_.num_dofs();
    input.q.head<7>() = input.q.head<7>().cwiseProduct(Eigen::Vector<double, 7>(1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0));
    input.v.head<6>() = input.v.head<6>().cwiseProduct(Vector6(1.0, -1.0, 1.0, -1.0, 1.0, -1.0));
    input.q.tail(n) = Mirror(VectorX(input.q.tail(n)));
    input.v.tail(n) = Mirror(VectorX(input.v.tail(n)));
    return input;
  }

  const RobotModel model_ = synthetic::Robot(GetParam(), GetParam() == 2 ? FootType::kSole : FootType::kPoint);
};

TEST_P(Mirrored, AMirroredErrorIsMetByMirroredTorques) {
  StanceCase standing(model_, synthetic::StandingPlan(model_, 1.0));
  for (int i = 0; i < 20; ++i) {
    const double size = i < 10 ? 0.01 : 0.2;  // feet reach the friction limit in the second half
    const auto wave = [&](double rate) { return size * std::sin(rate * (i + 1)); };
    ControlInput input = OnPlan(standing.plan(), 0.5);
    input.q = BaseMoved(model_, input.q, {wave(1.0), wave(2.1), wave(0.7)}, {wave(1.7), wave(0.4), wave(2.9)});
    for (Eigen::Index k = 0; k < input.v.size(); ++k) input.v[k] = wave(0.31 * static_cast<double>(k + 1));
    const VectorX tau = standing.Torques(input), mirrored = standing.Torques(Mirror(input));
    EXPECT_GT((tau - Mirror(tau)).norm(), 0.1) << "not its own mirror image";
    EXPECT_LT((mirrored - Mirror(tau)).lpNorm<Eigen::Infinity>(), 1e-3) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Feet, Mirrored, ::testing::Values(2, 4));

/// A point mass on its legs, accelerated upward by contact forces of a multiple of its weight.
MotionPlan Thrust(const RobotModel& model, double load) {
  MotionPlan plan = synthetic::StandingPlan(model, 1.0);
  for (std::size_t k = 0; k < plan.whole_body.q.size(); ++k) {
    plan.whole_body.a[k][2] = (load - 1.0) * kGravity;
    plan.whole_body.tau[k] *= load;
    for (ContactWrench& wrench : plan.whole_body.wrenches[k]) {
      wrench.force_W *= load;
      wrench.moment_W *= load;
    }
  }
  for (Vector3& a_WC : plan.centroidal.a_WC) a_WC.z() = (load - 1.0) * kGravity;
  return plan;
}

TEST(StanceFeedback, AsksForAsMuchAsAPlanDoesAndHalfAsMuchMore) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  const double weight = model.weight_n();
  for (const double load : {1.0, 2.5, 3.5}) {
    StanceCase thrown(model, Thrust(model, load));
    ControlInput input = OnPlan(thrown.plan(), 0.5);
    EXPECT_NEAR(thrown.Ask(input).force_W.z(), load * weight, 0.01 * weight) << load;
    input.v[2] -= 100.0;  // falls
    EXPECT_NEAR(thrown.Ask(input).force_W.z(), std::max(2.0, 1.5 * load) * weight, 0.02 * weight) << load;
    input.v[2] += 200.0;  // rises
    EXPECT_NEAR(thrown.Ask(input).force_W.z(), 0.3 * weight, 0.02 * load * weight) << load;
  }
  // If the plan presses less than this bound, half of the planned force may be requested.
  StanceCase light(model, Thrust(model, 0.2));
  ControlInput input = OnPlan(light.plan(), 0.5);
  input.v[2] += 100.0;
  EXPECT_NEAR(light.Ask(input).force_W.z(), 0.1 * weight, 0.02 * weight);
}

TEST(StanceFeedback, BeforeAFlightAFootThatBearsNextToNothingIsPressedUntilItLeaves) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  MotionPlan plan = synthetic::HoppingPlan(model);
  for (auto& wrenches : plan.whole_body.wrenches) {
    // Two diagonal feet carry the whole load of all four.
    wrenches[1].force_W += wrenches[0].force_W;
    wrenches[2].force_W += wrenches[3].force_W;
    wrenches[0] = wrenches[3] = {};
  }
  StanceCase light(model, plan);
  const double weight = model.weight_n(), liftoff = plan.schedule.phases.front().end_s;
  const Reaction asked = light.Ask(OnPlan(plan, 0.3)), leaving = light.Ask(OnPlan(plan, liftoff - 0.001));
  for (const std::size_t f : {0U, 3U}) {
    EXPECT_NEAR(asked.foot_W[f].z(), 0.03 * weight, 0.002 * weight);
    EXPECT_LT(leaving.foot_W[f].z(), 0.003 * weight);
  }
  EXPECT_NEAR(asked.force_W.z(), weight, 1e-3 * weight) << "taken off the others";
}

TEST(StanceFeedback, OnAWalkWithoutErrorNothingIsAdded) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  StanceCase walking(model, synthetic::SteppingPlan(model));
  for (double t = 0.0; t < walking.plan().whole_body.end_s(); t += 0.005) {
    EXPECT_LT(walking.Torques(OnPlan(walking.plan(), t)).lpNorm<Eigen::Infinity>(), 0.02) << t;
  }
}

TEST(StanceFeedback, AnAnkleAloneIsNotAskedForMoreThanItHas) {
  const RobotModel nao = standing::Load("nao");
  StanceCase walking(nao, ShortWalk(nao, "", 4, 0.04));
  const MotionPlan& plan = walking.plan();
  double most = 0.0;
  int alone = 0;
  for (const ContactPhase& phase : plan.schedule.phases) {
    if (phase.stance == AllFeet(2)) continue;
    for (int i = 0; i < 12; ++i) {
      ControlInput input = OnPlan(plan, 0.5 * (phase.start_s + phase.end_s));
      input.v.head<2>() += 3.0 * Vector2(std::cos(0.5 * i), std::sin(0.5 * i));
      WholeBodySample sample;
      SampleWholeBody(plan.whole_body, input.time_s, sample);
      const VectorX tau = sample.tau + walking.Torques(input);
      const std::string side = phase.stance == FootSet{1} ? "L" : "R";
      for (const char* ankle : {"AnklePitch", "AnkleRoll"}) {
        const int dof = nao.DofIndex(side + ankle);
        most = std::max(most, std::abs(tau[dof]) / nao.dof_effort_limit(dof));
      }
      ++alone;
    }
  }
  EXPECT_GT(alone, 20);
  EXPECT_LT(most, 1.0);
  EXPECT_GT(most, 0.7);
}

}  // namespace
}  // namespace gaitwright
