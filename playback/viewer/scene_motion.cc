// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"
#include "playback/viewer/packed_columns_internal.h"
#include "playback/viewer/scene_parts_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr int kSwingPoints = 25, kCirclePoints = 16;
constexpr double kPointFoot = 0.04;  // drawn radius of a foot without a sole, as a share of the leg length

/// One side of a motion, planned or measured, as columns.
class Columns {
 public:
  Columns(const RobotModel& model, const Terrain& terrain) : model_(model), terrain_(terrain) {}

  void Add(const MotionSample& sample, const VectorX& q, const VectorX& tau, FootSet contact) {
    Append(q, model_.nq(), q_);
    Append(tau, model_.num_dofs(), tau_);
    Append(sample.p_WC, 3, com_);
    AddOnGround(sample.dcm_W, sample.support, true, dcm_);
    AddOnGround(sample.p_WZ, sample.support, sample.has_zmp, zmp_);
    margin_.push_back(sample.has_zmp ? static_cast<float>(sample.zmp_margin_m()) : kNothing);
    for (std::size_t foot = 0; foot < sample.feet.size(); ++foot) {
      Append(sample.feet[foot].p_WF, 3, foot_);
      Append(sample.feet[foot].force_W, 3, force_);
      const double height = sample.feet[foot].height_m;
      height_.push_back(std::isfinite(height) ? static_cast<float>(height) : kNothing);
      contact_.push_back(static_cast<std::uint8_t>(contact >> foot & 1U));
    }
    AddSupport(sample.support);
  }

  Json Finished() {
    const int feet = static_cast<int>(model_.feet.size());
    return {{"q", Packed(model_.nq(), q_)},
            {"tau", Packed(model_.num_dofs(), tau_)},
            {"com_m", Packed(3, com_)},
            {"dcm_m", Packed(3, dcm_)},
            {"zmp_m", Packed(3, zmp_)},
            {"zmp_margin_m", Packed(1, margin_)},
            {"foot_m", Packed(3 * feet, foot_)},
            {"force_n", Packed(3 * feet, force_)},
            {"foot_height_m", Packed(feet, height_)},
            {"contact", Packed(feet, contact_)},
            {"support_first", Packed(1, support_first_)},
            {"support_m", Packed(3, support_)}};
  }

 private:
  /// Appends the numbers of a vector; gaps if their number is not `columns`.
  static void Append(const Eigen::Ref<const VectorX>& values, int columns, std::vector<float>& to) {
    const bool whole = values.size() == columns;
    for (Eigen::Index i = 0; i < columns; ++i) to.push_back(whole ? static_cast<float>(values[i]) : kNothing);
  }

  /// Adds a point in plan view at the height of the support's plane, in flight at the height of the ground.
  void AddOnGround(const Vector2& p_W, const Support& support, bool there, std::vector<float>& to) const {
    if (!there || !p_W.allFinite()) {
      to.insert(to.end(), 3, kNothing);
      return;
    }
    const double z = support.empty() ? GroundAt(terrain_, p_W).height_m : PlaneHeight(support, p_W);
    Append(Vector3(p_W.x(), p_W.y(), z), 3, to);
  }

  void AddSupport(const Support& support) {
    for (const Vector2& corner : support.polygon)
      Append(Vector3(corner.x(), corner.y(), PlaneHeight(support, corner)), 3, support_);
    support_first_.push_back(static_cast<std::uint32_t>(support_.size() / 3));
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  std::vector<float> q_, tau_, com_, dcm_, zmp_, margin_, foot_, force_, height_, support_;
  std::vector<std::uint8_t> contact_;
  std::vector<std::uint32_t> support_first_ = {0};
};

/// The outline of a foothold: the sole, or a circle.
std::vector<Vector3> OutlineOf(const RobotModel& model, const Foothold& foothold) {
  const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
  std::vector<Vector3> outline;
  for (const Vector2& corner : foot.sole_F) outline.emplace_back(foothold.X_WF * Vector3(corner.x(), corner.y(), 0.0));
  if (!outline.empty()) return outline;
  const double radius = kPointFoot * model.leg_length_m();
  for (int i = 0; i < kCirclePoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCirclePoints;
    outline.emplace_back(foothold.X_WF * Vector3(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  return outline;
}

}  // namespace

TrackScenes TracksScene(const RobotModel& model, const MotionPlan& plan, const PlaybackLog* log,
                        const MotionSeries& series, std::size_t stride) {
  std::vector<float> time_s;
  Columns planned(model, plan.terrain), measured(model, plan.terrain);
  for (std::size_t k = 0; k < series.planned.size(); k += stride) {
    const WholeBodySample& row = series.plan[k];
    time_s.push_back(static_cast<float>(series.planned[k].time_s));
    planned.Add(series.planned[k], row.q, row.tau, series.planned[k].stance);
    if (log == nullptr) continue;
    const LogSample& sample = log->samples[k];
    measured.Add(series.measured[k], sample.q, sample.tau, sample.contact);
  }
  return {Packed(1, time_s), planned.Finished(), log == nullptr ? Json(nullptr) : measured.Finished()};
}

Json GhostScene(const ShownMotion& shown, const MotionSeries& series, std::size_t stride) {
  const int columns = shown.model.nq();
  std::vector<float> q;
  for (std::size_t k = 0; k < series.planned.size(); k += stride) {
    const VectorX posture = shown.ghost->posture(series.planned[k].time_s - series.planned[0].time_s);
    if (posture.size() != 0 && posture.size() != columns) {
      throw InvalidArgument(fmt::format("SceneJson: the ghost '{}' has {} numbers, but robot '{}' needs {}",
                                        shown.ghost->title, posture.size(), shown.model.name, columns));
    }
    for (Eigen::Index i = 0; i < columns; ++i)
      q.push_back(posture.size() == 0 ? kNothing : static_cast<float>(posture[i]));
  }
  return {{"title", shown.ghost->title}, {"q", Packed(columns, q)}};
}

Json FootholdsScene(const RobotModel& model, const MotionPlan& plan) {
  Json list = Json::array();
  for (const Foothold& foothold : plan.footsteps.footholds) {
    Json outline = Json::array();
    for (const Vector3& corner : OutlineOf(model, foothold)) outline.push_back({corner.x(), corner.y(), corner.z()});
    list.push_back({{"foot", foothold.foot},
                    {"touchdown_s", foothold.touchdown_s},
                    {"liftoff_s", foothold.liftoff_s},
                    {"outline_m", outline}});
  }
  return list;
}

Json SwingsScene(const MotionPlan& plan) {
  Json list = Json::array();
  for (const SwingTrajectory& swing : plan.swings) {
    const SwingCurve curve = CurveOf(swing);
    std::vector<Vector3> points;
    for (int i = 0; i < kSwingPoints; ++i) {
      const double share = static_cast<double>(i) / (kSwingPoints - 1);
      points.push_back(Evaluate(curve, swing.start_s + share * (swing.end_s - swing.start_s)).X_WF.translation());
    }
    list.push_back(
        {{"foot", swing.foot}, {"start_s", swing.start_s}, {"end_s", swing.end_s}, {"points_m", PackedPoints(points)}});
  }
  return list;
}

}  // namespace gaitwright
