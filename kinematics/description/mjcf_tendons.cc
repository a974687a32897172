// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "kinematics/description/mjcf_tendons_internal.h"

namespace gaitwright {
namespace {

/// The joints of a fixed tendon with their coefficients.
struct MjcfTendonTie {
  std::string owner;
  double play = 0.0;  ///< width of the range of its length
  std::vector<std::pair<std::size_t, double>> joints;
};

/// The tie of a tendon. Nothing for a tendon without a limited range, or with a joint outside the robot.
std::optional<MjcfTendonTie> TieOfMjcfTendon(const MjcfContext& context, const MjcfTree& tree,
                                             const tinyxml2::XMLElement& element) {
  const MjcfAttributes attributes = context.defaults.Of(element, "tendon");
  if (!attributes.IsLimited("limited", "range", context.compiler.autolimits)) return std::nullopt;
  const std::vector<double> range = attributes.Numbers("range", 2, 2);
  MjcfTendonTie tie{attributes.owner(), range[1] - range[0], {}};
  for (const tinyxml2::XMLElement* part : context.document.Children(element)) {
    if (std::string_view(part->Name()) != "joint") continue;
    const MjcfAttributes of_joint = context.defaults.Of(*part, "tendon_joint");
    const auto at = tree.joint_named.find(of_joint.Text("joint"));
    const double coefficient = of_joint.Number("coef", 0.0);
    if (at == tree.joint_named.end() || !tree.Moves(at->second)) return std::nullopt;
    const auto joint = static_cast<std::size_t>(at->second);
    if (!tree.joints[joint].is_scalar()) return std::nullopt;
    if (coefficient != 0.0) tie.joints.emplace_back(joint, coefficient);
  }
  return tie;
}

/// Whether exactly one joint of a tie has no motor, and this joint has little play.
bool CarriesMjcfTorque(const MjcfTendonTie& tie, const std::vector<MjcfDrive>& drives) {
  constexpr double kMostPlay = 0.1;  // play of this joint [rad, m]
  int passive = 0;
  bool is_held = true;
  for (const auto& [joint, coefficient] : tie.joints) {
    if (drives[joint].actuators > 0) continue;
    ++passive;
    is_held = tie.play <= kMostPlay * std::abs(coefficient);
  }
  return passive == 1 && is_held && tie.joints.size() > 1;
}

}  // namespace

void DriveMjcfJointsByTendons(MjcfContext& context, const MjcfTree& tree, std::vector<MjcfDrive>& drives) {
  std::vector<MjcfTendonTie> ties;
  std::vector<int> shares(drives.size(), 0);
  for (const tinyxml2::XMLElement* element : context.document.InSections("tendon")) {
    if (std::string_view(element->Name()) != "fixed") continue;
    std::optional<MjcfTendonTie> tie = TieOfMjcfTendon(context, tree, *element);
    if (!tie || !CarriesMjcfTorque(*tie, drives)) continue;
    for (const auto& [joint, coefficient] : tie->joints) ++shares[joint];
    ties.push_back(std::move(*tie));
  }
  const std::vector<MjcfDrive> motors = drives;
  for (const MjcfTendonTie& tie : ties) {
    double tension = std::numeric_limits<double>::infinity(), own = 0.0;
    std::size_t carried = 0;
    bool is_bounded = true;
    for (const auto& [joint, coefficient] : tie.joints) {
      if (motors[joint].actuators == 0) {
        carried = joint;
        own = std::abs(coefficient);
      } else {
        is_bounded = is_bounded && motors[joint].is_bounded;
        tension = std::min(tension, motors[joint].effort.x() / (shares[joint] * std::abs(coefficient)));
      }
    }
    MjcfDrive& drive = drives[carried];
    drive.is_bounded = drive.is_bounded && is_bounded;
    ++drive.actuators;
    drive.effort.x() += own * tension;
    context.Note(tie.owner,
                 fmt::format("it transmits up to {1:.4g} of motor torque to joint '{0}', which has no motor; "
                             "the motors' own motion is ignored",
                             tree.joints[carried].name, own * tension));
  }
}

}  // namespace gaitwright
