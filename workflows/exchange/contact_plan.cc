// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "planning/paths/standing_feet.h"
#include "workflows/exchange/contact_plan_internal.h"

namespace gaitwright {
namespace {

constexpr double kUsualDoubleSupport = 0.2, kUsualStand = 0.6;  // [s] defaults of the controller

bool IsPlan(const YAML::Node& node) { return node.IsMap() && node["contacts"]; }

/// The only plan within `plans`, which has them by robot and name, or the root itself.
YAML::Node OnlyPlan(const YAML::Node& root) {
  if (IsPlan(root)) return root;
  if (!root.IsMap() || !root["plans"] || !root["plans"].IsMap()) RefuseYaml(root, "it has no plan with 'contacts'");
  std::vector<std::string> names;
  YAML::Node found;
  const auto add = [&](const std::string& name, const YAML::Node& plan) {
    names.push_back(name);
    found.reset(plan);
  };
  for (const auto& outer : root["plans"]) {
    const std::string name = TextOf(outer.first, "a name");
    if (IsPlan(outer.second)) {
      add(name, outer.second);
    } else if (outer.second.IsMap()) {
      for (const auto& inner : outer.second) {
        if (IsPlan(inner.second)) add(name + "." + TextOf(inner.first, "a name"), inner.second);
      }
    }
  }
  if (names.size() != 1) {
    RefuseYaml(root["plans"], fmt::format("it has {} plans{}; a file with one of them is read", names.size(),
                                          names.empty() ? "" : ": " + QuotedList(names)));
  }
  return found;
}

class ContactPlanReader {
 public:
  ContactPlanReader(const RobotModel& model, std::vector<std::string>& unused) : model_(model), unused_(unused) {}

  std::string Run(const YAML::Node& root) {
    const YAML::Node plan = OnlyPlan(root);
    const YamlMap map(plan, "the plan of contacts",
                      {"contacts", "single_support_duration", "double_support_duration", "init_dsp_duration",
                       "final_dsp_duration", "swing_height", "takeoff_duration", "takeoff_pitch", "landing_duration",
                       "landing_pitch", "com_height", "torso_pitch", "mpc"});
    map.Require({"contacts", "single_support_duration"});
    NoteUnused(map, {"swing_height", "takeoff_duration", "takeoff_pitch", "landing_duration", "landing_pitch",
                     "com_height", "torso_pitch", "mpc"});
    FindFeet(plan);
    const std::vector<YAML::Node> contacts = ListOf(*map.Find("contacts"), "contacts");
    if (contacts.size() < 3)
      RefuseYaml(*map.Find("contacts"), fmt::format("has {} contacts; two to start from and one or more steps are "
                                                    "needed",
                                                    contacts.size()));
    text_ = fmt::format(
        "{{swing_s: {:.9g}, pause_s: {:.9g}, initial_stand_s: {:.9g}, final_stand_s: {:.9g}, start: [",
        *map.Number("single_support_duration"), map.Number("double_support_duration").value_or(kUsualDoubleSupport),
        map.Number("init_dsp_duration").value_or(kUsualStand), map.Number("final_dsp_duration").value_or(kUsualStand));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (i == 2) text_ += "], footsteps: [";
      AddContact(contacts[i]);
    }
    return text_ + "]}\n";
  }

 private:
  void NoteUnused(const YamlMap& map, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
      const std::string text = fmt::format("key '{}'", key);
      if (map.Find(key) != nullptr && std::find(unused_.begin(), unused_.end(), text) == unused_.end())
        unused_.push_back(text);
    }
  }

  void FindFeet(const YAML::Node& plan) {
    if (model_.legs.size() != 2) {
      RefuseYaml(plan,
                 fmt::format("a plan of contacts is for two feet; robot '{}' has {}", model_.name, model_.legs.size()));
    }
    const std::vector<Pose> standing = StandingFeet(model_);
    left_ = standing[0].translation().y() > standing[1].translation().y() ? 0 : 1;
  }

  /// The foot of a surface such as LeftFootCenter.
  const std::string& FootOfSurface(const YamlMap& contact, const YAML::Node& node) const {
    const std::string name = contact.Text("surface"), lower = LowerCase(name);
    const bool left = lower.find("left") != std::string::npos, right = lower.find("right") != std::string::npos;
    if (left == right)
      RefuseYaml(node, fmt::format("the surface '{}' names neither the left nor the right foot", name));
    return model_.feet[left ? left_ : 1 - left_].name;
  }

  /// Heading of a frame whose axes are the rows of its rotation: nine numbers, or a quaternion with w first.
  static double HeadingOf(const YAML::Node& pose) {
    const YAML::Node rotation = pose["rotation"];
    if (!rotation) return 0.0;
    std::vector<double> r;
    for (const YAML::Node& part : ListOf(rotation, "rotation")) r.push_back(NumberOf(part, "rotation"));
    if (r.size() == 9) return std::atan2(r[1], r[0]);
    if (r.size() != 4) RefuseYaml(rotation, fmt::format("rotation has {} numbers; 9 or 4 are needed", r.size()));
    return std::atan2(2.0 * (r[1] * r[2] - r[0] * r[3]), 1.0 - 2.0 * (r[2] * r[2] + r[3] * r[3]));
  }

  void AddContact(const YAML::Node& node) {
    const YamlMap contact(node, "a contact", {"pose", "surface", "ref_vel", "swing", "half_length", "half_width"});
    contact.Require({"pose", "surface"});
    NoteUnused(contact, {"ref_vel", "swing", "half_length", "half_width"});
    const YAML::Node pose = *contact.Find("pose");
    const YamlMap parts(pose, "pose", {"translation", "rotation"});
    parts.Require({"translation"});
    std::vector<double> p;
    for (const YAML::Node& part : ListOf(*parts.Find("translation"), "translation"))
      p.push_back(NumberOf(part, "translation"));
    if (p.size() != 3)
      RefuseYaml(*parts.Find("translation"), fmt::format("translation has {} numbers; 3 are needed", p.size()));
    for (; line_ < LineOf(node); ++line_) text_ += '\n';
    text_ += fmt::format("{{foot: \"{}\", x_m: {:.12g}, y_m: {:.12g}, z_m: {:.12g}, yaw_rad: {:.12g}}}, ",
                         FootOfSurface(contact, node), p[0], p[1], p[2], HeadingOf(pose));
  }

  const RobotModel& model_;
  std::vector<std::string>& unused_;
  std::size_t left_ = 0;
  std::string text_;
  int line_ = 1;  ///< of the text so far
};

}  // namespace

bool HoldsContactPlan(const std::string& text) {
  return text.find("contacts") != std::string::npos && text.find("surface") != std::string::npos &&
         text.find("single_support_duration") != std::string::npos && text.find("footsteps") == std::string::npos;
}

std::string FootstepsOfContactPlan(const RobotModel& model, const std::string& text, std::vector<std::string>& unused) {
  return ContactPlanReader(model, unused).Run(LoadYaml(text));
}

}  // namespace gaitwright
