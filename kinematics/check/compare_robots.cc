// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/check/compare_robots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "kinematics/check/check_parts_internal.h"
#include "kinematics/model/body_tree.h"

namespace gaitwright {
namespace {

constexpr double kAlikeLength = 0.001;      // [m]
constexpr double kAlikeShareOfLeg = 0.002;  // share of the leg's length, if this is more
constexpr double kAlikeAngle = 0.01;        // [rad]
constexpr double kAlikeInertia = 0.02;      // share of the larger inertia

/// One body of two descriptions, both in the base frame O at joint positions zero.
struct BodyPair {
  RobotPart part;
  const Body &a, &b;
  Pose X_OA, X_OB;
};

/// Compares two descriptions and collects the differences.
class Comparison {
 public:
  Comparison(const RobotModel& a, const RobotModel& b)
      : a_(a),
        b_(b),
        X_OA_(BodyPoses(a, VectorX::Zero(a.num_dofs()))),
        X_OB_(BodyPoses(b, VectorX::Zero(b.num_dofs()))),
        length_(std::max(kAlikeLength, kAlikeShareOfLeg * a.leg_length_m())) {}

  std::vector<Finding> Run() {
    Numbers({}, "mass", a_.total_mass_kg, b_.total_mass_kg, " kg");
    FindOffset();
    Bodies({RobotPart{PartKind::kLink, a_.bodies[0].name}, a_.bodies[0], b_.bodies[0], X_OA_[0], X_OB_[0]});
    for (std::size_t j = 0; j < a_.joints.size(); ++j) {
      if (const int other = IndexIn(b_, a_.joints[j].name); other >= 0) Joints(j, static_cast<std::size_t>(other));
    }
    for (int dof = 0; dof < a_.num_dofs(); ++dof) Limits(dof);
    Transmissions();
    for (const std::string& name : b_.dof_names) {
      if (std::find(a_.dof_names.begin(), a_.dof_names.end(), name) == a_.dof_names.end())
        Add(RobotPart{PartKind::kJoint, name}, "it exists only in the other robot");
    }
    return findings_;
  }

 private:
  static int IndexIn(const RobotModel& model, const std::string& joint) {
    const auto found =
        std::find_if(model.joints.begin(), model.joints.end(), [&](const Joint& j) { return j.name == joint; });
    return found == model.joints.end() ? -1 : static_cast<int>(found - model.joints.begin());
  }

  void Add(const RobotPart& part, const std::string& message) {
    findings_.push_back({FindingLevel::kWarning, FailureCode::kDescriptionsDiffer, part, 0, message});
  }

  void Numbers(const RobotPart& part, const char* what, double of_a, double of_b, const char* unit) {
    if (!NumbersDiffer(of_a, of_b)) return;
    if (!std::isfinite(of_a))
      Add(part, fmt::format("its {} is unknown here and is {:.4g}{} in the other robot", what, of_b, unit));
    else if (!std::isfinite(of_b))
      Add(part, fmt::format("its {} is {:.4g}{} here and unknown in the other robot", what, of_a, unit));
    else
      Add(part, fmt::format("its {} is {:.4g}{} here and {:.4g}{} in the other robot", what, of_a, unit, of_b, unit));
  }

  /// Finds the origin of b's base frame in that of a: the median over the joints of both.
  void FindOffset() {
    std::array<std::vector<double>, 3> apart;
    for (std::size_t j = 0; j < a_.joints.size(); ++j) {
      const int other = IndexIn(b_, a_.joints[j].name);
      if (other < 0) continue;
      const Vector3 p = X_OA_[j + 1].translation() - X_OB_[static_cast<std::size_t>(other) + 1].translation();
      for (std::size_t axis = 0; axis < 3; ++axis) apart[axis].push_back(p[static_cast<Eigen::Index>(axis)]);
    }
    for (std::size_t axis = 0; axis < 3 && !apart[axis].empty(); ++axis) {
      const auto middle = apart[axis].begin() + static_cast<std::ptrdiff_t>(apart[axis].size() / 2);
      std::nth_element(apart[axis].begin(), middle, apart[axis].end());
      offset_[static_cast<Eigen::Index>(axis)] = *middle;
    }
  }

  void Places(const RobotPart& part, const char* what, const Vector3& p_a, const Vector3& p_b) {
    const double distance = (p_b + offset_ - p_a).norm();
    if (distance > length_)
      Add(part, fmt::format("its {} differs by {:.4g} mm in the other robot", what, 1e3 * distance));
  }

