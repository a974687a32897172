// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mend_urdf.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

#include "kinematics/base/text.h"
#include "kinematics/model/mend_urdf_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr int kDeepest = 100;  // largest depth of nested elements that is searched

std::string TextOr(const char* text) { return text == nullptr ? "" : text; }

/// The links or joints of the URDF as pointers, which stay valid when other elements are deleted.
std::vector<XMLElement*> ElementsOf(XMLElement& robot, const char* kind) {
  std::vector<XMLElement*> elements;
  for (XMLElement* e = robot.FirstChildElement(kind); e != nullptr; e = e->NextSiblingElement(kind))
    elements.push_back(e);
  return elements;
}

bool IsZeroNumber(const char* text) {
  char* end = nullptr;
  return text != nullptr && std::strtod(text, &end) == 0.0 && end != text;
}

std::string LinkAt(const XMLElement& joint, const char* end) {
  const XMLElement* element = joint.FirstChildElement(end);
  return element == nullptr ? "" : TextOr(element->Attribute("link"));
}

std::string Printed(const XMLElement& element) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  element.Accept(&printer);
  return printer.CStr();
}

/// Removes a prefix, such as `urdf:` of <urdf:robot>, from the names of all elements.
bool DropPrefix(XMLElement& element, const std::string& prefix, int depth = 0) {
  bool dropped = false;
  const std::string name = element.Name();
  if (name.starts_with(prefix)) {
    element.SetName(name.substr(prefix.size()).c_str());
    dropped = true;
  }
  if (depth > kDeepest) return dropped;
  for (XMLElement* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    dropped = DropPrefix(*child, prefix, depth + 1) || dropped;
  return dropped;
}

/// Repairs the parts of a document whose root is <robot>.
class Mender {
 public:
  Mender(XMLElement& robot, std::vector<Finding>& findings) : robot_(robot), findings_(findings) {}

  bool Run() {
    DropDoubleLinks();
    DropLooseLinks();
    RenameDoubleJoints();
    FreePlaceholderRanges();
    const std::set<std::string> roots = FreeRoots();
    for (XMLElement* link : ElementsOf(robot_, "link"))
      mended_ = MendLink(*link, PartOf(PartKind::kLink, *link), findings_) || mended_;
    for (XMLElement* joint : ElementsOf(robot_, "joint")) {
      const bool at_root = roots.contains(LinkAt(*joint, "parent"));
      mended_ = MendJoint(*joint, PartOf(PartKind::kJoint, *joint), at_root, findings_) || mended_;
    }
    return mended_;
  }

 private:
  static RobotPart PartOf(PartKind kind, const XMLElement& element) {
    return {kind, TextOr(element.Attribute("name"))};
  }
  void Add(FailureCode code, PartKind kind, const XMLElement& element, const std::string& message) {
    findings_.push_back({FindingLevel::kWarning, code, PartOf(kind, element), element.GetLineNum(), message});
    mended_ = true;
  }

  /// Roots with at most one moving joint. With more moving joints the root carries limbs, and a floating joint is not
  /// the floating base.
  std::set<std::string> FreeRoots() const {
    std::set<std::string> roots;
    for (const XMLElement* link : ElementsOf(robot_, "link")) roots.insert(TextOr(link->Attribute("name")));
    std::map<std::string, int> moving;
    for (const XMLElement* joint : ElementsOf(robot_, "joint")) {
      roots.erase(LinkAt(*joint, "child"));
      if (TextOr(joint->Attribute("type")) != "fixed") ++moving[LinkAt(*joint, "parent")];
    }
    std::erase_if(roots, [&](const std::string& root) { return moving[root] > 1; });
    return roots;
  }

  /// Removes the range 0 to 0 if all joints have it. Exporters write this range if the user does not enter one.
  void FreePlaceholderRanges() {
    constexpr std::size_t kFewest = 2;  // joints
    std::vector<XMLElement*> limited;
    for (XMLElement* joint : ElementsOf(robot_, "joint")) {
      const std::string type = TextOr(joint->Attribute("type"));
      if (type == "revolute" || type == "prismatic") limited.push_back(joint);
    }
    const bool all = std::all_of(limited.begin(), limited.end(), [](const XMLElement* joint) {
      const XMLElement* limit = joint->FirstChildElement("limit");
      return limit != nullptr && IsZeroNumber(limit->Attribute("lower")) && IsZeroNumber(limit->Attribute("upper"));
    });
    if (!all || limited.size() < kFewest) return;
    for (XMLElement* joint : limited) {
      XMLElement* limit = joint->FirstChildElement("limit");
      limit->DeleteAttribute("lower");
      limit->DeleteAttribute("upper");
      findings_.push_back({FindingLevel::kWarning, FailureCode::kMissingLimit, PartOf(PartKind::kJoint, *joint),
                           joint->GetLineNum(),
                           "its position range is 0 to 0, like that of all joints: the range is not used"});
      mended_ = true;
    }
  }

  void DropDoubleLinks() {
    std::map<std::string, XMLElement*> first;
    for (XMLElement* link : ElementsOf(robot_, "link")) {
      const auto [known, is_new] = first.try_emplace(TextOr(link->Attribute("name")), link);
      if (is_new || Printed(*link) != Printed(*known->second)) continue;
      Add(FailureCode::kDoubleName, PartKind::kLink, *link,
          fmt::format("it is given twice identically, in lines {} and {}", known->second->GetLineNum(),
                      link->GetLineNum()));
      robot_.DeleteChild(link);
    }
  }

  /// Removes links that no joint names, because they do not belong to the robot.
  void DropLooseLinks() {
    std::set<std::string> held;
    for (const XMLElement* joint : ElementsOf(robot_, "joint")) {
      held.insert(LinkAt(*joint, "parent"));
      held.insert(LinkAt(*joint, "child"));
    }
    std::set<std::string> names;
    std::vector<XMLElement*> loose;
    for (XMLElement* link : ElementsOf(robot_, "link")) {
      names.insert(TextOr(link->Attribute("name")));
      if (!held.contains(TextOr(link->Attribute("name")))) loose.push_back(link);
    }
    constexpr std::size_t kMost = 20;  // more loose links are not an oversight
    const bool misspelt =              // a joint names a link that does not exist
        !std::includes(names.begin(), names.end(), held.begin(), held.end());
    if (misspelt || loose.size() > kMost || loose.size() == ElementsOf(robot_, "link").size()) return;
    for (XMLElement* link : loose) {
      Add(FailureCode::kLooseLink, PartKind::kLink, *link, "no joint connects it to the robot: left out");
      robot_.DeleteChild(link);
    }
  }

  void RenameDoubleJoints() {
    std::set<std::string> names;
    for (const XMLElement* joint : ElementsOf(robot_, "joint")) names.insert(TextOr(joint->Attribute("name")));
    std::set<std::string> seen;
    for (XMLElement* joint : ElementsOf(robot_, "joint")) {
      const std::string name = TextOr(joint->Attribute("name"));
      if (seen.insert(name).second || name.empty()) continue;
      int number = 2;
      while (names.contains(fmt::format("{}_{}", name, number))) ++number;
      const std::string renamed = fmt::format("{}_{}", name, number);
      Add(FailureCode::kDoubleName, PartKind::kJoint, *joint,
          fmt::format("another joint has the same name: renamed to '{}'", renamed));
      joint->SetAttribute("name", renamed.c_str());
      names.insert(renamed);
    }
  }

  XMLElement& robot_;
  std::vector<Finding>& findings_;
  bool mended_ = false;
};

}  // namespace

