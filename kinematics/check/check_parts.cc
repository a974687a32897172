// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/check/check_parts_internal.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/passive_joints.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {
namespace {

/// Limits of the radius of gyration over the diameter of a body. A homogeneous ball has 0.32, a thin ring 0.5, and no
/// body inside a sphere has more than 0.71. Joints and frames show the size less reliably than shapes: those of an
/// ankle may all be at one point.
constexpr double kWidestOfShapes = 0.75, kWidestOfFrames = 2.0, kNarrowest = 0.01;
constexpr double kSteel = 8000.0;      // [kg/m^3] shapes with a higher density show only a part of the body
constexpr double kLoosest = 100.0;     // [kg/m^3] density of a cube with the largest likely size for its mass
constexpr double kOfAccount = 0.01;    // share of the robot's mass
constexpr double kOfNoAccount = 1e-4;  // share of the robot's mass below which no inertia matters
constexpr double kHeavyWithoutShape = 0.1;

/// Diameter of the known parts of a body: its shapes, else its joints, frames and mass; 0 if all its shapes are meshes
/// that are not read, such as visual ones. @param shaped  set to whether the diameter is that of shapes.
double DiameterOf(const RobotModel& model, int body, bool& shaped) {
  std::vector<Vector3> points;
  bool unread = false;
  const auto add = [&](const std::vector<Shape>& shapes) {
    for (const Shape& shape : shapes) {
      if (shape.body != body) continue;
      if (shape.type == ShapeType::kMesh && shape.vertices.empty()) {
        unread = true;
        continue;
      }
      for (int i = 0; i < 6; ++i) {
        const Vector3 d_S = (i < 3 ? 1.0 : -1.0) * Vector3::Unit(i % 3);
        points.push_back(shape.X_BS * SupportPoint(shape, d_S));
      }
    }
  };
  add(model.collision_shapes);
  add(model.visual_shapes);
  shaped = !points.empty();
  if (!shaped && unread) return 0.0;
  const Body& of = model.bodies[static_cast<std::size_t>(body)];
  if (!shaped) {
    points.push_back(Vector3::Zero());
    points.push_back(of.p_BC);
  }
  for (const Joint& joint : model.joints) {
    if (joint.parent_body == body) points.push_back(joint.X_PJ.translation());
  }
  for (const Frame& frame : model.frames) {
    if (frame.body == body) points.push_back(frame.X_BF.translation());
  }
  double diameter = 0.0;
  for (const Vector3& p : points) {
    for (const Vector3& q : points) diameter = std::max(diameter, (p - q).norm());
  }
  constexpr double kLightest = 300.0;  // [kg/m^3] density of a ball with the largest likely size for its mass
  if (!shaped && diameter > 0.0) {
    diameter = std::max(diameter, std::cbrt(6.0 * of.mass / (std::numbers::pi * kLightest)));
  }
  return diameter;
}

/// The known size of a body.
struct KnownSize {
  double diameter = 0.0;         ///< of its shapes, or of its joints and frames [m]
  bool shaped = false;           ///< its shapes are large enough for its mass
  double widest_gyration = 0.0;  ///< largest plausible radius of gyration [m]
};

KnownSize SizeOfBody(const RobotModel& model, int body) {
  KnownSize size;
  const double mass = model.bodies[static_cast<std::size_t>(body)].mass;
  size.diameter = DiameterOf(model, body, size.shaped);
  size.shaped = size.shaped && mass <= kSteel * std::numbers::pi / 6.0 * std::pow(size.diameter, 3);
  size.widest_gyration = size.shaped ? kWidestOfShapes * size.diameter
                                     : std::max(kWidestOfFrames * size.diameter, std::cbrt(mass / kLoosest));
  return size;
}

}  // namespace

void CheckBodies(const RobotModel& model, std::vector<Finding>& findings) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    const auto add = [&](FindingLevel level, FailureCode code, const std::string& message) {
      findings.push_back({level, code, RobotPart{PartKind::kLink, body.name}, 0, message});
    };
    const bool collides = std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(),
                                      [&](const Shape& shape) { return shape.body == static_cast<int>(b); });
    if (body.mass <= 0.0) {
      if (collides) add(FindingLevel::kWarning, FailureCode::kShapeWithoutMass, "it has a collision shape but no mass");
      continue;
    }
    if (!collides && body.mass > kHeavyWithoutShape * model.total_mass_kg)
      add(FindingLevel::kInfo, FailureCode::kMassWithoutShape,
          fmt::format("it has {:.3g} kg but no collision shape, so nothing can touch it", body.mass));
    const double gyration = std::sqrt(0.5 * body.I_C.trace() / body.mass);
    const KnownSize size = SizeOfBody(model, static_cast<int>(b));
    if (gyration > size.widest_gyration && body.mass > kOfNoAccount * model.total_mass_kg) {
      add(FindingLevel::kWarning, FailureCode::kLargeInertia,
          fmt::format("its radius of gyration is {:.3g} m at {:.3g} kg, too large for {}; the inertia may be in a "
                      "wrong unit, or not about the centre of mass",
                      gyration, body.mass,
                      size.shaped
                          ? fmt::format("shapes that are {:.3g} m across", size.diameter)
                          : fmt::format("a link of this mass without usable shapes (at most {:.3g} m is likely)",
                                        size.widest_gyration)));
    } else if (gyration < kNarrowest * size.diameter && body.mass > kOfAccount * model.total_mass_kg) {
      add(FindingLevel::kWarning, FailureCode::kSmallInertia,
          fmt::format(
              "its radius of gyration is {:.2g} m at {:.3g} kg, though it is {:.3g} m long: its inertia is nearly "
              "zero",
              gyration, body.mass, size.diameter));
    }
  }
}

