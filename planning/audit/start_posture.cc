// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/start_posture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/model/dof_units.h"
#include "kinematics/model/likely_degrees.h"
#include "planning/audit/start_posture_shape.h"

namespace gaitwright {
namespace {

constexpr char kQuaternion[] = "base_quaternion_xyzw", kJoints[] = "joints";

Quaternion ReadQuaternion(const YAML::Node& node) {
  const std::vector<YAML::Node> xyzw = ListOf(node, fmt::format("'{}'", kQuaternion));
  if (xyzw.size() != 4)
    RefuseYaml(node, fmt::format("'{}' has {} numbers; four are needed: [x, y, z, w]", kQuaternion, xyzw.size()));
  double c[4];
  for (std::size_t i = 0; i < 4; ++i) c[i] = NumberOf(xyzw[i], fmt::format("'{}'", kQuaternion));
  const Quaternion R_WB(c[3], c[0], c[1], c[2]);
  if (std::abs(R_WB.norm() - 1.0) > 1e-3) {
    RefuseYaml(node, fmt::format("'{}' has a length of {:.4g}; a unit quaternion is needed (length 1 within 0.001)",
                                 kQuaternion, R_WB.norm()));
  }
  return R_WB.normalized();
}

/// Refuses an unknown joint and a joint that follows another one.
int DofOf(const RobotModel& model, const YamlMap::Entry& entry) {
  const auto at = std::find(model.dof_names.begin(), model.dof_names.end(), entry.key);
  if (at != model.dof_names.end()) return static_cast<int>(at - model.dof_names.begin());
  for (const Joint& joint : model.joints) {
    if (joint.name != entry.key) continue;
    RefuseYaml(entry.key_node, fmt::format("joint '{}' mimics '{}' and has no independent position; leave it out",
                                           joint.name, model.dof_names[static_cast<std::size_t>(joint.dof)]));
  }
  RefuseYaml(entry.key_node, fmt::format("robot '{}' has no joint '{}'{}", model.name, entry.key,
                                         NearestOrAll(entry.key, model.dof_names)));
}

void CheckPosition(const RobotModel& model, int dof, const YamlMap::Entry& entry, double q, bool degrees) {
  constexpr double kRounding = 1e-6;  // [rad] or [m]
  const std::string unit = PositionUnit(model, dof);
  if (q < model.dof_lower(dof) - kRounding || q > model.dof_upper(dof) + kRounding) {
    RefuseYaml(entry.value, fmt::format("joint '{}' is at {:.6g} {}, outside its limits of {:.6g} to {:.6g}; {}",
                                        entry.key, q, unit, model.dof_lower(dof), model.dof_upper(dof),
                                        degrees ? "the values seem to be in degrees, because all joints would then be "
                                                  "within their limits; write them in rad"
                                                : "correct the measurement or the limits"));
  }
  if (std::abs(q) > kFarthestMeasured) {
    RefuseYaml(entry.value, fmt::format("joint '{}' is at {:.6g} {}; accepted for a joint without limits: -{} to {}",
                                        entry.key, q, unit, kFarthestMeasured, kFarthestMeasured));
  }
}

void RefuseMissing(const RobotModel& model, const YAML::Node& node, const std::vector<bool>& given) {
  std::vector<std::string> missing;
  for (std::size_t d = 0; d < given.size(); ++d) {
    if (!given[d]) missing.push_back(model.dof_names[d]);
  }
  if (missing.empty()) return;
  RefuseYaml(node, fmt::format("{} of robot '{}' {} missing; give the position of every joint in rad (m)",
                               QuotedList(missing), model.name, missing.size() == 1 ? "is" : "are"));
}

void ReadJoints(const RobotModel& model, const YamlMap& map, const YAML::Node& node, VectorX& joints) {
  std::vector<bool> given(static_cast<std::size_t>(model.num_dofs()), false);
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == kQuaternion) continue;
    const int dof = DofOf(model, entry);
    joints[dof] = NumberOf(entry.value, fmt::format("joint '{}'", entry.key));
    given[static_cast<std::size_t>(dof)] = true;
  }
  RefuseMissing(model, node, given);
  const bool degrees = LikelyDegrees(model, {joints}).has_value();
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == kQuaternion) continue;
    const int dof = DofOf(model, entry);
    CheckPosition(model, dof, entry, joints[dof], degrees);
  }
}

/// File structure with the joints under a separate key.
DataShape NestedShape() {
  using namespace shapes;
  return Object({{kJoints, MapOf(Number(), 1), "Position of every joint that is not coupled to another [rad], [m]."},
                 Optional(kQuaternion, Numbers(4), "Measured orientation of the base.")});
}

}  // namespace

DataShape StartPostureShape() {
  using namespace shapes;
  return Either(NestedShape(), MapOf(Either(Number(), Numbers(4)), 1));
}

Result<StartPosture> StartPostureFromYaml(const std::string& text, const std::string& source, const RobotModel& model) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kStartPosture,
                   "StartPosture",
                   fmt::format("'{}', {}", source, message),
                   {}};
  };
  try {
    const YAML::Node root = LoadYaml(text);
    const YamlMap map(root, "the start posture");
    StartPosture posture;
    posture.joints = VectorX::Zero(model.num_dofs());
    if (const YAML::Node* node = map.Find(kQuaternion)) posture.R_WB = ReadQuaternion(*node);
    const YAML::Node* under = map.Find(kJoints);
    if (under != nullptr && under->IsMap()) {
      const YamlMap only(root, "the start posture", NestedShape().Keys());
      ReadJoints(model, YamlMap(*under, "'joints'"), *under, posture.joints);
    } else {
      ReadJoints(model, map, root, posture.joints);
    }
    return posture;
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on; see docs/audit.md", error.mark.line + 1));
  }
}

Result<StartPosture> LoadStartPosture(const std::string& path, const RobotModel& model) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return StartPostureFromYaml(*text, path, model);
}

}  // namespace gaitwright