  void Bodies(const BodyPair& pair) {
    if (NumbersDiffer(pair.a.mass, pair.b.mass)) {
      Numbers(pair.part, "link's mass", pair.a.mass, pair.b.mass, " kg");
      return;
    }
    if (pair.a.mass <= 0.0) return;
    Places(pair.part, "link's centre of mass", pair.X_OA * pair.a.p_BC, pair.X_OB * pair.b.p_BC);
    const Matrix3 I_a = pair.X_OA.linear() * pair.a.I_C * pair.X_OA.linear().transpose();
    const Matrix3 I_b = pair.X_OB.linear() * pair.b.I_C * pair.X_OB.linear().transpose();
    const double size = std::max(I_a.norm(), I_b.norm());
    if ((I_b - I_a).norm() > kAlikeInertia * size + pair.a.mass * length_ * length_)
      Add(pair.part,
          fmt::format("its link's inertia differs by {:.3g} % in the other robot", 100.0 * (I_b - I_a).norm() / size));
  }

  void Joints(std::size_t j, std::size_t other) {
    const RobotPart part{PartKind::kJoint, a_.joints[j].name};
    const Pose &X_a = X_OA_[j + 1], &X_b = X_OB_[other + 1];
    Places(part, "place", X_a.translation(), X_b.translation());
    const Vector3 u_a = X_a.linear() * a_.joints[j].axis_J, u_b = X_b.linear() * b_.joints[other].axis_J;
    const double angle = std::atan2(u_a.cross(u_b).norm(), u_a.dot(u_b));
    if (angle > kAlikeAngle) Add(part, fmt::format("its axis differs by {:.3g} rad in the other robot", angle));
    Bodies({part, a_.bodies[j + 1], b_.bodies[other + 1], X_a, X_b});
  }

  void Transmissions() {
    const auto find = [](const std::vector<Transmission>& all, const std::string& name) {
      return std::find_if(all.begin(), all.end(), [&](const Transmission& t) { return t.name == name; });
    };
    for (const Transmission& of_a : a_.transmissions) {
      const auto of_b = find(b_.transmissions, of_a.name);
      const RobotPart part{PartKind::kTransmission, of_a.name};
      if (of_b == b_.transmissions.end()) {
        Add(part, "it exists only in this robot");
      } else if (of_a.ratios.rows() != of_b->ratios.rows() || !of_a.ratios.isApprox(of_b->ratios, 1e-9)) {
        Add(part, "its ratios differ between the two robots");
      }
    }
    for (const Transmission& of_b : b_.transmissions) {
      if (find(a_.transmissions, of_b.name) == a_.transmissions.end())
        Add(RobotPart{PartKind::kTransmission, of_b.name}, "it exists only in the other robot");
    }
  }

  void Limits(int dof) {
    const std::string& name = a_.dof_names[static_cast<std::size_t>(dof)];
    const RobotPart part{PartKind::kJoint, name};
    const auto other = std::find(b_.dof_names.begin(), b_.dof_names.end(), name);
    if (other == b_.dof_names.end()) return Add(part, "it exists only in this robot");
    const int there = static_cast<int>(other - b_.dof_names.begin());
    const bool slides = a_.LeaderOf(dof).is_prismatic();
    if (slides != b_.LeaderOf(there).is_prismatic())
      return Add(part, slides ? "it is prismatic here and revolute in the other robot"
                              : "it is revolute here and prismatic in the other robot");
    const char* unit = slides ? " m" : " rad";
    Numbers(part, "lower limit", a_.dof_lower(dof), b_.dof_lower(there), unit);
    Numbers(part, "upper limit", a_.dof_upper(dof), b_.dof_upper(there), unit);
    Numbers(part, "effort limit", a_.dof_effort_limit(dof), b_.dof_effort_limit(there), slides ? " N" : " N m");
    if (std::isfinite(a_.dof_velocity_limit(dof)) && std::isfinite(b_.dof_velocity_limit(there)))
      Numbers(part, "speed limit", a_.dof_velocity_limit(dof), b_.dof_velocity_limit(there),
              slides ? " m/s" : " rad/s");
  }

  const RobotModel &a_, &b_;
  const std::vector<Pose> X_OA_, X_OB_;
  const double length_;
  Vector3 offset_ = Vector3::Zero();
  std::vector<Finding> findings_;
};

}  // namespace

bool NumbersDiffer(double a, double b) {
  constexpr double kAlike = 0.01;  // share by which two numbers that should be equal may differ
  if (!std::isfinite(a) || !std::isfinite(b)) return std::isfinite(a) != std::isfinite(b);
  return std::abs(a - b) > kAlike * std::max(std::abs(a), std::abs(b)) + 1e-9;
}

std::vector<Finding> CompareRobots(const RobotModel& a, const RobotModel& b) { return Comparison(a, b).Run(); }

}  // namespace gaitwright