void CheckRanges(const RobotModel& model, std::vector<Finding>& findings) {
  constexpr double kTurns = 4.0 * std::numbers::pi, kDegrees = 720.0;  // [rad], [deg]
  constexpr std::size_t kFewest = 2;                                   // joints; one may be a winch
  std::vector<const Joint*> wide;
  for (const Joint& joint : model.joints) {
    const double largest = std::max(std::abs(joint.lower), std::abs(joint.upper));
    if (!joint.is_prismatic() && joint.upper - joint.lower > kTurns && largest <= kDegrees) wide.push_back(&joint);
  }
  if (wide.size() < kFewest) return;
  for (const Joint* joint : wide) {
    findings.push_back(
        {FindingLevel::kWarning, FailureCode::kBadLimit, RobotPart{PartKind::kJoint, joint->name}, 0,
         fmt::format("its range is {:.4g} to {:.4g} rad, which is {:.0f} turns; the file may give it in "
                     "degrees",
                     joint->lower, joint->upper, (joint->upper - joint->lower) / (2.0 * std::numbers::pi))});
  }
}

void CheckMotors(const RobotModel& model, std::vector<Finding>& findings) {
  constexpr double kLargestPower = 5e4;  // [W] torque times speed of one joint
  constexpr double kStrongest = 5.0;     // times the torque that lifts the whole robot at the length of a leg
  constexpr double kFastest = 100.0;     // [rad/s]
  const std::vector<int> leg_of = LegsOfDofs(model);
  const double lift = model.weight_n() * model.leg_length_m();
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const Joint& joint = model.LeaderOf(dof);
    const RobotPart part{PartKind::kJoint, joint.name};
    const bool of_leg = leg_of[static_cast<std::size_t>(dof)] >= 0;
    const double effort = model.dof_effort_limit(dof), speed = model.dof_velocity_limit(dof);
    const auto add = [&](FindingLevel level, FailureCode code, const std::string& message) {
      findings.push_back({level, code, part, 0, message});
    };
    if (!std::isfinite(effort)) {
      if (IsPassive(model, dof))
        add(of_leg ? FindingLevel::kWarning : FindingLevel::kInfo, FailureCode::kNoMotor,
            of_leg ? "its torque limit is 0: it has no motor"
                   : "its torque limit is 0: it is held in its standing position");
      else if (of_leg)
        add(FindingLevel::kInfo, FailureCode::kUnknownEffort, "its torque limit is unknown and not checked");
      continue;
    }
    if (joint.is_prismatic()) continue;
    if (effort > kStrongest * lift)
      add(FindingLevel::kWarning, FailureCode::kStrongMotor,
          fmt::format("its torque limit is {:.4g} N m; lifting the whole robot at its leg length takes {:.3g} N m",
                      effort, lift));
    if (of_leg && joint.velocity_limit_is_placeholder && joint.velocity_limit > 0.0)
      add(FindingLevel::kInfo, FailureCode::kFastMotor,
          fmt::format("its speed limit of {:.4g} rad/s is a placeholder and is not checked", joint.velocity_limit));
    if (std::isfinite(speed) && speed > kFastest)
      add(FindingLevel::kWarning, FailureCode::kFastMotor,
          fmt::format("its speed limit is {:.4g} rad/s; few joints reach 60 rad/s", speed));
    if (std::isfinite(speed) && effort * speed > kLargestPower)
      add(FindingLevel::kWarning, FailureCode::kStrongMotor,
          fmt::format("its torque limit times its speed limit is {:.0f} kW, more than a motor has",
                      1e-3 * effort * speed));
    if (std::isfinite(speed) && of_leg && speed < 0.1)
      add(FindingLevel::kWarning, FailureCode::kSlowMotor,
          fmt::format("its speed limit is {:.3g} rad/s, too slow to step", speed));
  }
}

}  // namespace gaitwright
