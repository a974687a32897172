// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "kinematics/description/mjcf_write_internal.h"

namespace gaitwright {
namespace {

/// A text in single quotes.
std::string QuotedMjcf(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

/// Lines of a map of maps by joint.
class MjcfYamlMap {
 public:
  explicit MjcfYamlMap(std::string key) : key_(std::move(key)) {}

  void Add(const std::string& joint, const std::string& values) {
    lines_ += fmt::format("  {}: {{{}}}\n", QuotedMjcf(joint), values);
  }
  std::string Text() const { return lines_.empty() ? "" : key_ + ":\n" + lines_; }

 private:
  std::string key_, lines_;
};

/// The names of a joint in the URDF: three names for a ball joint.
std::vector<std::string> NamesOfMjcf(const MjcfJoint& joint) {
  if (joint.is_scalar()) return {joint.name};
  return {joint.name + "_x", joint.name + "_y", joint.name + "_z"};
}

std::string MjcfGains(const MjcfJoint& joint, const MjcfDrive& drive) {
  const bool slides = joint.type == MjcfJointType::kSlide;
  std::string gains;
  if (drive.stiffness > 0.0)
    gains = fmt::format("{}: {}", slides ? "stiffness_n_m" : "stiffness_nm_rad", drive.stiffness);
  if (drive.damping > 0.0)
    gains += fmt::format("{}{}: {}", gains.empty() ? "" : ", ", slides ? "damping_n_s_m" : "damping_nm_s_rad",
                         drive.damping);
  return gains;
}

}  // namespace

std::string WriteMjcfYaml(const MjcfRobot& robot) {
  constexpr double kPlaceholder = 1000.0;  // an effort limit in the URDF from this value on counts as unknown
  MjcfYamlMap limits("limits"), gains("gains"), motors("motors");
  for (std::size_t j = 0; j < robot.tree.joints.size(); ++j) {
    const MjcfJoint& joint = robot.tree.joints[j];
    if (!robot.tree.Moves(static_cast<int>(j)) || robot.couplings[j].locked) continue;
    if (!robot.couplings[j].moves_alone()) continue;
    const bool slides = joint.type == MjcfJointType::kSlide;
    const std::string own = MjcfGains(joint, robot.drives[j]);
    for (const std::string& name : NamesOfMjcf(joint)) {
      if (robot.efforts[j] >= kPlaceholder && std::isfinite(robot.efforts[j]))
        limits.Add(name, fmt::format("{}: {}", slides ? "effort_n" : "effort_nm", robot.efforts[j]));
      if (!own.empty()) gains.Add(name, own);
      if (joint.armature > 0.0)
        motors.Add(name, fmt::format("{}: {}", slides ? "rotor_mass_kg" : "rotor_inertia_kg_m2", joint.armature));
    }
  }
  std::string standing;
  for (const auto& [joint, position] : robot.posture)
    standing += fmt::format("  {}: {}\n", QuotedMjcf(joint), MjcfText(position));
  const std::string name = robot.name.empty() ? "" : fmt::format("name: {}\n", QuotedMjcf(robot.name));
  return name + limits.Text() + (standing.empty() ? "" : "standing:\n" + standing) + gains.Text() + motors.Text();
}

}  // namespace gaitwright
