// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/text.h"
#include "kinematics/description/mjcf_keyframe_internal.h"

namespace gaitwright {
namespace {

constexpr double kMjcfInfinity = std::numeric_limits<double>::infinity();

const tinyxml2::XMLElement* ChosenMjcfKey(const MjcfContext& context) {
  std::vector<const tinyxml2::XMLElement*> keys = context.document.InSections("keyframe");
  std::erase_if(keys, [](const tinyxml2::XMLElement* key) { return std::string_view(key->Name()) != "key"; });
  const auto home = std::find_if(keys.begin(), keys.end(), [](const tinyxml2::XMLElement* key) {
    const char* name = key->Attribute("name");
    return name != nullptr && LowerCase(name) == "home";
  });
  if (home != keys.end()) return *home;
  return keys.empty() ? nullptr : keys.front();
}

using MjcfRange = std::pair<double, double>;

/// The ranges of joints, narrowed by the ranges of the joints that follow them.
std::vector<MjcfRange> MjcfRanges(const MjcfTree& tree, const std::vector<MjcfCoupling>& couplings) {
  std::vector<MjcfRange> ranges(tree.joints.size(), {-kMjcfInfinity, kMjcfInfinity});
  for (std::size_t j = 0; j < couplings.size(); ++j) {
    if (!tree.joints[j].range) continue;
    double multiplier = 1.0, offset = 0.0;
    std::size_t lead = j;
    for (; couplings[lead].leader >= 0; lead = static_cast<std::size_t>(couplings[lead].leader)) {
      offset += multiplier * couplings[lead].offset;
      multiplier *= couplings[lead].multiplier;
    }
    const double one = (tree.joints[j].range->first - offset) / multiplier;
    const double other = (tree.joints[j].range->second - offset) / multiplier;
    ranges[lead].first = std::max(ranges[lead].first, std::min(one, other));
    ranges[lead].second = std::min(ranges[lead].second, std::max(one, other));
  }
  return ranges;
}

/// A position within a range. A position beyond the range by rounding is moved to its end. Nothing for a position that
/// is farther outside.
std::optional<double> MjcfWithin(const MjcfRange& range, double position) {
  constexpr double kRounding = 1e-3;
  if (range.first > range.second) return std::nullopt;
  const double within = std::clamp(position, range.first, range.second);
  return std::abs(within - position) <= kRounding ? std::optional(within) : std::nullopt;
}

}  // namespace

Vector3 MjcfTurns(const Matrix3& R) {
  // R = Rx(a) Ry(b) Rz(c). If cos(b) is zero, rounding decides a, and c matches it.
  const double a = std::atan2(-R(1, 2), R(2, 2));
  const double b = std::atan2(R(0, 2), std::hypot(R(0, 0), R(0, 1)));
  const double c =
      std::atan2(std::cos(a) * R(1, 0) + std::sin(a) * R(2, 0), std::cos(a) * R(1, 1) + std::sin(a) * R(2, 1));
  return {a, b, c};
}

std::vector<std::pair<std::string, double>> ReadMjcfPosture(MjcfContext& context, const MjcfTree& tree,
                                                            const std::vector<MjcfCoupling>& couplings) {
  const tinyxml2::XMLElement* key = ChosenMjcfKey(context);
  if (key == nullptr || key->Attribute("qpos") == nullptr) return {};
  const MjcfAttributes attributes = context.defaults.Of(*key, "key");
  constexpr std::size_t kMostPositions = 20000;
  const std::vector<double> qpos = attributes.Numbers("qpos", 1, kMostPositions);
  std::size_t needed = 0;
  for (const MjcfJoint& joint : tree.joints) needed += joint.num_positions();
  if (qpos.size() != needed) {
    context.Note(
        attributes.owner(),
        fmt::format("its qpos has {} numbers, but the joints need {}; the keyframe is ignored", qpos.size(), needed));
    return {};
  }
  const std::vector<MjcfRange> ranges = MjcfRanges(tree, couplings);
  std::vector<std::pair<std::string, double>> posture;
  for (std::size_t j = 0, at = 0; j < tree.joints.size(); at += tree.joints[j++].num_positions()) {
    const MjcfJoint& joint = tree.joints[j];
    if (!tree.Moves(static_cast<int>(j)) || !couplings[j].moves_alone()) continue;
    if (joint.type == MjcfJointType::kBall) {
      const Quaternion turn(qpos[at], qpos[at + 1], qpos[at + 2], qpos[at + 3]);
      if (turn.norm() < 1e-9) continue;
      const Vector3 turns = MjcfTurns(turn.normalized().toRotationMatrix());
      for (const int i : {0, 1, 2}) posture.emplace_back(joint.name + (i == 0 ? "_x" : i == 1 ? "_y" : "_z"), turns[i]);
    } else if (const auto position = MjcfWithin(ranges[j], qpos[at])) {
      posture.emplace_back(joint.name, *position);
    } else {
      context.Note(attributes.owner(), fmt::format("the position {} of joint '{}' is outside its range and is ignored",
                                                   qpos[at], joint.name));
    }
  }
  context.Note(attributes.owner(), "its joint positions are used as the standing posture");
  return posture;
}

}  // namespace gaitwright
