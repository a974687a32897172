// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/urdf_check.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

const std::vector<std::string> kSupportedJoints = {"revolute", "continuous", "prismatic", "fixed"};

[[noreturn]] void Refuse(const std::string& code, const std::string& message, std::vector<std::string> hints = {}) {
  throw Failure{FailureKind::kBadInput, code, "LoadRobot", message, std::move(hints)};
}

std::string Attribute(const XMLElement& element, const char* name, const std::string& owner) {
  const char* text = element.Attribute(name);
  if (text == nullptr) Refuse("urdf_missing", fmt::format("{}: <{}> has no '{}'", owner, element.Name(), name));
  return text;
}

std::vector<double> Numbers(const std::string& text, std::size_t count, const std::string& owner) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double value = 0.0;
    const char* begin = word.data() + (word.front() == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
      Refuse("urdf_number", fmt::format("{}: '{}' is not a finite number", owner, word));
    }
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    Refuse("urdf_number", fmt::format("{}: '{}' holds {} numbers, {} are needed", owner, text, numbers.size(), count));
  }
  return numbers;
}

double Number(const XMLElement& element, const char* name, const std::string& owner) {
  return Numbers(Attribute(element, name, owner), 1, owner + ", " + name).front();
}

void CheckOrigin(const XMLElement& parent, const std::string& owner) {
  const XMLElement* origin = parent.FirstChildElement("origin");
  if (origin == nullptr) return;
  for (const char* name : {"xyz", "rpy"}) {
    if (origin->Attribute(name) != nullptr) Numbers(origin->Attribute(name), 3, owner + ", origin " + name);
  }
}

void CheckInertial(const XMLElement& link, const std::string& owner) {
  const XMLElement* inertial = link.FirstChildElement("inertial");
  if (inertial == nullptr) return;
  CheckOrigin(*inertial, owner);
  const XMLElement* mass = inertial->FirstChildElement("mass");
  const XMLElement* inertia = inertial->FirstChildElement("inertia");
  if (mass == nullptr || inertia == nullptr) {
    Refuse("urdf_missing", fmt::format("{}: <inertial> needs <mass> and <inertia>", owner));
  }
  const double m = Number(*mass, "value", owner);
  if (m < 0.0) Refuse("negative_mass", fmt::format("{}: its mass is {} kg; zero or more is accepted", owner, m));
  const auto I = [&](const char* name) { return Number(*inertia, name, owner); };
  Matrix3 tensor;
  tensor << I("ixx"), I("ixy"), I("ixz"), I("ixy"), I("iyy"), I("iyz"), I("ixz"), I("iyz"), I("izz");
  const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  const double slack = 1e-6 * std::max(moments.cwiseAbs().maxCoeff(), 1e-12);
  if (moments[0] < -slack) {
    Refuse("impossible_inertia",
           fmt::format("{}: its inertia has the negative principal moment {:.3g} kg m^2", owner, moments[0]));
  }
  if (moments[0] + moments[1] < moments[2] - slack) {
    Refuse("impossible_inertia",
           fmt::format("{}: its inertia breaks the triangle inequality: {:.4g} + {:.4g} < {:.4g} kg m^2", owner,
                       moments[0], moments[1], moments[2]));
  }
}

void CheckGeometry(const XMLElement& link, const std::string& owner) {
  for (const char* kind : {"visual", "collision"}) {
    for (const XMLElement* e = link.FirstChildElement(kind); e != nullptr; e = e->NextSiblingElement(kind)) {
      CheckOrigin(*e, owner);
      const XMLElement* geometry = e->FirstChildElement("geometry");
      const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
      if (shape == nullptr) Refuse("urdf_missing", fmt::format("{}: <{}> has no geometry", owner, kind));
      const std::string type = shape->Name();
      std::vector<double> sizes;
      if (type == "box") {
        sizes = Numbers(Attribute(*shape, "size", owner), 3, owner + ", box size");
      } else if (type == "sphere") {
        sizes = {Number(*shape, "radius", owner)};
      } else if (type == "cylinder" || type == "capsule") {
        sizes = {Number(*shape, "radius", owner), Number(*shape, "length", owner)};
      } else if (type != "mesh") {
        Refuse("urdf_geometry", fmt::format("{}: geometry '{}' is not known; there are 'box', 'cylinder', 'sphere', "
                                            "'capsule', 'mesh'",
                                            owner, type));
      }
      for (const double size : sizes) {
        if (size <= 0.0)
          Refuse("urdf_geometry", fmt::format("{}: a {} has the size {}; it must be positive", owner, type, size));
      }
    }
  }
}

/// What the joints say of the tree.
struct Tree {
  std::set<std::string> links;
  std::vector<std::string> link_names, joint_names;
  std::map<std::string, std::string> parent_of;  // by child link
  std::map<std::string, std::string> joint_of;   // by child link
};

