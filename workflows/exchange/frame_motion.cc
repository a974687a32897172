// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "kinematics/base/text.h"
#include "planning/plan/json_part_internal.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/read_motion_internal.h"

namespace gaitwright {
namespace {

constexpr int kOfBase = 7;

/// Where the description begins the joint of a name; the end of the text if it does not.
std::size_t PlaceOfJoint(const std::string& description, const std::string& name) {
  for (const char quote : {'"', '\''}) {
    const std::string attribute = fmt::format("name={}{}{}", quote, name, quote);
    for (std::size_t at = description.find(attribute); at != std::string::npos;
         at = description.find(attribute, at + 1)) {
      const std::size_t tag = description.rfind('<', at);
      if (tag != std::string::npos && description.compare(tag + 1, 5, "joint") == 0) return at;
    }
  }
  return description.size();
}

std::string JoinedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Turns frames into rows of a motion.
class FrameTable {
 public:
  FrameTable(const RobotModel& model, const ImportOptions& options, MotionFormat format)
      : options_(options), order_(DescribedJointOrder(model)) {
    table_.format = format;
    for (const std::string& name : order_) {
      dofs_.push_back(model.DofIndex(name));
      const bool prismatic = model.LeaderOf(dofs_.back()).is_prismatic();
      scale_.push_back(prismatic ? LengthUnit() : options.angle_unit == "deg" ? std::numbers::pi / 180.0 : 1.0);
    }
  }

  int columns() const { return kOfBase + static_cast<int>(order_.size()); }

  /// @param frame  `columns` numbers.
  void Add(double time_s, const double* frame) {
    table_.time_s.push_back(time_s);
    table_.base_m.emplace_back(LengthUnit() * Vector3(frame[0], frame[1], frame[2]));
    Eigen::Vector4d quaternion(frame[3], frame[4], frame[5], frame[6]);
    if (options_.quaternion_order == "wxyz") quaternion = {frame[4], frame[5], frame[6], frame[3]};
    table_.quaternion.push_back(quaternion);
    VectorX q(static_cast<Eigen::Index>(order_.size()));
    for (std::size_t i = 0; i < order_.size(); ++i) q[dofs_[i]] = scale_[i] * frame[kOfBase + i];
    table_.q.push_back(std::move(q));
  }

  MotionTable Take() {
    table_.derived.push_back(
        {"columns",
         fmt::format("base x y z, quaternion {}, then {} joints in the order of the robot's description: {}",
                     options_.quaternion_order == "wxyz" ? "w x y z" : "x y z w", order_.size(), JoinedNames(order_))});
    return std::move(table_);
  }

 private:
  double LengthUnit() const { return options_.length_unit == "mm" ? 1e-3 : 1.0; }

  const ImportOptions& options_;
  const std::vector<std::string> order_;
  std::vector<int> dofs_;
  std::vector<double> scale_;
  MotionTable table_;
};

bool Increases(const CsvTable& table) {
  for (int row = 1; row < table.rows(); ++row) {
    if (!(table.At(row, 0) > table.At(row - 1, 0))) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> DescribedJointOrder(const RobotModel& model) {
  std::vector<std::pair<std::size_t, std::string>> places;
  for (const std::string& name : model.dof_names) places.emplace_back(PlaceOfJoint(model.urdf_text, name), name);
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [place, name] : places) names.push_back(std::move(name));
  return names;
}

Result<MotionTable> ParseNumberFrames(const RobotModel& model, const std::string& text, const std::string& source,
                                      const ImportOptions& options) {
  const Result<CsvTable> table = ParseNumberTable(text, source);
  if (!table) return table.failure();
  FrameTable frames(model, options, MotionFormat::kFramesCsv);
  const int extra = table->num_columns() - frames.columns();
  if (extra != 0 && !(extra == 1 && Increases(*table))) {
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kColumns,
        "ImportMotion",
        fmt::format("'{}' has {} columns without names; robot '{}' needs {}: base x y z, quaternion x y z w, and {} "
                    "joints; or {} with times first",
                    source, table->num_columns(), model.name, frames.columns(), frames.columns() - kOfBase,
                    frames.columns() + 1),
        {"write a first line with the names of the columns, see docs/import.md"}};
  }
  for (int row = 0; row < table->rows(); ++row) {
    const double* const values = &table->values[static_cast<std::size_t>(row * table->num_columns())];
    frames.Add(extra == 1 ? options.time_unit_s() * values[0] : row / options.rate_hz, values + extra);
  }
  MotionTable motion = frames.Take();
  if (extra == 0) motion.derived.push_back({"times", fmt::format("{} frames a second (rate_hz)", options.rate_hz)});
  return motion;
}

bool HoldsJsonFrames(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{' && text.find("\"Frames\"") != std::string::npos;
}

Result<MotionTable> ParseJsonFrames(const RobotModel& model, const std::string& text, const std::string& source,
                                    const ImportOptions& options) {
  try {
    const JsonPart::Json json = ParseJsonOnce(text);
    const JsonPart root(json);
    root.Object({"FrameDuration", "Frames"},
                {"LoopMode", "EnableCycleOffsetPosition", "EnableCycleOffsetRotation", "MotionWeight"});
    const double step_s = root.At("FrameDuration").NumberIn(1e-4, 1.0);
    const std::vector<JsonPart> rows = root.At("Frames").List();
    if (rows.size() > static_cast<std::size_t>(kMostCsvRows))
      root.At("Frames").Refuse(fmt::format("has more than {} frames", kMostCsvRows));
    FrameTable frames(model, options, MotionFormat::kFramesJson);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const std::vector<double> frame = rows[row].Numbers();
      if (frame.size() != static_cast<std::size_t>(frames.columns())) {
        rows[row].Refuse(
            fmt::format("has {} numbers; robot '{}' needs {}: base x y z, quaternion x y z w, and {} joints",
                        frame.size(), model.name, frames.columns(), frames.columns() - kOfBase));
      }
      frames.Add(static_cast<double>(row) * step_s, frame.data());
    }
    return frames.Take();
  } catch (const InvalidArgument& error) {
    return RefusedMotion(source, error.what());
  } catch (const JsonPart::Json::exception&) {
    return RefusedMotion(source, ReasonNoJson(text));
  }
}

double CoarseSmoothingHz(const MotionTable& table) {
  constexpr double kFine = 0.0101, kShare = 0.2;  // [s], of the rate
  if (table.rows() < 2 || !table.v.empty()) return 0.0;
  const double step_s = (table.time_s.back() - table.time_s.front()) / (table.rows() - 1);
  return step_s > kFine ? kShare / step_s : 0.0;
}

}  // namespace gaitwright
