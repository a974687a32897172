// SPDX-License-Identifier: BSD-3-Clause
// Random trees: their poses by MuJoCo's rules from the random numbers are compared with those of the robot model that
// is loaded from their text.
#include <fmt/format.h>

#include <numbers>
#include <random>

#include "kinematics/description/mjcf_keyframe_internal.h"
#include "kinematics/model/body_tree.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

struct DrawnJoint {
  std::string name, type;
  Vector3 pos, axis;
  double ref = 0.0;
};

struct DrawnBody {
  int parent = -1;
  Vector3 pos;
  Quaternion quat;
  std::vector<DrawnJoint> joints;
};

std::string TextOf(const Vector3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

/// Bodies with zero to three joints each, hinges and slides, some with a reference position.
std::vector<DrawnBody> DrawTree(unsigned seed, bool balls) {
  RandomState random(seed);
  std::mt19937 engine(seed);
  std::vector<DrawnBody> bodies;
  for (int b = 0; b < 8; ++b) {
    DrawnBody body;
    body.parent = b == 0 ? -1 : static_cast<int>(engine() % static_cast<unsigned>(b));
    body.pos = random.Vector(3);
    body.quat = Quaternion(RotationExp(random.Vector(3)));
    const unsigned joints = b == 0 ? 0 : engine() % 4;
    for (unsigned j = 0; j < joints; ++j) {
      const char* const types[] = {"hinge", "slide", "ball"};
      DrawnJoint joint{fmt::format("j{}_{}", b, j), types[engine() % (balls ? 3 : 2)], random.Vector(3),
                       random.Vector(3), 0.0};
      if (joint.type != "ball" && engine() % 2 == 0) joint.ref = random.Vector(1)[0];
      body.joints.push_back(joint);
    }
    bodies.push_back(body);
  }
  return bodies;
}

/// The text of a body and of the bodies that it carries; angles are in degrees.
std::string BodyText(const std::vector<DrawnBody>& bodies, std::size_t b) {
  const DrawnBody& body = bodies[b];
  std::string text = fmt::format("<body name='b{}' pos='{}' quat='{} {} {} {}'>\n", b, TextOf(body.pos), body.quat.w(),
                                 body.quat.x(), body.quat.y(), body.quat.z());
  if (b == 0) text += "<freejoint/>\n";
  text += "<inertial pos='0.1 0.2 0.3' mass='1' diaginertia='0.1 0.2 0.25'/>\n";
  for (const DrawnJoint& joint : body.joints) {
    const double ref = joint.type == "hinge" ? joint.ref / kDegree : joint.ref;
    text += fmt::format("<joint name='{}' type='{}' pos='{}' axis='{}' ref='{}'/>\n", joint.name, joint.type,
                        TextOf(joint.pos), TextOf(joint.axis), ref);
  }
  for (std::size_t child = b + 1; child < bodies.size(); ++child) {
    if (bodies[child].parent == static_cast<int>(b)) text += BodyText(bodies, child);
  }
  return text + "</body>\n";
}

/// MuJoCo's rule: the body starts at its pose in the parent. Then each joint rotates it about its anchor, which the
/// previous joints have moved, or moves it along its axis.
Pose MoveByJoint(const DrawnJoint& joint, const Pose& X_WB, const Matrix3& turn, double q) {
  Pose moved = X_WB;
  if (joint.type == "slide") {
    moved.translation() += (q - joint.ref) * (X_WB.linear() * joint.axis.normalized());
    return moved;
  }
  const Vector3 anchor = X_WB * joint.pos;
  moved.linear() =
      X_WB.linear() *
      (joint.type == "ball" ? turn : Eigen::AngleAxisd(q - joint.ref, joint.axis.normalized()).toRotationMatrix());
  moved.translation() = anchor - moved.linear() * joint.pos;
  return moved;
}

void ExpectSamePoses(unsigned seed, bool balls) {
  const std::vector<DrawnBody> bodies = DrawTree(seed, balls);
  const RobotModel model = TreeOf(Converted("<mujoco><worldbody>" + BodyText(bodies, 0) + "</worldbody></mujoco>"));
  RandomState random(seed + 1000);
  for (int sample = 0; sample < 5; ++sample) {
    const VectorX q = random.Vector(model.num_dofs());
    const std::vector<Pose> X_OB = BodyPoses(model, q);
    std::vector<Pose> X_WB;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const DrawnBody& body = bodies[b];
      Pose X = Pose::Identity();
      Vector3 anchor = Vector3::Zero();  // anchor of the last joint, the origin of the link
      if (body.parent >= 0) {
        X.translation() = body.pos;
        X.linear() = body.quat.toRotationMatrix();
        X = X_WB[static_cast<std::size_t>(body.parent)] * X;
      }
      for (const DrawnJoint& joint : body.joints) {
        Matrix3 turn = Matrix3::Identity();
        double position = 0.0;
        if (joint.type == "ball") {
          for (int i = 0; i < 3; ++i)
            turn *=
                Eigen::AngleAxisd(q[model.DofIndex(joint.name + "_" + "xyz"[i])], Vector3::Unit(i)).toRotationMatrix();
        } else {
          position = q[model.DofIndex(joint.name)];
        }
        X = MoveByJoint(joint, X, turn, position);
        anchor = joint.pos;
      }
      X_WB.push_back(X);
      const Frame& frame = model.frames[static_cast<std::size_t>(model.FrameIndex(fmt::format("b{}", b)))];
      const Pose link = X_OB[static_cast<std::size_t>(frame.body)] * frame.X_BF;
      EXPECT_LT((link.translation() - X * anchor).norm(), 1e-12) << "seed " << seed << ", body " << b;
      EXPECT_LT((link.linear() - X.linear()).norm(), 1e-12) << "seed " << seed << ", body " << b;
    }
  }
}

