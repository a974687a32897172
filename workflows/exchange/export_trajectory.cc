// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_trajectory.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "kinematics/base/result.h"
#include "workflows/exchange/number_text.h"

namespace gaitwright {
namespace {

/// Texts around the numbers of a point; only JSON has quoted keys.
struct Dialect {
  const char* before_first;  // before the first key of a point
  const char* before;        // before the other keys
  const char* quote;
  const char* after;  // after each value except the last
};

constexpr Dialect kYaml = {"  - ", "    ", "", "\n"};
constexpr Dialect kJson = {"    {", "     ", "\"", ",\n"};

/// A text in double quotes, in the same form for YAML and JSON.
std::string Quoted(const std::string& text) { return nlohmann::ordered_json(text).dump(); }

std::string NamesList(const RobotModel& model) {
  std::string list = "[";
  for (const std::string& name : model.dof_names) list += (list.size() > 1 ? ", " : "") + Quoted(name);
  return list + "]";
}

std::string DurationOf(double time_s, const Dialect& dialect) {
  const auto all_ns = static_cast<std::int64_t>(std::llround(time_s * 1e9));
  constexpr std::int64_t kSecond = 1'000'000'000;
  return fmt::format("{{{0}sec{0}: {1}, {0}nanosec{0}: {2}}}", dialect.quote, all_ns / kSecond, all_ns % kSecond);
}

class PointWriter {
 public:
  PointWriter(const RobotModel& model, const Dialect& dialect, std::string& text)
      : model_(model), dialect_(dialect), text_(text) {}

  void Write(const MotionRows& rows, std::size_t k) {
    time_s_ = rows.time_s[k];
    text_ += dialect_.before_first;
    List("positions", rows.q[k].tail(model_.num_dofs()));
    text_ += dialect_.before;
    List("velocities", rows.v[k].tail(model_.num_dofs()));
    text_ += dialect_.before;
    List("accelerations", rows.a.empty() ? VectorX() : VectorX(rows.a[k].tail(model_.num_dofs())));
    text_ += dialect_.before;
    List("effort", rows.tau.empty() ? VectorX() : rows.tau[k]);
    text_ += dialect_.before;
    text_ += fmt::format("{0}time_from_start{0}: {1}", dialect_.quote,
                         DurationOf(rows.time_s[k] - rows.time_s.front(), dialect_));
  }

 private:
  void List(const char* key, const VectorX& values) {
    text_ += fmt::format("{0}{1}{0}: [", dialect_.quote, key);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) {
        throw InvalidArgument(fmt::format("'{}' of joint '{}' is {} at {} s; only finite numbers are exported", key,
                                          model_.dof_names[static_cast<std::size_t>(i)], values[i], time_s_));
      }
      if (i > 0) text_ += ", ";
      AppendDecimal(values[i], text_);
    }
    text_ += std::string("]") + dialect_.after;
  }

  const RobotModel& model_;
  const Dialect& dialect_;
  std::string& text_;
  double time_s_ = 0.0;
};

}  // namespace

std::string JointTrajectoryYaml(const RobotModel& model, const MotionRows& rows) {
  std::string text =
      "header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: \"\"\njoint_names: " + NamesList(model) + "\npoints:\n";
  PointWriter points(model, kYaml, text);
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    points.Write(rows, k);
    text += '\n';
  }
  return text;
}

std::string JointTrajectoryJson(const RobotModel& model, const MotionRows& rows) {
  std::string text = "{\"header\": {\"stamp\": {\"sec\": 0, \"nanosec\": 0}, \"frame_id\": \"\"},\n\"joint_names\": " +
                     NamesList(model) + ",\n\"points\": [\n";
  PointWriter points(model, kJson, text);
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    points.Write(rows, k);
    text += k + 1 < rows.time_s.size() ? "},\n" : "}\n";
  }
  return text + "]}\n";
}

}  // namespace gaitwright
