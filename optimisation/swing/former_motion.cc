// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/former_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Poses of base and feet in a pass, by row.
struct Rows {
  double start_s = 0.0, step_s = 1.0;
  std::vector<Vector3> p_WB;
  std::vector<Quaternion> R_WB;
  std::vector<std::vector<Quaternion>> R_WF;  // by foot
  std::vector<double> radius_m;               // by foot

  /// The row before a time, and the fraction of the interval to the next row.
  std::pair<std::size_t, double> At(double time_s) const {
    const double place = std::clamp((time_s - start_s) / step_s, 0.0, static_cast<double>(p_WB.size() - 1));
    const std::size_t row = std::min(static_cast<std::size_t>(place), p_WB.size() - 2);
    return {row, place - static_cast<double>(row)};
  }
};

std::shared_ptr<const Rows> RowsOf(const RobotModel& model, const WholeBodyTrajectory& trajectory) {
  auto rows = std::make_shared<Rows>();
  rows->start_s = trajectory.start_s;
  rows->step_s = trajectory.step_s;
  rows->R_WF.resize(model.feet.size());
  for (const Foot& foot : model.feet) rows->radius_m.push_back(foot.radius);
  DynamicsScratch scratch(model);
  for (const VectorX& q : trajectory.q) {
    rows->p_WB.emplace_back(q.head<3>());
    rows->R_WB.emplace_back(q[6], q[3], q[4], q[5]);
    ForwardKinematics(model, q, scratch);
    for (std::size_t f = 0; f < model.feet.size(); ++f)
      rows->R_WF[f].emplace_back(FramePose(scratch, model.feet[f].body, model.feet[f].X_BF).linear());
  }
  return rows;
}

SwingRoll RollOf(const Rows& rows, const SwingTrajectory& swing) {
  const auto foot = static_cast<std::size_t>(swing.foot);
  if (rows.radius_m[foot] <= 0.0) return {};
  const double duration = swing.end_s - swing.start_s;
  const int pieces = std::max(2, static_cast<int>(std::lround(duration / rows.step_s)));
  const auto rotation = [&](int k) {
    const auto [row, share] = rows.At(swing.start_s + k * duration / pieces);
    return rows.R_WF[foot][row].slerp(share, rows.R_WF[foot][row + 1]).toRotationMatrix();
  };
  const SwingCurve curve = CurveOf(swing);
  // The curve's own z changes from the normal of the first ground to that of the second.
  const auto normal_W = [&](double piece) {
    return Vector3(Evaluate(curve, swing.start_s + piece * duration / pieces).X_WF.linear().col(2));
  };
  std::vector<Vector3> off_W = {Vector3::Zero()};
  Matrix3 last_W = rotation(0);
  for (int k = 1; k <= pieces; ++k) {
    const Matrix3 now_W = rotation(k);
    off_W.push_back(off_W.back() +
                    rows.radius_m[foot] * RotationLog(now_W * last_W.transpose()).cross(normal_W(k - 0.5)));
    last_W = now_W;
  }
  const Vector3 whole_W = off_W.back();
  for (int k = 0; k <= pieces; ++k)
    off_W[static_cast<std::size_t>(k)] -= SmoothStep(static_cast<double>(k) / pieces, swing.cruise).value * whole_W;
  return SwingRoll(std::move(off_W));
}

}  // namespace

Vector3 SwingRoll::At(double u) const {
  if (off_W_.empty()) return Vector3::Zero();
  const double place = std::clamp(u, 0.0, 1.0) * static_cast<double>(off_W_.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), off_W_.size() - 2);
  return off_W_[i] + (place - static_cast<double>(i)) * (off_W_[i + 1] - off_W_[i]);
}

FormerMotion MotionOf(const RobotModel& model, const WholeBodyTrajectory& trajectory,
                      const std::vector<SwingTrajectory>& swings) {
  if (trajectory.size() < 2) return {};
  const std::shared_ptr<const Rows> rows = RowsOf(model, trajectory);
  FormerMotion motion;
  motion.base = [rows](double time_s) {
    const auto [row, share] = rows->At(time_s);
    Pose X_WB = Pose::Identity();
    X_WB.translation() = rows->p_WB[row] + share * (rows->p_WB[row + 1] - rows->p_WB[row]);
    X_WB.linear() = rows->R_WB[row].slerp(share, rows->R_WB[row + 1]).toRotationMatrix();
    return X_WB;
  };
  motion.roll = [rows](const SwingTrajectory& swing) { return RollOf(*rows, swing); };
  motion.swings = swings;
  return motion;
}

std::vector<ReachSide> SidesInWorld(const std::vector<WorkspaceSide>& workspace_B, const Vector3& p_W,
                                    const Matrix3& R_WB, double beyond_m) {
  std::vector<ReachSide> sides;
  for (const WorkspaceSide& side : workspace_B) {
    const Vector3 normal_W = R_WB * side.normal;
    sides.push_back({normal_W, side.offset + normal_W.dot(p_W) + beyond_m});
  }
  return sides;
}

}  // namespace gaitwright
