// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/joint_trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "planning/plan/json_part_internal.h"
#include "workflows/exchange/csv_table.h"

namespace gaitwright {
namespace {

/// A part of a YAML text and its path, with the interface of JsonPart.
class YamlPart {
 public:
  explicit YamlPart(const YAML::Node& node, std::string path = "") : node_(node), path_(std::move(path)) {}

  void Object(const std::vector<std::string>& required, const std::vector<std::string>& optional) const {
    std::vector<std::string> known = required;
    known.insert(known.end(), optional.begin(), optional.end());
    YamlMap(node_, Name(), known).Require(required);
  }
  bool Has(const std::string& key) const { return node_.IsMap() && node_[key]; }
  YamlPart At(const std::string& key) const { return YamlPart(node_[key], path_.empty() ? key : path_ + "." + key); }
  std::vector<YamlPart> List() const {
    std::vector<YamlPart> parts;
    for (const YAML::Node& node : ListOf(node_, Name())) parts.emplace_back(node, NameOf(parts.size()));
    return parts;
  }
  std::vector<double> Numbers() const {
    std::vector<double> numbers;
    for (const YAML::Node& node : ListOf(node_, Name())) numbers.push_back(NumberOf(node, NameOf(numbers.size())));
    return numbers;
  }
  double Number() const { return NumberOf(node_, Name()); }
  std::string Text() const { return TextOf(node_, Name()); }
  bool IsNull() const { return node_.IsNull(); }
  bool IsMap() const { return node_.IsMap(); }
  [[noreturn]] void Refuse(const std::string& what) const { RefuseYaml(node_, Name() + " " + what); }

 private:
  std::string Name() const { return path_.empty() ? "the trajectory" : path_; }
  std::string NameOf(std::size_t member) const { return fmt::format("{}[{}]", path_, member); }

  const YAML::Node node_;
  std::string path_;
};

bool IsNull(const YamlPart& part) { return part.IsNull(); }
bool IsNull(const JsonPart& part) { return part.json().is_null(); }
bool IsMap(const YamlPart& part) { return part.IsMap(); }
bool IsMap(const JsonPart& part) { return part.json().is_object(); }

/// The place of a joint of the file in the model.
struct Slot {
  int joint = 0;
  double scale = 1.0;
};

/// Reads the message. @tparam Part YamlPart or JsonPart.
template <class Part>
class Parser {
 public:
  Parser(const RobotModel& model, const ImportOptions& options, bool some_joints)
      : model_(model), options_(options), some_joints_(some_joints) {}

  MotionTable Parse(const Part& root) {
    const Part message = root.Has("trajectory") ? root.At("trajectory") : root;
    message.Object({"joint_names", "points"}, {"header"});
    TakeNames(message.At("joint_names"));
    motion_.format = MotionFormat::kJointTrajectory;
    const std::vector<Part> points = message.At("points").List();
    if (points.size() > static_cast<std::size_t>(kMostCsvRows))
      message.At("points").Refuse(fmt::format("has more than {} points", kMostCsvRows));
    for (const Part& point : points) TakePoint(point);
    return std::move(motion_);
  }

 private:
  void TakeNames(const Part& part) {
    std::vector<std::string> joints;
    for (const Joint& joint : model_.joints) joints.push_back(joint.name);
    std::vector<bool> has(model_.joints.size(), false);
    for (const Part& entry : part.List()) {
      const std::string name = entry.Text();
      const auto found = std::find(joints.begin(), joints.end(), name);
      if (found == joints.end()) {
        entry.Refuse(fmt::format("is not a joint: robot '{}' has no joint '{}'{}", model_.name, name,
                                 NearestOrAll(name, joints)));
      }
      const auto j = static_cast<std::size_t>(found - joints.begin());
      if (has[j]) entry.Refuse(fmt::format("is a duplicate: joint '{}' is given twice", name));
      has[j] = true;
      AddSlot(static_cast<int>(j));
    }
    CheckMissing(part, has);
  }

  void AddSlot(int index) {
    const Joint& joint = model_.joints[static_cast<std::size_t>(index)];
    if (joint.is_mimic)
      motion_.unused_columns.push_back(fmt::format("joint '{}', which mimics another joint", joint.name));
    const bool degrees = options_.angle_unit == "deg" && !joint.is_prismatic();
    const bool millimetres = options_.length_unit == "mm" && joint.is_prismatic();
    slots_.push_back({index, degrees ? std::numbers::pi / 180.0 : millimetres ? 1e-3 : 1.0});
  }

  void CheckMissing(const Part& names, const std::vector<bool>& has) {
    std::vector<std::string> missing;
    for (int d = 0; d < model_.num_dofs(); ++d) {
      if (!has[static_cast<std::size_t>(model_.dof_joint[static_cast<std::size_t>(d)])])
        missing.push_back(model_.dof_names[static_cast<std::size_t>(d)]);
    }
    if (missing.empty()) return;
    const bool none = missing.size() == static_cast<std::size_t>(model_.num_dofs());
    if (some_joints_ ? none : options_.missing_joints == "refuse") {
      names.Refuse(fmt::format("lacks {} of {} joints of robot '{}': {}", missing.size(), model_.num_dofs(),
                               model_.name, QuotedList(missing)));
    }
    if (!some_joints_) motion_.derived.push_back({"position of " + QuotedList(missing), "as in the standing posture"});
  }

  static double WholeOf(const Part& part, double highest) {
    const double value = part.Number();
    if (!(value >= 0.0 && value <= highest) || value != std::floor(value))
      part.Refuse(fmt::format("is {:.12g}; a whole number from 0 to {:.0f} is needed", value, highest));
    return value;
  }

