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

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kLargestUrdf = std::size_t{16} << 20;  // [byte]
constexpr int kMostLinks = 1000, kMostMoving = 300, kMostShapes = 5000;

const std::vector<std::string> kSupportedJoints = {"revolute", "continuous", "prismatic", "spherical", "fixed"};

/// The tree of links and joints.
struct Tree {
  std::set<std::string> links;
  std::vector<std::string> link_names;
  std::set<std::string> joint_names;
  std::map<std::string, std::string> parent_of;  // by child link
  std::map<std::string, std::string> joint_of;   // by child link
};

/// The name of a link or a joint.
std::string NameOf(const XMLElement& element, const std::string& what) {
  std::string name = Attribute(element, "name", fmt::format("{} in line {}", what, element.GetLineNum()));
  if (name.empty())
    Refuse(FailureCode::kUrdfMissing, fmt::format("{} in line {} has an empty name", what, element.GetLineNum()));
  return name;
}

void CheckJoint(const XMLElement& joint, const std::string& name, bool strict, Tree& tree) {
  const std::string owner = fmt::format("joint '{}'", name);
  if (!tree.joint_names.insert(name).second) {
    Refuse(FailureCode::kDoubleName, fmt::format("{}: two joints have this name", owner));
  }
  const std::string type = Attribute(joint, "type", owner);
  if (std::find(kSupportedJoints.begin(), kSupportedJoints.end(), type) == kSupportedJoints.end()) {
    Refuse(FailureCode::kJointType,
           fmt::format("{}: type '{}' is not supported; supported: {}", owner, type, QuotedList(kSupportedJoints)));
  }
  CheckOrigin(joint, owner);
  std::string ends[2];
  for (int i = 0; i < 2; ++i) {
    const char* tag = i == 0 ? "parent" : "child";
    const XMLElement* end = joint.FirstChildElement(tag);
    if (end == nullptr) Refuse(FailureCode::kUrdfMissing, fmt::format("{}: it has no <{}>", owner, tag));
    ends[i] = Attribute(*end, "link", owner);
    if (!tree.links.contains(ends[i])) {
      Refuse(FailureCode::kUnknownLink, fmt::format("{}: its {} '{}' is not a link{}", owner, tag, ends[i],
                                                    NearestOrAll(ends[i], tree.link_names)));
    }
  }
  if (tree.parent_of.contains(ends[1])) {
    Refuse(FailureCode::kUrdfLoop,
           fmt::format("link '{}' has two parent joints, '{}' and '{}': a closed loop; the joints must form a tree",
                       ends[1], tree.joint_of[ends[1]], name),
           {}, RobotPart{PartKind::kLink, ends[1]});
  }
  tree.parent_of[ends[1]] = ends[0];
  tree.joint_of[ends[1]] = name;
  if (type == "spherical" && joint.FirstChildElement("mimic") != nullptr)
    Refuse(FailureCode::kBadMimic, fmt::format("{}: a spherical joint cannot mimic another joint", owner));
  if (type != "fixed") CheckMotion(joint, type, strict, owner);
}

void CheckRoots(const Tree& tree) {
  std::vector<std::string> roots;
  for (const std::string& link : tree.link_names) {
    if (!tree.parent_of.contains(link)) roots.push_back(link);
  }
  if (roots.size() > 1) {
    Refuse(FailureCode::kUrdfRoots,
           fmt::format("the links {} have no parent: one root is needed; connect the others by joints",
                       QuotedList(roots)));
  }
  for (const std::string& link : tree.link_names) {
    std::string at = link;
    std::set<std::string> seen;
    while (tree.parent_of.contains(at)) {
      if (!seen.insert(at).second) {
        Refuse(FailureCode::kUrdfLoop,
               fmt::format("link '{}' is part of a cycle of joints: a closed loop; the joints must form a tree", link),
               {}, RobotPart{PartKind::kLink, link});
      }
      at = tree.parent_of.at(at);
    }
  }
}

void RefuseXacro(const XMLElement& robot) {
  for (const XMLElement* child = robot.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (std::string_view(child->Name()).starts_with("xacro:"))
      Refuse(FailureCode::kXacro,
             fmt::format("line {} has <{}>: this is xacro; expand it first (ExpandXacro, or the program xacro)",
                         child->GetLineNum(), child->Name()));
  }
}

