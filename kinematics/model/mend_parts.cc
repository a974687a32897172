// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "kinematics/model/mend_urdf_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr char kThin[] = "0.0001";       // [m] replaces the size 0 of a shape
constexpr char kUnknownLimit[] = "1e9";  // effort and speed; the reader treats such large values as unknown
constexpr char kNoLimit[] = "1000";      // [rad], [m] replaces a missing limit of a joint that is not continuous

/// Collects the findings about the elements of a link or a joint.
struct PartNotes {
  const RobotPart& part;
  std::vector<Finding>& findings;

  void Add(FindingLevel level, FailureCode code, const XMLElement& element, std::string message) const {
    findings.push_back({level, code, part, element.GetLineNum(), std::move(message)});
  }
};

bool IsZero(const char* text) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return end != text && value == 0.0;
}

/// Replaces sizes of 0 by kThin. @return whether there was one.
bool ThickenShape(XMLElement& shape, const PartNotes& notes) {
  bool thickened = false;
  for (const char* name : {"radius", "length"}) {
    if (shape.Attribute(name) == nullptr || !IsZero(shape.Attribute(name))) continue;
    shape.SetAttribute(name, kThin);
    thickened = true;
  }
  if (const char* size = shape.Attribute("size"); size != nullptr) {
    std::string mended;
    std::string_view rest = size;
    while (!rest.empty()) {
      const std::size_t begin = rest.find_first_not_of(" \t\r\n");
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n", begin), rest.size());
      const std::string word(rest.substr(begin, end - begin));
      mended += (mended.empty() ? "" : " ") + (IsZero(word.c_str()) ? std::string(kThin) : word);
      if (IsZero(word.c_str())) thickened = true;
      rest.remove_prefix(end);
    }
    if (thickened) shape.SetAttribute("size", mended.c_str());
  }
  if (thickened)
    notes.Add(FindingLevel::kInfo, FailureCode::kZeroSize, shape,
              fmt::format("a {} has size 0: {} m is used", shape.Name(), kThin));
  return thickened;
}

/// Whether a <visual> has a shape that can be drawn.
bool CanBeShown(const XMLElement& visual) {
  const XMLElement* geometry = visual.FirstChildElement("geometry");
  const XMLElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  if (shape == nullptr) return false;
  if (std::strcmp(shape->Name(), "mesh") != 0) return true;
  const char* file = shape->Attribute("filename");
  return file != nullptr && *file != '\0';
}

bool MendShapes(XMLElement& link, const PartNotes& notes) {
  bool mended = false;
  for (const char* kind : {"visual", "collision"}) {
    for (XMLElement* e = link.FirstChildElement(kind); e != nullptr;) {
      XMLElement* next = e->NextSiblingElement(kind);
      const XMLElement* geometry = e->FirstChildElement("geometry");
      const bool empty = geometry == nullptr || geometry->FirstChildElement() == nullptr;
      if (empty || (std::strcmp(kind, "visual") == 0 && !CanBeShown(*e))) {
        notes.Add(FindingLevel::kInfo, FailureCode::kNoGeometry, *e,
                  fmt::format("a <{}> has no geometry: left out", kind));
        link.DeleteChild(e);
        mended = true;
      } else {
        mended = ThickenShape(*e->FirstChildElement("geometry")->FirstChildElement(), notes) || mended;
      }
      e = next;
    }
  }
  return mended;
}

bool HasInertiaWithoutMass(const XMLElement& mass, const XMLElement& inertia) {
  const char* value = mass.Attribute("value");
  if (value == nullptr || !IsZero(value)) return false;
  constexpr std::array kMoments = {"ixx", "iyy", "izz"};
  return std::any_of(kMoments.begin(), kMoments.end(), [&](const char* name) {
    return inertia.Attribute(name) != nullptr && !IsZero(inertia.Attribute(name));
  });
}

bool MendInertial(XMLElement& link, const PartNotes& notes) {
  XMLElement* inertial = link.FirstChildElement("inertial");
  if (inertial == nullptr) return false;
  XMLElement* mass = inertial->FirstChildElement("mass");
  XMLElement* inertia = inertial->FirstChildElement("inertia");
  if (mass == nullptr && inertia == nullptr) {
    notes.Add(FindingLevel::kInfo, FailureCode::kEmptyInertial, *inertial, "its <inertial> is empty: left out");
    link.DeleteChild(inertial);
    return true;
  }
  bool mended = false;
  if (mass != nullptr && inertia != nullptr && HasInertiaWithoutMass(*mass, *inertia))
    notes.Add(FindingLevel::kInfo, FailureCode::kNoMass, *inertial,
              "its mass is 0 but its inertia is not: both are used");
  if (mass == nullptr) {
    inertial->InsertNewChildElement("mass")->SetAttribute("value", "0");
    notes.Add(FindingLevel::kWarning, FailureCode::kNoMass, *inertial, "it has an inertia but no mass: 0 kg is used");
    mended = true;
  }
  if (inertia == nullptr) {
    inertia = inertial->InsertNewChildElement("inertia");
    notes.Add(FindingLevel::kWarning, FailureCode::kNoInertia, *inertial, "it has a mass but no inertia");
  }
  for (const char* name : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    if (inertia->Attribute(name) != nullptr) continue;
    inertia->SetAttribute(name, "0");
    mended = true;
  }
  return mended;
}