  /// Reads seconds and nanoseconds with the names of ROS 2 or ROS 1, or a number in the unit of times.
  double TimeOf(const Part& part) const {
    constexpr double kMostSeconds = 2147483647.0, kMostNanoseconds = 999999999.0;  // limits of the message type
    if (!IsMap(part)) {
      const double time = part.Number();
      if (time < 0.0) part.Refuse(fmt::format("is {:.12g}; 0 or more is needed", time));
      return options_.time_unit_s() * time;
    }
    part.Object({}, {"sec", "secs", "nanosec", "nsecs"});
    const bool ros1 = part.Has("secs") && !part.Has("sec") && !part.Has("nanosec");
    const bool ros2 = part.Has("sec") && !part.Has("secs") && !part.Has("nsecs");
    if (!ros1 && !ros2) part.Refuse("needs sec and nanosec, or secs and nsecs");
    const char* const nanoseconds = ros2 ? "nanosec" : "nsecs";
    const double seconds = WholeOf(part.At(ros2 ? "sec" : "secs"), kMostSeconds);
    return part.Has(nanoseconds) ? seconds + 1e-9 * WholeOf(part.At(nanoseconds), kMostNanoseconds) : seconds;
  }

  void TakePoint(const Part& point) {
    point.Object({"positions", "time_from_start"}, {"velocities", "accelerations", "effort"});
    const double time_s = TimeOf(point.At("time_from_start"));
    if (!motion_.time_s.empty() && !(time_s > motion_.time_s.back())) {
      point.At("time_from_start")
          .Refuse(fmt::format("of {:.9g} s does not come after {:.9g} s of the previous point; times must increase",
                              time_s, motion_.time_s.back()));
    }
    motion_.time_s.push_back(time_s);
    const VectorX none = VectorX::Constant(model_.num_dofs(), std::numeric_limits<double>::quiet_NaN());
    TakeRow(point, "positions", some_joints_ ? none : model_.standing_joints, true, motion_.q);
    TakeRow(point, "velocities", none, true, motion_.v);
    TakeRow(point, "accelerations", none, true, motion_.a);
    TakeRow(point, "effort", none, false, motion_.tau);
  }

  static bool Holds(const Part& point, const std::string& key) { return point.Has(key) && !IsNull(point.At(key)); }

  /// Reads a list of numbers for the joints. A list that is missing or empty must be so in all points.
  void TakeRow(const Part& point, const std::string& key, const VectorX& otherwise, bool scaled,
               std::vector<VectorX>& rows) const {
    const std::vector<double> numbers = Holds(point, key) ? point.At(key).Numbers() : std::vector<double>{};
    if (numbers.size() != slots_.size() && (!numbers.empty() || key == "positions")) {
      point.At(key).Refuse(fmt::format("has {} numbers, but joint_names has {} names", numbers.size(), slots_.size()));
    }
    if (rows.size() != (numbers.empty() ? 0 : motion_.time_s.size() - 1)) {
      point.Refuse(fmt::format("{} {}, but the points before {}; all points must have the same fields",
                               numbers.empty() ? "lacks" : "has", key, numbers.empty() ? "have it" : "lack it"));
    }
    if (numbers.empty()) return;
    rows.push_back(otherwise);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const Joint& joint = model_.joints[static_cast<std::size_t>(slots_[i].joint)];
      if (!joint.is_mimic) rows.back()[joint.dof] = numbers[i] * (scaled ? slots_[i].scale : 1.0);
    }
  }

  const RobotModel& model_;
  const ImportOptions& options_;
  const bool some_joints_;
  std::vector<Slot> slots_;
  MotionTable motion_;
};

/// Removes the line `---` that ROS prints after each message.
std::string WithoutLastSeparator(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n"), separator = text.rfind("\n---");
  const bool ends = last != std::string::npos && separator != std::string::npos && separator + 3 == last;
  return ends ? text.substr(0, separator + 1) : text;
}

Failure RefusedTrajectory(const std::string& source, const std::string& why) {
  return {
      FailureKind::kBadInput, FailureCode::kJointTrajectory, "ImportMotion", fmt::format("'{}': {}", source, why), {}};
}

}  // namespace

Result<MotionTable> ParseJointTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                         const ImportOptions& options, bool some_joints) {
  constexpr YamlBounds kBounds{kLargestTrajectoryYaml, kMostTrajectoryYamlValues};
  try {
    return Parser<YamlPart>(model, options, some_joints).Parse(YamlPart(LoadYaml(WithoutLastSeparator(text), kBounds)));
  } catch (const InvalidArgument& error) {
    return RefusedTrajectory(source, error.what());
  } catch (const YAML::Exception& error) {
    return RefusedTrajectory(source, fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
}

Result<MotionTable> ParseJointTrajectoryJson(const RobotModel& model, const std::string& text,
                                             const std::string& source, const ImportOptions& options,
                                             bool some_joints) {
  try {
    const JsonPart::Json json = ParseJsonOnce(text);
    return Parser<JsonPart>(model, options, some_joints).Parse(JsonPart(json));
  } catch (const InvalidArgument& error) {
    return RefusedTrajectory(source, error.what());
  } catch (const JsonPart::Json::exception&) {
    return RefusedTrajectory(source, ReasonNoJson(text));
  }
}

Result<ComparedMotion> ComparedTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                          const ImportOptions& options) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string::npos && text[first] == '{';
  const Result<MotionTable> table = json ? ParseJointTrajectoryJson(model, text, source, options, true)
                                         : ParseJointTrajectory(model, text, source, options, true);
  if (!table) return table.failure();
  return CheckedTable(model, options, *table, source);
}

}  // namespace gaitwright
