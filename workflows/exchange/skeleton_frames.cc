// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "workflows/exchange/skeleton_frames_internal.h"
#include "workflows/exchange/split_rotation_internal.h"

namespace gaitwright {

SkeletonFrames::SkeletonFrames(const RobotModel& model, MotionFormat format, const Matrix3& R_BS)
    : model_(model), R_BS_(R_BS) {
  table_.format = format;
  table_.turned_by_angles = true;
}

void SkeletonFrames::Begin(double time_s, const Vector3& p_S, const Matrix3& R_S) {
  table_.time_s.push_back(time_s);
  table_.base_m.emplace_back(R_BS_ * p_S);
  table_.quaternion.push_back(Quaternion(R_BS_ * R_S * R_BS_.transpose()).normalized().coeffs());
  // Angles of the frame before, so that the next ones are near to them.
  table_.q.push_back(table_.q.empty() ? model_.standing_joints : table_.q.back());
}

void SkeletonFrames::Turn(const std::string& name, const JointRun& run, const Matrix3& R_S) {
  constexpr double kWorse = 0.02;  // [rad]
  VectorX& q = table_.q.back();
  VectorX near = VectorX::Zero(static_cast<Eigen::Index>(run.dofs.size()));
  const bool first = table_.q.size() == 1;
  for (std::size_t i = 0; !first && i < run.dofs.size(); ++i) near[static_cast<Eigen::Index>(i)] = q[run.dofs[i]];
  const Matrix3 R_B = R_BS_ * R_S * R_BS_.transpose();
  SplitAngles split = SplitRotation(R_B, run.axes, near, first);
  auto left = std::find_if(left_.begin(), left_.end(), [&](const Left& one) { return one.name == name; });
  if (left == left_.end()) left = left_.insert(left_.end(), {name});
  if (!first && split.left_rad > left->most_rad + kWorse) split = SplitRotation(R_B, run.axes, near, true);
  for (std::size_t i = 0; i < run.dofs.size(); ++i) q[run.dofs[i]] = split.angles[static_cast<Eigen::Index>(i)];
  if (split.left_rad <= left->most_rad) return;
  left->most_rad = split.left_rad;
  left->at_s = table_.time_s.back();
}

MotionTable SkeletonFrames::Take() {
  constexpr double kSlight = 1e-3;  // [rad]
  constexpr std::size_t kShown = 5;
  std::erase_if(left_, [](const Left& one) { return one.most_rad < kSlight; });
  std::stable_sort(left_.begin(), left_.end(), [](const Left& a, const Left& b) { return a.most_rad > b.most_rad; });
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, left_.size()); ++i) {
    text += fmt::format("{}joint '{}' up to {:.3f} rad at {:.3f} s", i == 0 ? "" : ", ", left_[i].name,
                        left_[i].most_rad, left_[i].at_s);
  }
  if (left_.size() > kShown) text += fmt::format(", and {} more", left_.size() - kShown);
  if (!text.empty())
    table_.derived.push_back({"rotations left out", "about axes that the robot's joints do not have: " + text});
  return std::move(table_);
}

}  // namespace gaitwright
