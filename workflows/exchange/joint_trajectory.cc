// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/joint_trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/exchange/csv_table.h"

namespace gaitwright {
namespace {

/// Where a joint of the file goes.
struct Slot {
  int joint = 0;
  double scale = 1.0;
};

class Parser {
 public:
  Parser(const RobotModel& model, const ImportOptions& options) : model_(model), options_(options) {}

  MotionTable Parse(const YAML::Node& root) {
    YAML::Node message = root;
    if (message.IsMap() && message["trajectory"]) message = message["trajectory"];
    const YamlMap map(message, "the trajectory", {"header", "joint_names", "points"});
    map.Require({"joint_names", "points"});
    TakeNames(*map.Find("joint_names"));
    motion_.format = "joint-trajectory";
    const std::vector<YAML::Node> points = ListOf(*map.Find("points"), "points");
    if (points.size() > static_cast<std::size_t>(kMostCsvRows))
      RefuseYaml(*map.Find("points"), fmt::format("more than {} points", kMostCsvRows));
    for (std::size_t i = 0; i < points.size(); ++i) TakePoint(points[i], i);
    return std::move(motion_);
  }

 private:
  void TakeNames(const YAML::Node& node) {
    std::vector<std::string> joints;
    for (const Joint& joint : model_.joints) joints.push_back(joint.name);
    std::vector<bool> has(model_.joints.size(), false);
    for (const YAML::Node& entry : ListOf(node, "joint_names")) {
      const std::string name = TextOf(entry, "a joint's name");
      const auto found = std::find(joints.begin(), joints.end(), name);
      if (found == joints.end()) {
        RefuseYaml(entry, fmt::format("robot '{}' has no joint '{}'; the nearest is '{}'", model_.name, name,
                                      NearestName(name, joints)));
      }
      const auto j = static_cast<std::size_t>(found - joints.begin());
      if (has[j]) RefuseYaml(entry, fmt::format("joint '{}' stands there twice", name));
      has[j] = true;
      if (model_.joints[j].is_mimic)
        motion_.unused_columns.push_back(fmt::format("joint '{}', which follows another", name));
      const bool degrees = options_.angle_unit == "deg" && !model_.joints[j].is_prismatic();
      const bool millimetres = options_.length_unit == "mm" && model_.joints[j].is_prismatic();
      slots_.push_back({static_cast<int>(j), degrees ? std::numbers::pi / 180.0 : millimetres ? 1e-3 : 1.0});
    }
    std::vector<std::string> missing;
    for (int d = 0; d < model_.num_dofs(); ++d) {
      if (!has[static_cast<std::size_t>(model_.dof_joint[static_cast<std::size_t>(d)])])
        missing.push_back(model_.dof_names[static_cast<std::size_t>(d)]);
    }
    if (missing.empty()) return;
    if (options_.missing_joints == "refuse") {
      RefuseYaml(node, fmt::format("joint_names lacks {} of {} joints of robot '{}': {}", missing.size(),
                                   model_.num_dofs(), model_.name, QuotedList(missing)));
    }
    motion_.derived.push_back({"position of " + QuotedList(missing), "as in the standing posture"});
  }

  static double TimeOf(const YAML::Node& node) {
    if (node.IsScalar()) return NumberOf(node, "time_from_start");
    const YamlMap map(node, "time_from_start", {"sec", "secs", "nanosec", "nsecs"});
    if ((map.Find("sec") != nullptr) == (map.Find("secs") != nullptr))
      RefuseYaml(node, "time_from_start needs sec and nanosec, or secs and nsecs");
    const double seconds = map.Number(map.Find("sec") != nullptr ? "sec" : "secs").value();
    const double nanoseconds = map.Number("nanosec").value_or(map.Number("nsecs").value_or(0.0));
    return seconds + 1e-9 * nanoseconds;
  }

  void TakePoint(const YAML::Node& node, std::size_t index) {
    const YamlMap map(node, "a point", {"positions", "velocities", "accelerations", "effort", "time_from_start"});
    map.Require({"positions", "time_from_start"});
    const double time_s = TimeOf(*map.Find("time_from_start"));
    if (!motion_.time_s.empty() && !(time_s > motion_.time_s.back())) {
      RefuseYaml(node, fmt::format("time_from_start of {:.9g} s does not come after {:.9g} s of the point before; "
                                   "times must rise",
                                   time_s, motion_.time_s.back()));
    }
    motion_.time_s.push_back(time_s);
    const VectorX none = VectorX::Constant(model_.num_dofs(), std::numeric_limits<double>::quiet_NaN());
    TakeRow(map, "positions", index, model_.standing_joints, true, motion_.q);
    TakeRow(map, "velocities", index, none, true, motion_.v);
    TakeRow(map, "effort", index, none, false, motion_.tau);
    const YAML::Node* accelerations = map.Find("accelerations");
    if (index == 0 && accelerations != nullptr && accelerations->size() > 0)
      motion_.unused_columns.emplace_back("accelerations");
  }

  /// A list of numbers for the joints; one that is not there, or empty, has to be so in all points.
  void TakeRow(const YamlMap& map, const std::string& key, std::size_t index, const VectorX& otherwise, bool scaled,
               std::vector<VectorX>& rows) const {
    const YAML::Node* node = map.Find(key);
    const std::vector<YAML::Node> numbers =
        node == nullptr || node->IsNull() ? std::vector<YAML::Node>{} : ListOf(*node, key);
    if (numbers.size() != slots_.size() && (!numbers.empty() || key == "positions")) {
      RefuseYaml(*node, fmt::format("{} has {} numbers, joint_names {} names", key, numbers.size(), slots_.size()));
    }
    if (rows.size() != (numbers.empty() ? 0 : index)) {
      RefuseYaml(map.entries().front().key_node,
                 fmt::format("point {} {} {}, those before {}; all points must be alike", index + 1,
                             numbers.empty() ? "lacks" : "has", key, numbers.empty() ? "have it" : "lack it"));
    }
    if (numbers.empty()) return;
    rows.push_back(otherwise);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const Joint& joint = model_.joints[static_cast<std::size_t>(slots_[i].joint)];
      const double value = NumberOf(numbers[i], key + " of '" + joint.name + "'") * (scaled ? slots_[i].scale : 1.0);
      if (!joint.is_mimic) rows.back()[joint.dof] = value;
    }
  }

  const RobotModel& model_;
  const ImportOptions& options_;
  std::vector<Slot> slots_;
  MotionTable motion_;
};

/// Without the line `---` with which ROS ends each message that it prints.
std::string WithoutLastSeparator(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n"), separator = text.rfind("\n---");
  const bool ends = last != std::string::npos && separator != std::string::npos && separator + 3 == last;
  return ends ? text.substr(0, separator + 1) : text;
}

}  // namespace

Result<MotionTable> ParseJointTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                         const ImportOptions& options) {
  const auto refused = [&](const std::string& why) {
    return Failure{
        FailureKind::kBadInput, "joint_trajectory", "ImportMotion", fmt::format("'{}': {}", source, why), {}};
  };
  try {
    return Parser(model, options).Parse(LoadYaml(WithoutLastSeparator(text)));
  } catch (const InvalidArgument& error) {
    return refused(error.what());
  } catch (const YAML::Exception& error) {
    return refused(fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
}

Result<MotionTable> ReadJointTrajectory(const RobotModel& model, const std::string& path,
                                        const ImportOptions& options) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return ParseJointTrajectory(model, *text, path, options);
}

}  // namespace gaitwright
