// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/knot_model_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

class KnotModels : public testing::TestWithParam<const char*> {
 protected:
  KnotModels() {
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      const Foot& foot = model_.feet[f];
      KnotContact contact{static_cast<int>(f), {Vector3::Zero()}, -foot.radius * normal_W_};
      if (foot.has_sole()) contact.points_F.clear();
      for (const Vector2& corner : foot.sole_F) contact.points_F.emplace_back(corner.x(), corner.y(), 0.0);
      points_ += static_cast<Eigen::Index>(contact.points_F.size());
      contacts_.push_back(contact);
    }
    forces_ = 30.0 * random_.Vector(3 * points_);
  }

  const RobotModel model_ = AnyRobot(GetParam());
  const Vector3 normal_W_ = Vector3(0.1, -0.2, 1.0).normalized();
  KnotModel knot_{model_};
  std::vector<KnotContact> contacts_;
  Eigen::Index points_ = 0;
  RandomState random_{5};
  VectorX forces_;
};

TEST_P(KnotModels, ForcesAreThoseOfInverseDynamicsAndPoints) {
  const VectorX q = random_.Configuration(model_), v = random_.Vector(model_.nv()), a = random_.Vector(model_.nv());
  VectorX needed, wanted;
  knot_.Evaluate(q, v, a, contacts_, forces_, needed);
  DynamicsScratch scratch(model_);
  InverseDynamics(model_, q, v, a, scratch, wanted);
  Eigen::Index at = 0;
  for (const KnotContact& contact : contacts_) {
    const Foot& foot = model_.feet[static_cast<std::size_t>(contact.foot)];
    const Pose X_WF = FramePose(scratch, foot.body, foot.X_BF);
    for (const Vector3& p_F : contact.points_F) {
      AddPointForce(model_, scratch, foot.body, X_WF * p_F + contact.offset_W, -forces_.segment<3>(at), wanted);
      at += 3;
    }
  }
  EXPECT_LT((needed - wanted).norm(), 1e-10 * wanted.norm());
  KnotForces result;
  knot_.Differentiate(q, v, a, contacts_, forces_, result);
  EXPECT_LT((result.needed - wanted).norm(), 1e-10 * wanted.norm());
}

TEST_P(KnotModels, DerivativesAreThoseOfFiniteDifferences) {
  const Eigen::Index nv = model_.nv();
  const VectorX q = random_.Configuration(model_), v = random_.Vector(nv), a = random_.Vector(nv);
  KnotForces result;
  VectorX x = VectorX::Zero(3 * nv + forces_.size());
  x.segment(nv, nv) = v;
  x.segment(2 * nv, nv) = a;
  x.tail(forces_.size()) = forces_;
  ExpectDerivative(
      [&](const VectorX& at, VectorX& value, MatrixX* J) {
        const VectorX q_there = Moved(q, at.head(nv), 1.0), v_there = at.segment(nv, nv),
                      a_there = at.segment(2 * nv, nv), f_there = at.tail(forces_.size());
        if (J == nullptr) return knot_.Evaluate(q_there, v_there, a_there, contacts_, f_there, value);
        knot_.Differentiate(q_there, v_there, a_there, contacts_, f_there, result);
        value = result.needed;
        *J << result.by_q, result.by_v, result.by_a, result.by_force;
      },
      x);
}

TEST_P(KnotModels, FeetMoveByTheirJacobians) {
  const Eigen::Index nv = model_.nv();
  const VectorX q = random_.Configuration(model_), none = VectorX::Zero(nv);
  VectorX needed;
  KnotFoot foot, here;
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    const int index = static_cast<int>(f);
    knot_.Evaluate(q, none, none, contacts_, forces_, needed);
    knot_.FootAt(index, true, here);
    ExpectDerivative(
        [&](const VectorX& x, VectorX& value, MatrixX* J) {
          knot_.Evaluate(Moved(q, x, 1.0), none, none, contacts_, forces_, needed);
          knot_.FootAt(index, J != nullptr, foot);
          value.resize(6);
          value << foot.p_WF, RotationLog(foot.R_WF * here.R_WF.transpose());
          if (J != nullptr) *J = foot.J;
        },
        none);
  }
}

TEST_P(KnotModels, LockedAccelerationsAndWrenchesAreThoseOfTheMassMatrix) {
  const Eigen::Index nv = model_.nv();
  const VectorX q = random_.Configuration(model_), none = VectorX::Zero(nv);
  VectorX needed;
  knot_.Evaluate(q, none, none, contacts_, forces_, needed);
  const Vector6 wrench = random_.Vector(6), acceleration = knot_.LockedAcceleration(wrench);
  EXPECT_LT((knot_.LockedWrench(acceleration) - wrench).norm(), 1e-10);
  DynamicsScratch scratch(model_);
  MatrixX M;
  MassMatrix(model_, q, scratch, M);
  EXPECT_LT((M.topLeftCorner<6, 6>() * acceleration - wrench).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Robots, KnotModels, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
