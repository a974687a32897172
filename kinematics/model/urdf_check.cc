// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/urdf_check.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

const std::vector<std::string> kSupportedJoints = {"revolute", "continuous", "prismatic", "fixed"};

/// What the joints say of the tree.
struct Tree {
  std::set<std::string> links;
  std::vector<std::string> link_names, joint_names;
  std::map<std::string, std::string> parent_of;  // by child link
  std::map<std::string, std::string> joint_of;   // by child link
};

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
  if (type != "fixed") CheckMotion(joint, type, owner);
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

void RefuseXacro(const XMLElement& robot) {
  for (const XMLElement* child = robot.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (std::string_view(child->Name()).starts_with("xacro:"))
      Refuse("xacro", fmt::format("line {} has <{}>: this is a xacro file, from which a URDF is yet to be made, by "
                                  "'xacro FILE > robot.urdf'",
                                  child->GetLineNum(), child->Name()));
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
  RefuseXacro(*robot);
  Tree tree;
  for (const XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const std::string name = Attribute(*link, "name", "a link");
    const std::string owner = fmt::format("link '{}'", name);
    if (!tree.links.insert(name).second)
      Refuse("double_name", fmt::format("{}: there are two links of that name", owner));
    tree.link_names.push_back(name);
    CheckLink(*link, owner);
  }
  if (tree.links.empty()) Refuse("not_urdf", "the URDF has no link");
  for (const XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    CheckJoint(*joint, tree);
  }
  CheckMimics(*robot);
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
