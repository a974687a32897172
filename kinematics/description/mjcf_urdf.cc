// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml2.h>

#include <cmath>
#include <set>

#include "kinematics/description/mjcf_write_internal.h"

namespace gaitwright {
namespace {

constexpr double kMjcfFarSlide = 1e3;  // [m] limit in both directions of a prismatic joint without a range

using MjcfXmlAttributes = std::vector<std::pair<std::string, std::string>>;

/// = Notation =
///   L  frame of the body's link      B  the body's frame      J  frame of a joint, and of its child link
class MjcfUrdfWriter {
 public:
  explicit MjcfUrdfWriter(const MjcfRobot& robot) : robot_(robot), X_LB_(robot.tree.bodies.size(), Pose::Identity()) {
    for (const MjcfBody& body : robot.tree.bodies) links_.insert(body.name);
    for (const MjcfJoint& joint : robot.tree.joints) joints_.insert(joint.name);
  }

  std::string Write() {
    Open("robot", {{"name", robot_.name.empty() ? "robot" : robot_.name}});
    for (std::size_t b = 0; b < robot_.tree.bodies.size(); ++b) {
      if (!robot_.tree.in_robot[b]) continue;
      if (static_cast<int>(b) != robot_.tree.root) WriteJoints(b);
      WriteLink(b);
    }
    Close();
    return xml_.CStr();
  }

 private:
  void Open(const char* name, const MjcfXmlAttributes& attributes = {}) {
    xml_.OpenElement(name);
    for (const auto& [key, value] : attributes) xml_.PushAttribute(key.c_str(), value.c_str());
  }
  void Close() { xml_.CloseElement(); }
  void Element(const char* name, const MjcfXmlAttributes& attributes) {
    Open(name, attributes);
    Close();
  }

  void WriteOrigin(const Pose& X) {
    if (X.matrix().isIdentity(0.0)) return;
    Element("origin", {{"xyz", MjcfText(X.translation())}, {"rpy", MjcfText(MjcfRollPitchYaw(X.linear()))}});
  }

  void WriteLink(std::size_t b) {
    Open("link", {{"name", robot_.tree.bodies[b].name}});
    const MjcfInertia& inertia = robot_.inertias[b];
    if (inertia.mass > 0.0) {
      const Matrix3 R = X_LB_[b].linear(), I = R * inertia.I_C * R.transpose();
      Open("inertial");
      Pose X_LC = Pose::Identity();
      X_LC.translation() = X_LB_[b] * inertia.p_BC;
      WriteOrigin(X_LC);
      Element("mass", {{"value", MjcfText(inertia.mass)}});
      Element("inertia", {{"ixx", MjcfText(I(0, 0))},
                          {"ixy", MjcfText(I(0, 1))},
                          {"ixz", MjcfText(I(0, 2))},
                          {"iyy", MjcfText(I(1, 1))},
                          {"iyz", MjcfText(I(1, 2))},
                          {"izz", MjcfText(I(2, 2))}});
      Close();
    }
    for (const MjcfUrdfShape& shape : robot_.visual[b]) WriteShape("visual", X_LB_[b], shape);
    for (const MjcfUrdfShape& shape : robot_.collision[b]) WriteShape("collision", X_LB_[b], shape);
    Close();
  }

  void WriteShape(const char* kind, const Pose& X_LB, const MjcfUrdfShape& shape) {
    Open(kind);
    WriteOrigin(X_LB * shape.X_BS);
    Open("geometry");
    Element(shape.element.c_str(), shape.attributes);
    Close();
    Close();
  }

  /// A name that is not used yet.
  static std::string Free(const std::string& stem, std::set<std::string>& taken) {
    std::string name = stem;
    for (int n = 2; !taken.insert(name).second; ++n) name = stem + "_" + std::to_string(n);
    return name;
  }

  /// The displacement of a joint from the pose of the file.
  static Pose Displacement(const MjcfJoint& joint, double position) {
    Pose X = Pose::Identity();
    if (joint.type == MjcfJointType::kHinge) X.linear() = Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
    if (joint.type == MjcfJointType::kSlide) X.translation() = position * joint.axis;
    return X;
  }

