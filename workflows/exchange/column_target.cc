// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/column_target.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace gaitwright {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Fills the table of names.
class Names {
 public:
  explicit Names(const ImportOptions& options)
      : angle_(options.angle_unit == "deg" ? kDegree : 1.0),
        length_(options.length_unit == "mm" ? 1e-3 : 1.0),
        time_(options.time_unit_s()) {}

  void AddTime() {
    for (const char* name : {"time_s", "time", "t"}) Add(name, ColumnKind::kTime, 0, time_);
  }

  void AddBase() {
    const std::array<std::string, 3> axes = {"x", "y", "z"}, turns = {"roll", "pitch", "yaw"};
    for (int i = 0; i < 3; ++i) {
      const std::string& axis = axes[static_cast<std::size_t>(i)];
      Add("base_" + axis + "_m", ColumnKind::kBasePosition, i, length_);
      Add("base_" + axis + "_mm", ColumnKind::kBasePosition, i, 1e-3);
      AddAngle("base_" + turns[static_cast<std::size_t>(i)], "", ColumnKind::kEuler, i);
      AddLength("base_v" + axis, "_s", ColumnKind::kBaseRate, i);
      AddAngle("base_w" + axis, "_s", ColumnKind::kBaseRate, 3 + i);
      AddLength("base_a" + axis, "_s2", ColumnKind::kBaseAcceleration, i);
      AddAngle("base_alpha" + axis, "_s2", ColumnKind::kBaseAcceleration, 3 + i);
    }
    for (int i = 0; i < 4; ++i) Add(std::string("base_q") + "xyzw"[i], ColumnKind::kQuaternion, i, 1.0);
  }

  void AddBareName(const Joint& joint, int index) {
    Add(joint.name, ColumnKind::kPosition, index, joint.is_prismatic() ? length_ : angle_);
  }

  void AddJoint(const Joint& joint, int index) {
    const std::string position = "q_" + joint.name, rate = "v_" + joint.name, acceleration = "a_" + joint.name,
                      effort = "tau_" + joint.name;
    if (joint.is_prismatic()) {
      for (const std::string& name : {position, joint.name}) AddLength(name, "", ColumnKind::kPosition, index);
      AddLength(rate, "_s", ColumnKind::kVelocity, index);
      AddLength(acceleration, "_s2", ColumnKind::kAcceleration, index);
      Add(effort + "_n", ColumnKind::kTorque, index, 1.0);
    } else {
      for (const std::string& name : {position, joint.name}) AddAngle(name, "", ColumnKind::kPosition, index);
      AddAngle(rate, "_s", ColumnKind::kVelocity, index);
      AddAngle(acceleration, "_s2", ColumnKind::kAcceleration, index);
      Add(effort + "_nm", ColumnKind::kTorque, index, 1.0);
    }
  }

  void AddFoot(const Foot& foot, int index) {
    Add("contact_" + foot.link, ColumnKind::kContact, index, 1.0);
    for (int i = 0; i < 3; ++i)
      Add("force_" + foot.link + "_" + "xyz"[i] + "_n", ColumnKind::kForce, 3 * index + i, 1.0);
  }

  std::map<std::string, ColumnTarget> targets;

 private:
  void Add(const std::string& name, ColumnKind kind, int index, double scale) {
    targets.emplace(name, ColumnTarget{kind, index, scale});
  }
  void AddAngle(const std::string& name, const std::string& per, ColumnKind kind, int index) {
    Add(name + "_rad" + per, kind, index, angle_);
    Add(name + "_deg" + per, kind, index, kDegree);
  }
  void AddLength(const std::string& name, const std::string& per, ColumnKind kind, int index) {
    Add(name + "_m" + per, kind, index, length_);
    Add(name + "_mm" + per, kind, index, 1e-3);
  }

  double angle_, length_, time_;
};

}  // namespace

std::map<std::string, ColumnTarget> ColumnTargets(const RobotModel& model, const ImportOptions& options) {
  Names names(options);
  names.AddTime();
  names.AddBase();
  // Bare names of all joints first, because the name of one joint with a unit may be the name of another.
  for (std::size_t j = 0; j < model.joints.size(); ++j) names.AddBareName(model.joints[j], static_cast<int>(j));
  for (std::size_t j = 0; j < model.joints.size(); ++j) names.AddJoint(model.joints[j], static_cast<int>(j));
  for (std::size_t f = 0; f < model.feet.size(); ++f) names.AddFoot(model.feet[f], static_cast<int>(f));
  return names.targets;
}

std::string PositionColumn(const Joint& joint) { return "q_" + joint.name + (joint.is_prismatic() ? "_m" : "_rad"); }

bool LooksLikeOurs(const std::string& name) {
  const std::array<const char*, 6> starts = {"q_", "v_", "tau_", "contact_", "force_", "base_"};
  return std::any_of(starts.begin(), starts.end(), [&](const char* start) { return name.starts_with(start); });
}

}  // namespace gaitwright
