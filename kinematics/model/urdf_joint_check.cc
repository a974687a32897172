// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "kinematics/base/nearest_name.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

/// In the URDF format, a missing limit has the value 0. This is unlikely to be intended, so it is refused.
double PositionLimit(const XMLElement& limit, const char* name, const std::string& owner) {
  if (limit.Attribute(name) == nullptr) {
    Refuse(FailureCode::kMissingLimit, fmt::format("{}: its <limit> has no '{}', which the URDF format reads as 0; add "
                                                   "lower=\"...\" upper=\"...\", or make the joint continuous",
                                                   owner, name));
  }
  return Number(limit, name, owner);
}

void CheckLimit(const XMLElement& joint, const std::string& type, bool strict, const std::string& owner) {
  const bool is_free = type == "continuous" || type == "spherical";
  const XMLElement* limit = joint.FirstChildElement("limit");
  if (limit == nullptr) {
    if (is_free) return;
    Refuse(FailureCode::kMissingLimit, fmt::format("{}: a {} joint needs a <limit>", owner, type));
  }
  for (const char* name : {"effort", "velocity"}) {
    if (const double value = Number(*limit, name, owner); value < 0.0)
      Refuse(FailureCode::kBadLimit,
             fmt::format("{}: its {} limit is {}, which is negative; zero or more is accepted", owner, name, value));
  }
  if (is_free) return;
  const double lower = PositionLimit(*limit, "lower", owner), upper = PositionLimit(*limit, "upper", owner);
  if (lower > upper)
    Refuse(FailureCode::kBadLimit,
           fmt::format("{}: its lower limit {} is above its upper limit {}", owner, lower, upper));
  if (strict && lower == 0.0 && upper == 0.0 && joint.FirstChildElement("mimic") == nullptr)
    Refuse(FailureCode::kMissingLimit,
           fmt::format("{}: its position range is 0 to 0; give its range, or make the joint fixed", owner));
}

/// Checks optional numbers of an element of a joint. @param positive  refuses negative numbers.
void CheckNumbers(const XMLElement& joint, const char* element, const std::vector<const char*>& names, bool positive,
                  const std::string& owner) {
  const XMLElement* e = joint.FirstChildElement(element);
  for (const char* name : names) {
    if (e == nullptr || e->Attribute(name) == nullptr) continue;
    const double value = Number(*e, name, owner);
    if (positive && value < 0.0) {
      Refuse(FailureCode::kBadDynamics, fmt::format("{}: its {} is {}; zero or more is accepted", owner, name, value));
    }
  }
}

void CheckMimic(const XMLElement& mimic, const std::map<std::string, std::string>& types, const std::string& name) {
  const std::string owner = fmt::format("joint '{}'", name);
  const std::string target = Attribute(mimic, "joint", owner);
  std::vector<std::string> others;
  for (const auto& [joint, type] : types) {
    if (joint != name) others.push_back(joint);
  }
  if (target == name) Refuse(FailureCode::kBadMimic, fmt::format("{}: it mimics itself; name another joint", owner));
  if (!types.contains(target)) {
    Refuse(FailureCode::kUnknownMimic,
           fmt::format("{}: it mimics '{}', which is not a joint{}", owner, target, NearestOrAll(target, others)));
  }
  if (types.at(target) == "fixed") {
    Refuse(FailureCode::kBadMimic,
           fmt::format("{}: it mimics '{}', which is fixed and never moves; name a moving joint or make "
                       "'{}' fixed too",
                       owner, target, name));
  }
  if (mimic.Attribute("offset") != nullptr) Number(mimic, "offset", owner);
  if (mimic.Attribute("multiplier") != nullptr && Number(mimic, "multiplier", owner) == 0.0) {
    Refuse(FailureCode::kBadMimic,
           fmt::format("{}: it mimics '{}' with multiplier 0, so it never moves; make it fixed", owner, target));
  }
}

}  // namespace

void CheckMotion(const XMLElement& joint, const std::string& type, bool strict, const std::string& owner) {
  const XMLElement* axis = joint.FirstChildElement("axis");
  if (axis != nullptr && type != "spherical") {
    const auto a = Numbers(Attribute(*axis, "xyz", owner), 3, owner + ", axis");
    if (std::hypot(a[0], a[1], a[2]) < 1e-9)
      Refuse(FailureCode::kZeroAxis,
             fmt::format("{}: its axis is zero; give a direction, such as xyz=\"0 1 0\"", owner));
  }
  CheckLimit(joint, type, strict, owner);
  CheckNumbers(joint, "dynamics", {"damping", "friction"}, true, owner);
  CheckNumbers(joint, "calibration", {"rising", "falling", "reference_position"}, false, owner);
  CheckNumbers(joint, "safety_controller", {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"}, false,
               owner);
}

void CheckMimics(const XMLElement& robot) {
  std::map<std::string, std::string> types, leader;
  for (const XMLElement* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
    types[j->Attribute("name")] = j->Attribute("type");
  }
  for (const XMLElement* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint")) {
    const XMLElement* mimic = j->FirstChildElement("mimic");
    if (mimic == nullptr || types[j->Attribute("name")] == "fixed") continue;
    const std::string name = j->Attribute("name");
    CheckPart({PartKind::kJoint, name}, [&] { CheckMimic(*mimic, types, name); });
    leader[j->Attribute("name")] = mimic->Attribute("joint");
  }
  for (const auto& [follower, first] : leader) {
    std::string path = fmt::format("'{}'", follower);
    std::set<std::string> seen = {follower};
    for (std::string at = first;; at = leader.at(at)) {
      path += fmt::format(" mimics '{}'", at);
      if (!seen.insert(at).second) {
        Refuse(FailureCode::kBadMimic,
               fmt::format("joint '{}': {}: a cycle; one of them must not mimic another", follower, path), {},
               RobotPart{PartKind::kJoint, follower});
      }
      if (!leader.contains(at)) break;
      path += ", which";
    }
  }
}

}  // namespace gaitwright