  /// Writes the joints from the link of the parent to the link of the body, with links between them.
  void WriteJoints(std::size_t b) {
    const MjcfBody& body = robot_.tree.bodies[b];
    const auto p = static_cast<std::size_t>(body.parent);
    std::string from = robot_.tree.bodies[p].name;
    Pose X = X_LB_[p] * body.X_PB;  // pose of B in the frame of the last link, with the following joints at ref
    std::size_t moving = 0;
    for (const int j : body.joints) moving += robot_.couplings[static_cast<std::size_t>(j)].locked ? 0U : 1U;
    for (const int j : body.joints) {
      const auto index = static_cast<std::size_t>(j);
      const MjcfJoint& joint = robot_.tree.joints[index];
      const Pose to_anchor = Pose(Eigen::Translation3d(joint.pos)), back = Pose(Eigen::Translation3d(-joint.pos));
      if (robot_.couplings[index].locked) {
        X = X * to_anchor * Displacement(joint, *robot_.couplings[index].locked - joint.ref) * back;
        continue;
      }
      const bool is_last = --moving == 0;
      const std::string to = is_last ? body.name : Free(body.name + "_before", links_);
      if (!is_last) Element("link", {{"name", to}});
      WriteJoint(index, from, to, X * to_anchor * Displacement(joint, -joint.ref));
      X = back;
      from = to;
    }
    if (from != body.name) {
      Open("joint", {{"name", Free(body.name + "_fixed", joints_)}, {"type", "fixed"}});
      WriteEnds(from, body.name);
      WriteOrigin(X);
      Close();
      X = Pose::Identity();
    }
    X_LB_[b] = X;
  }

  void WriteEnds(const std::string& from, const std::string& to) {
    Element("parent", {{"link", from}});
    Element("child", {{"link", to}});
  }

  void WriteJoint(std::size_t j, const std::string& from, const std::string& to, const Pose& X_LJ) {
    const MjcfJoint& joint = robot_.tree.joints[j];
    const bool is_free = joint.type == MjcfJointType::kHinge && !joint.range;
    const char* type = joint.type == MjcfJointType::kBall    ? "spherical"
                       : joint.type == MjcfJointType::kSlide ? "prismatic"
                       : is_free                             ? "continuous"
                                                             : "revolute";
    Open("joint", {{"name", joint.name}, {"type", type}});
    WriteEnds(from, to);
    WriteOrigin(X_LJ);
    MjcfXmlAttributes limit;
    if (joint.is_scalar()) {
      Element("axis", {{"xyz", MjcfText(joint.axis)}});
      if (!is_free) {
        const auto range = joint.range.value_or(std::pair(-kMjcfFarSlide, kMjcfFarSlide));
        limit = {{"lower", MjcfText(range.first)}, {"upper", MjcfText(range.second)}};
      }
    }
    constexpr double kNoLimit = 1e6;  // [N m, N] more than any motor has
    limit.emplace_back("effort", MjcfText(std::isfinite(robot_.efforts[j]) ? robot_.efforts[j] : kNoLimit));
    limit.emplace_back("velocity", "0");  // not known
    Element("limit", limit);
    if (joint.damping > 0.0 || joint.friction > 0.0)
      Element("dynamics", {{"damping", MjcfText(joint.damping)}, {"friction", MjcfText(joint.friction)}});
    if (const MjcfCoupling& follows = robot_.couplings[j]; follows.leader >= 0)
      Element("mimic", {{"joint", robot_.tree.joints[static_cast<std::size_t>(follows.leader)].name},
                        {"multiplier", MjcfText(follows.multiplier)},
                        {"offset", MjcfText(follows.offset)}});
    Close();
  }

  const MjcfRobot& robot_;
  std::vector<Pose> X_LB_;
  std::set<std::string> links_, joints_;
  tinyxml2::XMLPrinter xml_;
};

}  // namespace

std::string WriteMjcfUrdf(const MjcfRobot& robot) { return MjcfUrdfWriter(robot).Write(); }

}  // namespace gaitwright