void CheckText(const std::string& urdf_text) {
  if (urdf_text.size() > kLargestUrdf) {
    Refuse(FailureCode::kLargeUrdf,
           fmt::format("the URDF has {} bytes; at most {} are read", urdf_text.size(), kLargestUrdf));
  }
  if (const std::size_t at = urdf_text.find('\0'); at != std::string::npos)
    Refuse(FailureCode::kNotXml, fmt::format("the URDF is not XML: byte {} is 0x00", at + 1));
  for (std::size_t at = urdf_text.find("&#"); at != std::string::npos; at = urdf_text.find("&#", at + 1)) {
    const std::size_t digits = urdf_text.find_first_not_of("xX0", at + 2);
    if (digits != std::string::npos && digits > at + 2 && urdf_text[digits] == ';')
      Refuse(FailureCode::kNotXml,
             fmt::format("the URDF is not XML: byte {} begins '&#0;', which is not a character", at + 1));
  }
}

/// Counts the elements of a kind in a parent and refuses more than `most`.
int Count(const XMLElement& parent, const char* kind, int most, const std::string& owner) {
  int count = 0;
  for (const XMLElement* e = parent.FirstChildElement(kind); e != nullptr; e = e->NextSiblingElement(kind)) ++count;
  if (count > most)
    Refuse(FailureCode::kLargeUrdf,
           fmt::format("{} has {} elements <{}>; at most {} are read", owner, count, kind, most));
  return count;
}

/// Refuses a robot with so many parts that deriving its legs would take too long.
void CheckCounts(const XMLElement& robot) {
  Count(robot, "link", kMostLinks, "the robot");
  Count(robot, "joint", kMostLinks, "the robot");
  int shapes = 0, moving = 0;
  for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (const char* kind : {"collision", "visual"}) shapes += Count(*link, kind, kMostShapes, "a link");
  }
  for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const char* type = joint->Attribute("type");
    if (type != nullptr && std::string_view(type) != "fixed") ++moving;
  }
  if (shapes > kMostShapes)
    Refuse(FailureCode::kLargeUrdf, fmt::format("the robot has {} shapes; at most {} are read", shapes, kMostShapes));
  if (moving > kMostMoving)
    Refuse(FailureCode::kLargeUrdf,
           fmt::format("the robot has {} moving joints; at most {} are read", moving, kMostMoving));
}

void CheckDocument(const std::string& urdf_text, bool strict) {
  CheckText(urdf_text);
  tinyxml2::XMLDocument document;
  if (document.Parse(urdf_text.c_str(), urdf_text.size()) != tinyxml2::XML_SUCCESS) {
    Refuse(FailureCode::kNotXml,
           fmt::format("the URDF is not XML: line {}: an element is not closed, or the text is damaged ({})",
                       document.ErrorLineNum(), document.ErrorName()));
  }
  const XMLElement* robot = document.RootElement();
  if (robot == nullptr || std::strcmp(robot->Name(), "robot") != 0) {
    Refuse(FailureCode::kNotUrdf,
           fmt::format("the root element is <{}>; a URDF has <robot>", robot == nullptr ? "" : robot->Name()));
  }
  RefuseXacro(*robot);
  CheckCounts(*robot);
  Tree tree;
  for (const XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const std::string name = NameOf(*link, "a link");
    const RobotPart part{PartKind::kLink, name};
    CheckPart(part, [&] {
      if (!tree.links.insert(name).second)
        Refuse(FailureCode::kDoubleName, fmt::format("{}: two links have this name", PartText(part)));
      tree.link_names.push_back(name);
      CheckLink(*link, strict, PartText(part));
    });
  }
  if (tree.links.empty()) Refuse(FailureCode::kNotUrdf, "the URDF has no link");
  for (const XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string name = NameOf(*joint, "a joint");
    CheckPart({PartKind::kJoint, name}, [&] { CheckJoint(*joint, name, strict, tree); });
  }
  CheckMimics(*robot);
  CheckRoots(tree);
}

}  // namespace

std::optional<Failure> CheckUrdf(const std::string& urdf_text, bool strict) {
  try {
    CheckDocument(urdf_text, strict);
  } catch (const Failure& failure) {
    return failure;
  }
  return std::nullopt;
}

}  // namespace gaitwright
