// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "kinematics/base/options.h"
#include "planning/plan/json_part_internal.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/deepmimic_motion_internal.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/skeleton_frames_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kHeadColumns = 8;  // duration, position, quaternion

/// The joints of a frame: each run is a quaternion if it has several hinges, otherwise an angle.
struct DeepMimicLayout {
  std::vector<JointRun> runs;
  std::size_t columns = kHeadColumns;
};

/// @param least  hinges in a run that are a ball joint.
DeepMimicLayout LayoutOf(const RobotModel& model, std::size_t least) {
  DeepMimicLayout layout;
  for (const std::vector<int>& run : StemRuns(model)) {
    if (run.size() >= least) {
      layout.runs.push_back(RunOf(model, run));
      layout.columns += 4;
      continue;
    }
    for (const int dof : run) layout.runs.push_back(RunOf(model, {dof}));
    layout.columns += run.size();
  }
  return layout;
}

Quaternion WFirst(const double* q) { return {q[0], q[1], q[2], q[3]}; }

class DeepMimicReader {
 public:
  DeepMimicReader(const RobotModel& model, const ImportOptions& options)
      : model_(model),
        unit_m_(options.length_unit == "mm" ? 1e-3 : 1.0),
        radians_(options.angle_unit == "deg" ? std::numbers::pi / 180.0 : 1.0) {}

  MotionTable Run(const JsonPart& root) {
    root.Object({"Frames"}, {"Loop", "EnableCycleOffsetPosition", "EnableCycleOffsetRotation"});
    const std::vector<JsonPart> rows = root.At("Frames").List();
    if (rows.empty()) root.At("Frames").Refuse("is empty");
    if (rows.size() > static_cast<std::size_t>(kMostCsvRows))
      root.At("Frames").Refuse(fmt::format("has more than {} frames", kMostCsvRows));
    for (const JsonPart& row : rows) frames_.push_back(row.Numbers());
    ChooseLayout(rows.front());
    for (std::size_t k = 0; k < rows.size(); ++k) CheckFrame(rows[k], k);
    return Table();
  }

 private:
  void ChooseLayout(const JsonPart& first) {
    std::string accepted;
    std::size_t before = 0;
    for (const std::size_t least : {std::size_t{3}, std::size_t{2}, std::size_t{4}}) {  // 4: hinges only
      layout_ = LayoutOf(model_, least);
      if (frames_.front().size() == layout_.columns) return;
      if (layout_.columns == before) continue;
      before = layout_.columns;
      accepted += fmt::format("{}{} ({})", accepted.empty() ? "" : ", ", layout_.columns,
                              least == 3   ? "ball joints of three hinges"
                              : least == 2 ? "ball joints of two or three"
                                           : "hinges only");
    }
    first.Refuse(fmt::format("has {} numbers; robot '{}' needs, with duration, position and quaternion first: {}",
                             frames_.front().size(), model_.name, accepted));
  }

  void CheckFrame(const JsonPart& row, std::size_t k) const {
    constexpr double kLongest = 1.0, kUnit = 0.01;
    const std::vector<double>& frame = frames_[k];
    if (frame.size() != layout_.columns) {
      row.Refuse(fmt::format("has {} numbers; the frames before have {}", frame.size(), layout_.columns));
    }
    const bool last = k + 1 == frames_.size();
    if (!(frame[0] >= (last ? 0.0 : 1e-4) && frame[0] <= kLongest))
      row.Refuse(fmt::format("has a duration of {:.6g} s; accepted: 0.0001 to {}", frame[0], kLongest));
    const auto check = [&](std::size_t at) {
      const double norm = WFirst(&frame[at]).norm();
      if (std::abs(norm - 1.0) > kUnit)
        row.Refuse(fmt::format("has a quaternion of length {:.4g} in columns {} to {}", norm, at + 1, at + 4));
    };
    check(4);
    std::size_t at = kHeadColumns;
    for (const JointRun& run : layout_.runs) {
      if (run.dofs.size() > 1) check(at);
      at += run.dofs.size() > 1 ? 4 : 1;
    }
  }

  /// Axes of the base from those of the file, of which y or z is upward, and x forward.
  Matrix3 AxesOfFile() const {
    std::array<std::vector<double>, 2> heights;
    for (const std::vector<double>& frame : frames_) {
      heights[0].push_back(unit_m_ * frame[2]);
      heights[1].push_back(unit_m_ * frame[3]);
    }
    const double standing = model_.standing_base_height_m;
    const double off_y = std::abs(MedianOf(heights[0]) - standing), off_z = std::abs(MedianOf(heights[1]) - standing);
    Matrix3 R_BS = Matrix3::Identity();
    if (off_y < off_z) R_BS << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    return R_BS;
  }

  MotionTable Table() {
    const Matrix3 R_BS = AxesOfFile();
    SkeletonFrames rows(model_, MotionFormat::kFramesDeepMimic, R_BS);
    double time_s = 0.0;
    for (const std::vector<double>& frame : frames_) {
      rows.Begin(time_s, unit_m_ * Vector3(frame[1], frame[2], frame[3]),
                 WFirst(&frame[4]).normalized().toRotationMatrix());
      time_s += frame[0];
      std::size_t at = kHeadColumns;
      for (const JointRun& run : layout_.runs) {
        if (run.dofs.size() > 1) {
          rows.Turn(model_.dof_names[static_cast<std::size_t>(run.dofs.front())], run,
                    WFirst(&frame[at]).normalized().toRotationMatrix());
          at += 4;
          continue;
        }
        const bool prismatic = model_.LeaderOf(run.dofs.front()).is_prismatic();
        rows.Set(run.dofs.front(), (prismatic ? unit_m_ : radians_) * frame[at++]);
      }
    }
    MotionTable table = rows.Take();
    table.derived.push_back({"columns", Description(R_BS)});
    return table;
  }

  std::string Description(const Matrix3& R_BS) const {
    std::string joints;
    for (const JointRun& run : layout_.runs) {
      std::vector<std::string> names;
      for (const int dof : run.dofs) names.push_back(model_.dof_names[static_cast<std::size_t>(dof)]);
      joints += joints.empty() ? "" : ", ";
      joints += names.size() == 1 ? names.front() : fmt::format("({})", fmt::join(names, " "));
    }
    return fmt::format(
        "duration, base x y z ({} upward), quaternion w x y z, then joints, in brackets as a quaternion "
        "w x y z: {}",
        R_BS.isIdentity() ? "z" : "y", joints);
  }

  const RobotModel& model_;
  const double unit_m_, radians_;
  std::vector<std::vector<double>> frames_;
  DeepMimicLayout layout_;
};

}  // namespace

bool HoldsDeepMimicFrames(const std::string& text) {
  return HoldsJsonFrames(text) && text.find("\"FrameDuration\"") == std::string::npos;
}

Result<MotionTable> ParseDeepMimic(const RobotModel& model, const std::string& text, const std::string& source,
                                   const ImportOptions& options) {
  try {
    const JsonPart::Json json = ParseJsonOnce(text);
    return DeepMimicReader(model, options).Run(JsonPart(json));
  } catch (const InvalidArgument& error) {
    return RefusedMotion(source, error.what());
  } catch (const JsonPart::Json::exception&) {
    return RefusedMotion(source, ReasonNoJson(text));
  }
}

}  // namespace gaitwright
