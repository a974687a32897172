// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/apply_legs.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/options.h"
#include "kinematics/model/yaml_line.h"

namespace gaitwright {
namespace {

/// Index of the leg that ends in this foot.
std::size_t LegOf(const RobotModel& model, const std::string& foot, int line) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    if (model.legs[i].name == foot) return i;
    names.push_back(model.legs[i].name);
  }
  RefuseYamlLine(line,
                 fmt::format("robot '{}' has no foot '{}'; its feet are {}", model.name, foot, QuotedList(names)));
}

std::vector<std::string> JointNames(const RobotModel& model, const Leg& leg) {
  std::vector<std::string> names;
  for (const int joint : leg.joints) names.push_back(model.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

}  // namespace

void ApplyLegs(const std::vector<LegOverride>& given, RobotModel& model) {
  for (const LegOverride& said : given) {
    Leg& leg = model.legs[LegOf(model, said.foot, said.line)];
    const std::vector<std::string> names = JointNames(model, leg);
    if (!said.joints.empty() && said.joints != names) {
      RefuseYamlLine(said.line, fmt::format("the joints of leg '{}' are {}, from the base to the foot, but the file "
                                            "has {}; to end the leg elsewhere, name another foot",
                                            leg.name, QuotedList(names), QuotedList(said.joints)));
    }
    if (!said.knee.empty()) {
      const auto at = std::find(names.begin(), names.end(), said.knee);
      if (at == names.end()) {
        RefuseYamlLine(said.line, fmt::format("knee '{}' is not a joint of leg '{}'; its joints are {}", said.knee,
                                              leg.name, QuotedList(names)));
      }
      leg.knee_joint = leg.joints[static_cast<std::size_t>(at - names.begin())];
      if (leg.knee_sign == 0.0) leg.knee_sign = 1.0;
    }
    if (said.knee_sign == 0.0) continue;
    if (leg.knee_joint < 0) {
      RefuseYamlLine(said.line,
                     fmt::format("leg '{}' has no joint that was recognised as a knee; name it with 'knee'", leg.name));
    }
    const Joint& knee = model.joints[static_cast<std::size_t>(leg.knee_joint)];
    if (said.knee_sign > 0.0 ? knee.upper <= 0.0 : knee.lower >= 0.0) {
      RefuseYamlLine(said.line,
                     fmt::format("knee '{}' cannot bend to {} (its 'knee_side'): its limits are {} to {}", knee.name,
                                 said.knee_sign > 0.0 ? "plus" : "minus", knee.lower, knee.upper));
    }
    leg.knee_sign = said.knee_sign;
  }
}

void ApplyMirrors(const std::vector<MirrorPair>& pairs, RobotModel& model) {
  for (Leg& leg : model.legs) leg.mirror = -1;
  for (const MirrorPair& pair : pairs) {
    const std::size_t a = LegOf(model, pair.first, pair.line), b = LegOf(model, pair.second, pair.line);
    if (a == b) RefuseYamlLine(pair.line, fmt::format("foot '{}' is paired with itself", pair.first));
    for (const std::size_t i : {a, b}) {
      if (model.legs[i].mirror >= 0) {
        RefuseYamlLine(pair.line, fmt::format("foot '{}' is in two pairs of 'mirror_pairs'", model.legs[i].name));
      }
    }
    model.legs[a].mirror = static_cast<int>(b);
    model.legs[b].mirror = static_cast<int>(a);
  }
}

}  // namespace gaitwright