void CheckLimits(const XMLElement& joint, const std::string& type, const std::string& owner) {
  const XMLElement* axis = joint.FirstChildElement("axis");
  if (axis != nullptr) {
    const auto a = Numbers(Attribute(*axis, "xyz", owner), 3, owner + ", axis");
    if (std::hypot(a[0], a[1], a[2]) < 1e-9) Refuse("zero_axis", fmt::format("{}: its axis is zero", owner));
  }
  const XMLElement* limit = joint.FirstChildElement("limit");
  if (limit == nullptr) {
    if (type == "continuous") return;
    Refuse("missing_limit", fmt::format("{}: a {} joint needs a <limit>", owner, type));
  }
  for (const char* name : {"effort", "velocity"}) {
    if (Number(*limit, name, owner) < 0.0)
      Refuse("bad_limit", fmt::format("{}: its {} limit is negative", owner, name));
  }
  if (type == "continuous") return;
  const double lower = limit->Attribute("lower") != nullptr ? Number(*limit, "lower", owner) : 0.0;
  const double upper = limit->Attribute("upper") != nullptr ? Number(*limit, "upper", owner) : 0.0;
  if (lower > upper)
    Refuse("bad_limit", fmt::format("{}: its lower limit {} is over its upper limit {}", owner, lower, upper));
}

void CheckJoint(const XMLElement& joint, Tree& tree) {
  const std::string name = Attribute(joint, "name", "a joint");
  const std::string owner = fmt::format("joint '{}'", name);
  if (std::count(tree.joint_names.begin(), tree.joint_names.end(), name) > 0) {
    Refuse("double_name", fmt::format("{}: there are two joints of that name", owner));
  }
  tree.joint_names.push_back(name);
  const std::string type = Attribute(joint, "type", owner);
  if (std::find(kSupportedJoints.begin(), kSupportedJoints.end(), type) == kSupportedJoints.end()) {
    Refuse("joint_type",
           fmt::format("{}: type '{}' is not supported; there are {}", owner, type, QuotedList(kSupportedJoints)));
  }
  CheckOrigin(joint, owner);
  std::string ends[2];
  for (int i = 0; i < 2; ++i) {
    const char* tag = i == 0 ? "parent" : "child";
    const XMLElement* end = joint.FirstChildElement(tag);
    if (end == nullptr) Refuse("urdf_missing", fmt::format("{}: it has no <{}>", owner, tag));
    ends[i] = Attribute(*end, "link", owner);
    if (!tree.links.contains(ends[i])) {
      Refuse("unknown_link", fmt::format("{}: its {} '{}' is no link; the nearest is '{}'", owner, tag, ends[i],
                                         NearestName(ends[i], tree.link_names)));
    }
  }
  if (tree.parent_of.contains(ends[1])) {
    Refuse("urdf_loop",
           fmt::format("link '{}' has two parent joints, '{}' and '{}': a closed loop; the joints must form a tree",
                       ends[1], tree.joint_of[ends[1]], name));
  }
  tree.parent_of[ends[1]] = ends[0];
  tree.joint_of[ends[1]] = name;
  if (type != "fixed") CheckLimits(joint, type, owner);
}

void CheckMimics(const XMLElement& robot, const Tree& tree) {
  for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const XMLElement* mimic = joint->FirstChildElement("mimic");
    if (mimic == nullptr) continue;
    const std::string owner = fmt::format("joint '{}'", joint->Attribute("name"));
    const std::string target = Attribute(*mimic, "joint", owner);
    if (std::count(tree.joint_names.begin(), tree.joint_names.end(), target) == 0) {
      Refuse("unknown_mimic", fmt::format("{}: it mimics '{}', which is no joint; the nearest is '{}'", owner, target,
                                          NearestName(target, tree.joint_names)));
    }
  }
}

void CheckRoots(const Tree& tree) {
  std::vector<std::string> roots;
  for (const std::string& link : tree.link_names) {
    if (!tree.parent_of.contains(link)) roots.push_back(link);
  }
  if (roots.size() > 1) {
    Refuse("urdf_roots", fmt::format("the links {} have no parent: one root is needed", QuotedList(roots)));
  }
  for (const std::string& link : tree.link_names) {
    std::string at = link;
    std::set<std::string> seen;
    while (tree.parent_of.contains(at)) {
      if (!seen.insert(at).second)
        Refuse("urdf_loop", fmt::format("link '{}' is part of a cycle of joints: a closed loop", link));
      at = tree.parent_of.at(at);
    }
  }
}

void CheckDocument(const std::string& urdf_text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(urdf_text.c_str(), urdf_text.size()) != tinyxml2::XML_SUCCESS) {
    Refuse("not_xml", fmt::format("the URDF is not XML: line {}: {}", document.ErrorLineNum(), document.ErrorName()));
  }
  const XMLElement* robot = document.RootElement();
  if (robot == nullptr || std::strcmp(robot->Name(), "robot") != 0) {
    Refuse("not_urdf",
           fmt::format("the root element is <{}>; a URDF has <robot>", robot == nullptr ? "" : robot->Name()));
  }
  Tree tree;
  for (const XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const std::string name = Attribute(*link, "name", "a link");
    const std::string owner = fmt::format("link '{}'", name);
    if (!tree.links.insert(name).second)
      Refuse("double_name", fmt::format("{}: there are two links of that name", owner));
    tree.link_names.push_back(name);
    CheckInertial(*link, owner);
    CheckGeometry(*link, owner);
  }
  if (tree.links.empty()) Refuse("not_urdf", "the URDF has no link");
  for (const XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    CheckJoint(*joint, tree);
  }
  CheckMimics(*robot, tree);
  CheckRoots(tree);
}

}  // namespace

std::optional<Failure> CheckUrdf(const std::string& urdf_text) {
  try {
    CheckDocument(urdf_text);
  } catch (const Failure& failure) {
    return failure;
  }
  return std::nullopt;
}

}  // namespace gaitwright
