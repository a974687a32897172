// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/body_clearance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace gaitwright {
namespace {

constexpr double kKept = 0.07;        // required clearance, as a share of the leg length
constexpr double kLeastShare = 0.25;  // smallest accepted share of that clearance
constexpr double kWindow_s = 0.02;

}  // namespace

BodyClearance::BodyClearance(const RobotModel& model, const Terrain& terrain)
    : model_(model),
      watch_(model, terrain),
      scratch_(model),
      limits_{std::vector<double>(model.feet.size(), -std::numeric_limits<double>::infinity()),
              kKept * model.leg_length_m()},
      ends_in_foot_(model.bodies.size(), false),
      kept_m_(static_cast<std::size_t>(watch_.num_parts()), limits_.body_m) {
  for (const Foot& foot : model.feet) ends_in_foot_[static_cast<std::size_t>(foot.body)] = true;
}

const std::vector<GroundHit>& BodyClearance::NearAt(const VectorX& q) {
  ForwardKinematics(model_, q, scratch_);
  return watch_.Look(scratch_, limits_);
}

/// Limits the required clearance of each part to its clearance in this posture.
void BodyClearance::LimitBy(const VectorX& q) {
  for (const GroundHit& hit : NearAt(q)) {
    double& kept = kept_m_[static_cast<std::size_t>(hit.part)];
    kept = std::min(kept, std::max(hit.distance_m, 0.0));
  }
}

double BodyClearance::Look(const WholeBodyTrajectory& rows, const std::vector<RigidBodySample>& samples) {
  LimitBy(rows.q.front());
  LimitBy(rows.q.back());
  double lacking = 0.0;
  std::map<std::pair<int, int>, std::pair<double, Place>> worst;  // by part and time window
  for (std::size_t k = 0; k < rows.q.size(); ++k) {
    const RigidBodySample& sample = samples[k];
    for (const GroundHit& hit : NearAt(rows.q[k])) {
      const double kept = kept_m_[static_cast<std::size_t>(hit.part)], lacks = share_ * kept - hit.distance_m;
      if (ends_in_foot_[static_cast<std::size_t>(hit.body)] || lacks <= 0.0) continue;
      lacking = std::max(lacking, kLeastShare * kept - hit.distance_m);
      auto& [most, place] = worst[{hit.part, static_cast<int>(sample.time_s / kWindow_s)}];
      if (lacks <= most) continue;
      most = lacks;
      const ExitPlane out = watch_.ExitPlaneOf(hit);
      const Vector3 p_CQ_B = RotationOf(sample.angles_rad).transpose() * (out.p_W - sample.p_WC);
      const double offset_m = out.normal_W.dot(out.p_W) - hit.distance_m;
      place = {{sample.time_s, p_CQ_B, out.normal_W, offset_m, *hit.link}, kept};
    }
  }
  for (const auto& [where, found] : worst) places_.push_back(found.second);
  return lacking;
}

std::vector<RigidClearance> BodyClearance::Wanted() const {
  std::vector<RigidClearance> wanted;
  for (const Place& place : places_) {
    wanted.push_back(place.touching);
    wanted.back().offset_m += share_ * place.kept_m;
  }
  return wanted;
}

bool BodyClearance::Ease() {
  const double eased = std::max(0.5 * share_, kLeastShare);
  const bool less = eased < share_;
  share_ = eased;
  return less;
}

}  // namespace gaitwright
