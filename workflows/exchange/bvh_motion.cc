// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "kinematics/base/options.h"
#include "workflows/exchange/bvh_file_internal.h"
#include "workflows/exchange/bvh_motion_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/skeleton_frames_internal.h"

namespace gaitwright {
namespace {

/// A unit of lengths.
struct LengthUnitOfFile {
  const char* name;
  double metres;
};
constexpr std::array<LengthUnitOfFile, 3> kLengthUnits = {{{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}};

/// How a skeleton at rest lies in the robot's base.
struct SkeletonFit {
  Matrix3 R_BS = Matrix3::Identity();
  LengthUnitOfFile unit = kLengthUnits[0];
};

/// The rotation by right angles that is nearest to R.
Matrix3 NearestRightAngles(const Matrix3& R) {
  Matrix3 best = Matrix3::Identity();
  double most = -4.0;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (y == x) continue;
      for (int signs = 0; signs < 4; ++signs) {
        Matrix3 one;
        one.row(0) = Vector3::Unit(x) * ((signs & 1) != 0 ? -1.0 : 1.0);
        one.row(1) = Vector3::Unit(y) * ((signs & 2) != 0 ? -1.0 : 1.0);
        one.row(2) = one.row(0).cross(one.row(1));
        const double trace = (one.transpose() * R).trace();
        if (trace > most) {
          most = trace;
          best = one;
        }
      }
    }
  }
  return best;
}

double AngleBetween(const Matrix3& A, const Matrix3& B) { return Eigen::AngleAxisd(A.transpose() * B).angle(); }

class BvhReader {
 public:
  BvhReader(const RobotModel& model, const BvhFile& file, const ImportOptions& options)
      : model_(model),
        file_(file),
        radians_(options.angle_unit == "rad" ? 1.0 : std::numbers::pi / 180.0),
        options_(options) {}

  MotionTable Run() {
    FindPartners();
    const SkeletonFit fit = Fit();
    SkeletonFrames frames(model_, MotionFormat::kFramesBvh, fit.R_BS);
    for (int k = 0; k < file_.frames(); ++k) {
      frames.Begin(k * file_.step_s, fit.unit.metres * file_.PositionOf(0, k), file_.RotationOf(0, k, radians_));
      for (const auto& [joint, run] : runs_) Move(fit, joint, run, k, frames);
    }
    MotionTable table = frames.Take();
    ReportFit(fit, table);
    return table;
  }

 private:
  const std::string& NameOf(int joint) const { return file_.joints[static_cast<std::size_t>(joint)].name; }

  /// Whether a joint of the skeleton ever turns.
  bool Turns(int joint) const {
    constexpr double kStill = 1e-3;  // [rad]
    const Matrix3 first = file_.RotationOf(joint, 0, radians_);
    if (AngleBetween(Matrix3::Identity(), first) > kStill) return true;
    for (int k = 1; k < file_.frames(); ++k) {
      if (AngleBetween(first, file_.RotationOf(joint, k, radians_)) > kStill) return true;
    }
    return false;
  }

  void FindPartners() {
    std::vector<std::string> names;
    for (const BvhJoint& joint : file_.joints) names.push_back(joint.name);
    names.front().clear();  // the root is the base, whatever its name
    const std::vector<std::vector<int>> partners = PartnersOf(model_, names);
    std::vector<std::string> alone, missing;
    std::vector<bool> has(model_.dof_names.size(), false);
    for (int joint = 1; joint < static_cast<int>(names.size()); ++joint) {
      const std::vector<int>& dofs = partners[static_cast<std::size_t>(joint)];
      for (const int dof : dofs) has[static_cast<std::size_t>(dof)] = true;
      if (!dofs.empty()) {
        runs_.emplace_back(joint, RunOf(model_, dofs));
      } else if (Turns(joint)) {
        alone.push_back(NameOf(joint));
      } else {
        unused_.push_back(fmt::format("joint '{}', which does not turn", NameOf(joint)));
      }
    }
    for (std::size_t dof = 0; dof < has.size(); ++dof) {
      if (!has[dof]) missing.push_back(model_.dof_names[dof]);
    }
    RefuseWithoutPartners(alone, missing);
  }

  void RefuseWithoutPartners(const std::vector<std::string>& alone, const std::vector<std::string>& missing) {
    const bool may_lack = options_.missing_joints != "refuse" && missing.size() < model_.dof_names.size();
    std::string why;
    if (!alone.empty())
      why =
          fmt::format("{} of its joints move no joint of robot '{}': {}", alone.size(), model_.name, QuotedList(alone));
    if (!missing.empty() && !may_lack) {
      why += fmt::format("{}{} of {} joints of robot '{}' have no partner in it: {}", why.empty() ? "" : "; ",
                         missing.size(), model_.dof_names.size(), model_.name, QuotedList(missing));
    }
    if (!why.empty()) {
      throw InvalidArgument(why +
                            "; a skeleton is read if it has the robot's own joints, by name, so retarget the "
                            "motion first");
    }
    if (!missing.empty()) missing_ = missing;
  }

  /// Place of a joint at rest, from the root, in the unit and axes of the file.
  Vector3 RestPlaceOf(int joint) const {
    Vector3 place = Vector3::Zero();
    for (; joint > 0; joint = file_.joints[static_cast<std::size_t>(joint)].parent)
      place += file_.joints[static_cast<std::size_t>(joint)].offset;
    return place;
  }

