// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/robot_laws.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "kinematics/base/text.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/describe.h"
#include "kinematics/spatial/convex_hull.h"
#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {
namespace {

bool IsIn(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

bool IsPose(const Pose& X) {
  return X.matrix().allFinite() && (X.linear() * X.linear().transpose() - Matrix3::Identity()).norm() < 1e-6;
}

void CheckBodies(const RobotModel& model) {
  Require(model.bodies.size() == model.joints.size() + 1, "each joint carries a body");
  for (const Body& body : model.bodies) {
    Require(std::isfinite(body.mass) && body.mass >= 0.0, "a mass is finite and not negative");
    Require(body.p_BC.allFinite() && body.I_C.allFinite(), "inertias are finite");
    const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(body.I_C, Eigen::EigenvaluesOnly).eigenvalues();
    Require(moments[0] >= -1e-5 * std::max(moments[2], 1e-9), "principal moments are not negative");
  }
  Require(std::isfinite(model.total_mass_kg) && model.total_mass_kg > 0.0, "a robot weighs something");
}

void CheckJoints(const RobotModel& model) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    Require(IsIn(joint.parent_body, j + 1), "parents come before children");
    Require(IsPose(joint.X_PJ) && std::abs(joint.axis_J.norm() - 1.0) < 1e-6, "joints have a place and a unit axis");
    Require(joint.lower <= joint.upper, "limits are in order");
    Require(std::isfinite(joint.velocity_limit) && std::isfinite(joint.effort_limit), "limits are finite");
    Require(joint.damping >= 0.0 && joint.friction >= 0.0, "friction is not negative");
    Require(IsIn(joint.dof, model.dof_names.size()), "each joint has a coordinate");
    Require(std::isfinite(joint.multiplier) && joint.multiplier != 0.0 && std::isfinite(joint.offset),
            "joints move with their coordinates");
    Require(!joint.name.empty() && IsPlainText(joint.name), "names are printable");
  }
  for (const Frame& frame : model.frames) {
    Require(IsIn(frame.body, model.bodies.size()) && IsPose(frame.X_BF), "frames are in bodies");
    Require(IsPlainText(frame.name), "names are printable");
  }
  for (const Shape& shape : model.collision_shapes)
    Require(IsIn(shape.body, model.bodies.size()) && IsPose(shape.X_BS) && shape.size.allFinite(),
            "shapes have a size");
}

void CheckLegs(const RobotModel& model) {
  Require(!model.legs.empty() && model.legs.size() <= 64 && model.legs.size() <= model.feet.size() &&
              model.feet.size() <= 64,
          "there are legs; their feet come before other support bodies, and a set of feet can contain all of them");
  for (const Leg& leg : model.legs) {
    Require(IsIn(leg.foot, model.legs.size()) && !leg.joints.empty(), "legs have feet and joints");
    for (const int joint : leg.joints) Require(IsIn(joint, model.joints.size()), "the joints of legs exist");
    Require(leg.mirror == -1 || IsIn(leg.mirror, model.legs.size()), "mirrors are legs");
    Require(std::isfinite(leg.length_m) && leg.length_m >= 0.0, "legs have a length");
  }
  for (const Foot& foot : model.feet) {
    Require(IsIn(foot.body, model.bodies.size()) && IsPose(foot.X_BF), "feet are on bodies");
    Require(std::isfinite(foot.radius) && foot.radius >= 0.0, "feet have a radius that is not negative");
    for (const Vector2& corner : foot.sole_F) Require(corner.allFinite(), "soles are finite");
    Require(!foot.has_sole() || Area(foot.sole_F) > 0.0, "soles run counter-clockwise around an area");
  }
}

void CheckPosture(const RobotModel& model) {
  const int n = model.num_dofs();
  Require(model.standing_joints.size() == n && model.stiffness.size() == n && model.damping.size() == n &&
              model.motors.size() == static_cast<std::size_t>(n),
          "there is one value for each coordinate");
  Require(model.standing_joints.allFinite(), "the standing posture is finite");
  for (int dof = 0; dof < n; ++dof) {
    const Motor& motor = model.MotorOf(dof);
    Require(motor.corner_speed > 0.0 && motor.no_load_speed > 0.0 && motor.continuous_effort > 0.0 &&
                motor.rotor_inertia >= 0.0,
            "values of a motor are positive");
  }
  for (const Transmission& t : model.transmissions) {
    for (const int dof : t.dofs) Require(IsIn(dof, model.dof_names.size()), "transmissions drive coordinates");
    Require(t.motors.size() == t.dofs.size() && (t.ratios * t.inverse).isIdentity(1e-6),
            "motors and joints of a transmission move each other");
  }
  Require(std::isfinite(model.standing_base_height_m) && std::isfinite(model.nominal_speed_m_s) &&
              model.nominal_speed_m_s >= 0.0,
          "height and speed are finite");
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    Require(scratch.p_WB[b].allFinite() && scratch.R_WB[b].allFinite(), "forward kinematics is finite");
  Require(CentreOfMass(model, scratch).allFinite(), "the centre of mass is finite");
}

}  // namespace

void CheckRobotLaws(const RobotModel& model) {
  CheckBodies(model);
  CheckJoints(model);
  CheckLegs(model);
  CheckPosture(model);
  Require(IsPlainText(DescribeRobot(model)) && !RobotJson(model).empty(), "a robot can be described");
}

void CheckMeshLaws(const Mesh& mesh) {
  Require(!mesh.triangles.empty(), "a mesh has triangles");
  for (const Vector3& v : mesh.vertices) Require(v.allFinite(), "points are finite");
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (const int corner : triangle) Require(IsIn(corner, mesh.vertices.size()), "triangles are of points");
  }
  const std::vector<Vector3> hull = HullPoints(mesh.vertices);
  Require(!hull.empty() && hull.size() <= 1024, "a hull is of few points");
}

}  // namespace gaitwright::fuzz