/// Whether a <limit> restricts a joint to less than a turn.
bool HoldsToPartOfATurn(const XMLElement* limit) {
  constexpr double kNearlyATurn = 6.0;  // [rad]; files often give -pi to pi for wheels
  if (limit == nullptr || limit->Attribute("lower") == nullptr || limit->Attribute("upper") == nullptr) return false;
  const double lower = std::strtod(limit->Attribute("lower"), nullptr);
  const double upper = std::strtod(limit->Attribute("upper"), nullptr);
  return lower < upper && upper - lower < kNearlyATurn;
}

/// Adds the missing attributes of <limit> to a joint. A continuous joint with position limits becomes revolute.
bool MendLimit(XMLElement& joint, const std::string& given, const PartNotes& notes) {
  const bool held = given == "continuous" && HoldsToPartOfATurn(joint.FirstChildElement("limit"));
  const std::string type = held ? "revolute" : given;
  if (held) {
    joint.SetAttribute("type", "revolute");
    notes.Add(FindingLevel::kInfo, FailureCode::kLimitedContinuous, joint,
              "it has type 'continuous' but position limits in the file: they are used");
  }
  const bool turns = type == "continuous" || type == "spherical";
  XMLElement* limit = joint.FirstChildElement("limit");
  if (limit == nullptr) {
    if (turns) return false;
    limit = joint.InsertNewChildElement("limit");
  }
  bool mended = held;
  const auto lacks = [&](const char* name) { return limit->Attribute(name) == nullptr; };
  if (type == "revolute" && lacks("lower") && lacks("upper")) {
    joint.SetAttribute("type", "continuous");
    notes.Add(FindingLevel::kInfo, FailureCode::kMissingLimit, joint,
              "its position has no limits in the file: it is unlimited");
    mended = true;
  } else if (!turns && (lacks("lower") || lacks("upper"))) {
    notes.Add(FindingLevel::kInfo, FailureCode::kMissingLimit, joint,
              fmt::format("its position has no {} limit in the file: it is unlimited there",
                          lacks("lower") && lacks("upper") ? "lower or upper"
                          : lacks("lower")                 ? "lower"
                                                           : "upper"));
    if (lacks("lower")) limit->SetAttribute("lower", (std::string("-") + kNoLimit).c_str());
    if (lacks("upper")) limit->SetAttribute("upper", kNoLimit);
    mended = true;
  }
  for (const char* name : {"effort", "velocity"}) {
    if (!lacks(name)) continue;
    limit->SetAttribute(name, kUnknownLimit);
    notes.Add(FindingLevel::kInfo, FailureCode::kMissingLimit, joint,
              fmt::format("its {} limit is not given: no limit is used", name));
    mended = true;
  }
  return mended;
}

}  // namespace

bool MendLink(XMLElement& link, const RobotPart& part, std::vector<Finding>& findings) {
  const PartNotes notes{part, findings};
  const bool numbers = MendNumbers(link, part, findings);
  const bool inertial = MendInertial(link, notes);
  return MendShapes(link, notes) || inertial || numbers;
}

bool MendJoint(XMLElement& joint, const RobotPart& part, bool at_root, std::vector<Finding>& findings) {
  const PartNotes notes{part, findings};
  bool mended = MendNumbers(joint, part, findings);
  const char* given = joint.Attribute("type");
  const std::string type = given == nullptr ? "" : given;
  if (at_root && (type == "floating" || type == "planar")) {
    joint.SetAttribute("type", "fixed");
    notes.Add(
        FindingLevel::kInfo, FailureCode::kFloatingRoot, joint,
        fmt::format("it has type '{}' at the root: it becomes fixed, because the robot's base is free anyway", type));
    return true;
  }
  if (type == "revolute" || type == "prismatic" || type == "continuous" || type == "spherical")
    mended = MendLimit(joint, type, notes) || mended;
  return mended;
}

}  // namespace gaitwright
