// SPDX-License-Identifier: BSD-3-Clause
// Comparison with an independent library: DART reads the same URDF with its own reader.
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/DegreeOfFreedom.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Joint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/DartLoader.hpp>

#include "kinematics/dynamics/dynamics.h"
#include "tests/built_paths.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class TwoRoads : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    model_ = AnyRobot(GetParam());
    dart::utils::DartLoader loader;
    const std::string name = GetParam();
    const bool made = name != "a1" && name != "nao";
    skeleton_ = made ? loader.parseSkeletonString(MadeUrdf(name), "")
                     : loader.parseSkeleton(SourceFolder() + "/robots/" + name + "/robot.urdf");
    ASSERT_NE(skeleton_, nullptr);
    skeleton_->setGravity(Vector3(0.0, 0.0, -kGravity));
    // DART gives links without an <inertial> a mass of 1 kg.
    for (dart::dynamics::BodyNode* body : skeleton_->getBodyNodes()) {
      if (model_.urdf_text.find("<link name=\"" + body->getName() + "\"/>") != std::string::npos) Lighten(*body);
      if (model_.urdf_text.find("<link name='" + body->getName() + "'></link>") != std::string::npos) Lighten(*body);
      if (body->getName().ends_with("_thigh_shoulder")) Lighten(*body);
    }
  }

  static void Lighten(dart::dynamics::BodyNode& body) {
    body.setInertia(dart::dynamics::Inertia(1e-15, Vector3::Zero(), 1e-15 * Matrix3::Identity()));
  }

  /// The state in DART; `follow` is d(DART's coordinates) / d(ours): six of the base (w_B, v_B at the base origin) and
  /// the joints.
  void Set(const VectorX& q, const VectorX& v, const VectorX& a) {
    auto* root = static_cast<dart::dynamics::FreeJoint*>(skeleton_->getRootJoint());
    Pose X_WB = Pose::Identity();
    X_WB.linear() = Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix();
    X_WB.translation() = q.head<3>();
    root->setTransform(X_WB, dart::dynamics::Frame::World());
    follow_ = MatrixX::Zero(static_cast<Eigen::Index>(skeleton_->getNumDofs()), model_.nv());
    const Matrix3 R_BW = X_WB.linear().transpose();
    follow_.block<3, 3>(0, 3) = R_BW;
    follow_.block<3, 3>(3, 0) = R_BW;
    for (const Joint& joint : model_.joints) {
      auto* dof = skeleton_->getDof(joint.name);
      ASSERT_NE(dof, nullptr) << joint.name;
      dof->setPosition(joint.multiplier * q[7 + joint.dof] + joint.offset);
      follow_(static_cast<Eigen::Index>(dof->getIndexInSkeleton()), 6 + joint.dof) = joint.multiplier;
    }
    skeleton_->setVelocities(follow_ * v);
    // The body-fixed components of the base's velocity change as it rotates: d(R^T v)/dt = R^T (a - w x v).
    VectorX turned = a;
    const Vector3 linear = v.head<3>(), angular = v.segment<3>(3);
    turned.head<3>() -= angular.cross(linear);
    skeleton_->setAccelerations(follow_ * turned);
  }

  RobotModel model_;
  dart::dynamics::SkeletonPtr skeleton_;
  MatrixX follow_;
};

TEST_P(TwoRoads, FrameAndJacobian) {
  DynamicsScratch scratch(model_);
  RandomState random(11);
  MatrixX J(6, model_.nv()), J_C(3, model_.nv());
  for (int trial = 0; trial < 50; ++trial) {
    const VectorX q = random.Configuration(model_), v = random.Vector(model_.nv());
    Set(q, v, VectorX::Zero(model_.nv()));
    ForwardVelocities(model_, q, v, scratch);
    for (const Frame& frame : model_.frames) {
      const auto* body = skeleton_->getBodyNode(frame.name);
      ASSERT_NE(body, nullptr);
      const Pose X_WF = FramePose(scratch, frame.body, frame.X_BF);
      EXPECT_LT((X_WF.matrix() - body->getWorldTransform().matrix()).norm(), 1e-10) << frame.name;
      PointJacobian(model_, scratch, frame.body, frame.X_BF.translation(), J);
      MatrixX theirs(6, J.cols());
      const MatrixX wide = skeleton_->getWorldJacobian(body) * follow_;
      theirs << wide.bottomRows<3>(), wide.topRows<3>();
      EXPECT_LT((J - theirs).norm(), 1e-10) << frame.name;
    }
    EXPECT_LT((CentreOfMass(model_, scratch) - skeleton_->getCOM()).norm(), 1e-10);
    CentreOfMassJacobian(model_, scratch, J_C);
    const MatrixX theirs = skeleton_->getCOMLinearJacobian() * follow_;
    ASSERT_GT(theirs.rightCols(model_.num_dofs()).norm(), 0.01);
    EXPECT_LT((J_C - theirs).norm(), 1e-10);
  }
}

TEST_P(TwoRoads, MassMatrixAndInverseDynamics) {
  DynamicsScratch scratch(model_);
  RandomState random(13);
  MatrixX M;
  VectorX tau;
  for (int trial = 0; trial < 50; ++trial) {
    const VectorX q = random.Configuration(model_), v = random.Vector(model_.nv()), a = random.Vector(model_.nv());
    Set(q, v, a);
    MassMatrix(model_, q, scratch, M);
    EXPECT_LT((M - follow_.transpose() * skeleton_->getMassMatrix() * follow_).norm(), 1e-10);
    InverseDynamics(model_, q, v, a, scratch, tau);
    const VectorX theirs =
        skeleton_->getMassMatrix() * skeleton_->getAccelerations() + skeleton_->getCoriolisAndGravityForces();
    ASSERT_GT(tau.norm(), 1.0);
    EXPECT_LT((tau - follow_.transpose() * theirs).norm(), 1e-10 * tau.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, TwoRoads, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