MendedUrdf MendUrdf(const std::string& urdf_text) {
  MendedUrdf mended{urdf_text, {}};
  if (const auto text = InUtf8(urdf_text)) {
    mended.text = *text;
    mended.findings.push_back({FindingLevel::kInfo, FailureCode::kEncoding, RobotPart(), 0,
                               "the file is not in UTF-8: read as UTF-16 or Latin-1"});
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(mended.text.c_str(), mended.text.size()) != tinyxml2::XML_SUCCESS) return mended;
  XMLElement* robot = document.RootElement();
  if (robot == nullptr) return mended;
  const std::string name = robot->Name();
  bool changed = false;
  if (const std::size_t colon = name.find(':'); colon != std::string::npos && name.substr(colon + 1) == "robot") {
    changed = DropPrefix(*robot, name.substr(0, colon + 1));
    mended.findings.push_back({FindingLevel::kInfo, FailureCode::kNamespace, RobotPart(), robot->GetLineNum(),
                               fmt::format("its elements are in the namespace '{}'", name.substr(0, colon))});
  }
  if (std::strcmp(robot->Name(), "robot") != 0) return mended;
  changed = Mender(*robot, mended.findings).Run() || changed;
  if (!changed) return mended;
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  mended.text = printer.CStr();
  if (const auto text = InUtf8(mended.text)) mended.text = *text;  // a character reference may be invalid
  return mended;
}

}  // namespace gaitwright
