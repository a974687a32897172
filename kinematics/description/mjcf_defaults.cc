// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_defaults_internal.h"

namespace gaitwright {
namespace {

constexpr std::array<std::string_view, 13> kMjcfActuators = {
    "general", "motor",    "position", "velocity", "intvelocity", "damper",     "cylinder",
    "muscle",  "adhesion", "plugin",   "dcmotor",  "pid",         "orientation"};
/// Kinds of elements whose class is used here.
constexpr std::array<std::string_view, 4> kMjcfClassed = {"joint", "geom", "mesh", "equality"};

// Each class contains a copy of the class around it.
constexpr const char* kMjcfOutermost = "main";
constexpr std::size_t kMostMjcfClasses = 500, kMostMjcfDefaults = 100;
constexpr std::size_t kLongestMjcfDefault = 300;  // largest size of an attribute [byte]

std::string KindOfMjcf(const tinyxml2::XMLElement& element) {
  const std::string tag = element.Name();
  return IsMjcfActuator(tag) ? "actuator" : tag;
}

MjcfAttributes::Values ValuesOfMjcf(const tinyxml2::XMLElement& element) {
  MjcfAttributes::Values values;
  for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) values[a->Name()] = a->Value();
  return values;
}

}  // namespace

bool IsMjcfActuator(const std::string& tag) {
  return std::find(kMjcfActuators.begin(), kMjcfActuators.end(), tag) != kMjcfActuators.end();
}

MjcfDefaults::MjcfDefaults(const MjcfDocument& document) : document_(document) {
  classes_[kMjcfOutermost];
  for (const tinyxml2::XMLElement* section : document.Sections("default")) {
    const MjcfAttributes attributes(document_.Owner(*section), ValuesOfMjcf(*section));
    if (attributes.Has("class")) outermost_.insert(attributes.Name("class"));
    Read(*section, kMjcfOutermost);
  }
}

void MjcfDefaults::Read(const tinyxml2::XMLElement& section, const std::string& name) {
  std::vector<const tinyxml2::XMLElement*> nested;
  for (const tinyxml2::XMLElement* child : document_.Children(section)) {
    const std::string kind = KindOfMjcf(*child);
    if (kind == "default") {
      nested.push_back(child);
      continue;
    }
    const bool matters =
        kind == "actuator" || std::find(kMjcfClassed.begin(), kMjcfClassed.end(), kind) != kMjcfClassed.end();
    if (!matters) continue;
    const MjcfAttributes::Values values = ValuesOfMjcf(*child);
    for (const auto& [key, text] : values) {
      if (text.size() > kLongestMjcfDefault)
        RefuseMjcf(FailureCode::kLargeMjcf,
                   fmt::format("{}: '{}' has {} bytes; in <default> at most {} are read", document_.Owner(*child),
                               ShownMjcf(key), text.size(), kLongestMjcfDefault));
    }
    MergeMjcfValues(classes_[name][kind], values);
    if (classes_[name][kind].size() > kMostMjcfDefaults)
      RefuseMjcf(FailureCode::kLargeMjcf, fmt::format("{0}: over {1} attributes in <default>; at most {1} are read",
                                                      document_.Owner(*child), kMostMjcfDefaults));
  }
  for (const tinyxml2::XMLElement* inner : nested) {
    const MjcfAttributes attributes(document_.Owner(*inner), ValuesOfMjcf(*inner));
    const std::string own = attributes.Name("class");
    if (own.empty()) RefuseMjcf(FailureCode::kMjcfClass, fmt::format("{}: it has no 'class'", attributes.owner()));
    if (classes_.contains(own) || outermost_.contains(own))
      RefuseMjcf(FailureCode::kMjcfClass, fmt::format("{}: two classes have this name", attributes.owner()));
    if (classes_.size() >= kMostMjcfClasses)
      RefuseMjcf(FailureCode::kLargeMjcf, fmt::format("{0}: the model has over {1} classes; at most {1} are read",
                                                      attributes.owner(), kMostMjcfClasses));
    classes_[own] = Class(classes_.at(name));
    Read(*inner, own);
  }
}

const MjcfDefaults::Class& MjcfDefaults::Named(const std::string& name, const tinyxml2::XMLElement& element) const {
  const auto at = classes_.find(outermost_.contains(name) ? kMjcfOutermost : name);
  if (at != classes_.end()) return at->second;
  std::vector<std::string> names;
  for (const auto& [known, values] : classes_) names.push_back(known);
  RefuseMjcf(FailureCode::kMjcfClass, fmt::format("{}: there is no class '{}'{}", document_.Owner(element),
                                                  ShownMjcf(name), NearestOrAll(name, names)));
}

MjcfAttributes MjcfDefaults::Of(const tinyxml2::XMLElement& element, const std::string& kind,
                                const std::string& childclass) const {
  MjcfAttributes::Values own = ValuesOfMjcf(element);
  std::string name = childclass.empty() ? kMjcfOutermost : childclass;
  if (const auto at = own.find("class"); at != own.end()) name = at->second;
  const Class& of = Named(name, element);
  const auto values = of.find(kind);
  MjcfAttributes::Values merged = values == of.end() ? MjcfAttributes::Values() : values->second;
  MergeMjcfValues(merged, own);
  return {document_.Owner(element), std::move(merged)};
}

std::string MjcfDefaults::ChildClass(const tinyxml2::XMLElement& element, const std::string& inherited) const {
  const char* own = element.Attribute("childclass");
  if (own == nullptr) return inherited;
  Named(own, element);
  return own;
}

}  // namespace gaitwright