TEST(MjcfKinematics, LinksAreWhereMuJoCoHasTheBodies) {
  for (unsigned seed = 1; seed <= 20; ++seed) ExpectSamePoses(seed, false);
}

TEST(MjcfKinematics, BallJointsTurnAboutTheirAnchor) {
  for (unsigned seed = 21; seed <= 40; ++seed) ExpectSamePoses(seed, true);
}

TEST(MjcfKinematics, InertiaStaysWhereItIsWhenTheAnchorMovesTheLink) {
  const RobotModel model = TreeOf(Converted(MjcfOf(MjcfBodyOf("leg",
                                                              "<joint name='j' pos='0.1 0.2 0.3' axis='0 1 0'/>"
                                                              "<geom type='sphere' size='0.1' pos='0 0 -0.5'/>",
                                                              "pos='1 0 0'"))));
  const Pose X_OB = BodyPoses(model, VectorX::Zero(1))[1];
  EXPECT_LT((X_OB.translation() - Vector3(1.1, 0.2, 0.3)).norm(), 1e-12);
  EXPECT_LT((X_OB * model.bodies[1].p_BC - Vector3(1.0, 0.0, -0.1)).norm(), 1e-12);
  ASSERT_EQ(model.collision_shapes.size(), 1U);
  EXPECT_LT(((X_OB * model.collision_shapes[0].X_BS).translation() - Vector3(1.0, 0.0, -0.5)).norm(), 1e-12);
}

TEST(MjcfKinematics, FramesMoveWhatStandsInThem) {
  const std::string inside =
      "<frame pos='0 0 1' euler='0 0 90'>\n<frame pos='1 0 0'>" +
      MjcfBodyOf("leg", "<frame pos='0 0 0.5' euler='90 0 0'><joint name='j' axis='0 1 0' pos='0 1 0'/></frame>") +
      "</frame></frame>";
  const RobotModel model = TreeOf(Converted(MjcfOf(inside)));
  // The body is at (0, 1, 1), turned by 90 degrees about z; the anchor in it at (0, 0, 0.5) + (0, 0, 1).
  EXPECT_LT((model.joints[0].X_PJ.translation() - Vector3(0, 1, 2.5)).norm(), 1e-12);
  EXPECT_LT((model.joints[0].axis_J - Vector3(0, 0, 1)).norm(), 1e-12);
}

TEST(MjcfKinematics, TurnsOfABallJointMakeUpItsRotation) {
  RandomState random(9);
  for (int i = 0; i < 100; ++i) {
    Matrix3 R = RotationExp(random.Vector(3));
    if (i % 5 == 0)
      R = RotationExp({0.1 * i, 0, 0}) * RotationExp({0, 0.5 * std::numbers::pi, 0}) * RotationExp({0, 0, 1});
    const Vector3 turns = MjcfTurns(R);
    const Matrix3 again =
        RotationExp({turns.x(), 0, 0}) * RotationExp({0, turns.y(), 0}) * RotationExp({0, 0, turns.z()});
    EXPECT_LT((again - R).norm(), 1e-12) << i;
  }
}

}  // namespace
}  // namespace gaitwright