  /// Umeyama, IEEE Trans. Pattern Anal. Mach. Intell. 13(4), 1991, doi:10.1109/34.88573, equations 40 to 42, without
  /// the translation, since both begin at the root.
  SkeletonFit Fit() const {
    constexpr double kFlat = 1e-3, kMostTilt = 0.35;  // share; [rad]
    Matrix3 H = Matrix3::Zero();
    double size = 0.0;
    for (const auto& [joint, run] : runs_) {
      const Vector3 p_S = RestPlaceOf(joint);
      H += run.p * p_S.transpose();
      size += p_S.squaredNorm();
    }
    const Eigen::JacobiSVD<Matrix3> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vector3& sizes = svd.singularValues();
    if (!(sizes[1] > kFlat * sizes[0])) {
      throw InvalidArgument(
          "its axes are unknown, because the joints of its skeleton at rest (OFFSET) are at one place or on one line");
    }
    Vector3 signs(1.0, 1.0, svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0 ? -1.0 : 1.0);
    const Matrix3 R = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    SkeletonFit fit;
    fit.R_BS = NearestRightAngles(R);
    fit.unit = UnitOf(sizes.dot(signs) / size);
    const double tilt = AngleBetween(fit.R_BS, R);
    if (tilt > kMostTilt) {
      throw InvalidArgument(
          fmt::format("its skeleton at rest (OFFSET) is turned by {:.2f} rad against the robot at zero positions; {}",
                      tilt, Advice()));
    }
    CheckPlaces(fit);
    return fit;
  }

  LengthUnitOfFile UnitOf(double scale) const {
    if (options_.length_unit == "m") return kLengthUnits[0];
    if (options_.length_unit == "mm") return kLengthUnits[2];
    constexpr double kMostOff = 1.25;
    for (const LengthUnitOfFile& unit : kLengthUnits) {
      if (scale < kMostOff * unit.metres && scale > unit.metres / kMostOff) return unit;
    }
    throw InvalidArgument(fmt::format(
        "the robot is {:.4g} times as large in m as its skeleton in the file's unit, which is neither m, cm "
        "nor mm; use --length-unit m or mm",
        scale));
  }

  static std::string Advice() {
    return "the skeleton must have the robot's own joints, and at rest the posture of the robot at zero positions";
  }

  void CheckPlaces(const SkeletonFit& fit) const {
    constexpr double kMostOff = 0.3;  // share of the size
    double off = 0.0, size = 0.0, farthest = 0.0;
    int worst = 0;
    for (const auto& [joint, run] : runs_) {
      const double distance = (run.p - fit.R_BS * (fit.unit.metres * RestPlaceOf(joint))).norm();
      off += distance * distance;
      size += run.p.squaredNorm();
      if (distance <= farthest) continue;
      farthest = distance;
      worst = joint;
    }
    if (off <= kMostOff * kMostOff * size) return;
    throw InvalidArgument(fmt::format(
        "joint '{}' of its skeleton at rest (OFFSET) is {:.3f} m away from the robot's at zero positions; {}",
        NameOf(worst), farthest, Advice()));
  }

  void Move(const SkeletonFit& fit, int joint, const JointRun& run, int frame, SkeletonFrames& frames) const {
    if (!model_.LeaderOf(run.dofs.front()).is_prismatic()) {
      frames.Turn(NameOf(joint), run, file_.RotationOf(joint, frame, radians_));
      return;
    }
    const Vector3 moved = file_.PositionOf(joint, frame) - file_.joints[static_cast<std::size_t>(joint)].offset;
    frames.Set(run.dofs.front(), run.axes.front().dot(fit.R_BS * (fit.unit.metres * moved)));
  }

  void ReportFit(const SkeletonFit& fit, MotionTable& table) {
    const auto named = [&](Eigen::Index axis) {
      const Vector3 in_file = fit.R_BS.row(axis);
      Eigen::Index i = 0;
      in_file.cwiseAbs().maxCoeff(&i);
      return fmt::format("{}{}", in_file[i] < 0.0 ? "-" : "", "xyz"[i]);
    };
    table.derived.push_back(
        {"skeleton", fmt::format("lengths in {}, {} forward, {} to the left, {} upward, from its joints at rest",
                                 fit.unit.name, named(0), named(1), named(2))});
    std::string balls;
    for (const auto& [joint, run] : runs_) {
      if (run.dofs.size() < 2) continue;
      std::vector<std::string> names;
      for (const int dof : run.dofs) names.push_back(model_.dof_names[static_cast<std::size_t>(dof)]);
      balls += fmt::format("{}'{}' to {}", balls.empty() ? "" : "; ", NameOf(joint), QuotedList(names));
    }
    if (!balls.empty()) table.derived.push_back({"ball joints", balls});
    if (!missing_.empty())
      table.derived.push_back({"position of " + QuotedList(missing_), "as in the standing posture"});
    table.unused_columns = unused_;
  }

  const RobotModel& model_;
  const BvhFile& file_;
  const double radians_;  ///< of one unit of the file's angles
  const ImportOptions& options_;
  std::vector<std::pair<int, JointRun>> runs_;  ///< by joint of the skeleton
  std::vector<std::string> unused_, missing_;
};

}  // namespace

Result<MotionTable> ParseBvhMotion(const RobotModel& model, const std::string& text, const std::string& source,
                                   const ImportOptions& options) {
  try {
    const BvhFile file = ParseBvh(text);
    return BvhReader(model, file, options).Run();
  } catch (const InvalidArgument& error) {
    return RefusedMotion(source, error.what());
  }
}

}  // namespace gaitwright
