// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/gestures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/dof_units.h"
#include "planning/tasks/free_path.h"

namespace gaitwright {
namespace {

constexpr double kOffStops = 0.05;  // margin to the joint limits, as a share of the range

/// Position of a limb's end as a function of the joints, with the base upright.
class LimbEnd {
 public:
  LimbEnd(const RobotModel& model, const Limb& limb)
      : model_(model), limb_(limb), scratch_(model), q_(StandingConfiguration(model)) {}

  Vector3 At(const VectorX& joints) {
    q_.tail(model_.num_dofs()) = joints;
    ForwardKinematics(model_, q_, scratch_);
    Pose X_BE = Pose::Identity();
    X_BE.translation() = limb_.p_BE;
    return FramePose(scratch_, limb_.end_body, X_BE).translation();
  }

 private:
  const RobotModel& model_;
  const Limb& limb_;
  DynamicsScratch scratch_;
  VectorX q_;
};

/// Range of a joint; a full turn if it has no limits.
struct Range {
  double low, high;

  static Range Of(const RobotModel& model, int dof) {
    const double low = model.dof_lower(dof), high = model.dof_upper(dof);
    if (!std::isfinite(low) || !std::isfinite(high)) return {-M_PI, M_PI};
    return {low + kOffStops * (high - low), high - kOffStops * (high - low)};
  }
  double Clamp(double position) const { return std::clamp(position, low, high); }
};

/// Moves one joint to its best value. Samples its range, then ever finer around the best sample.
void MoveToBest(LimbEnd& end, const VectorX& from, double metre_rad, const Range& range, int dof, VectorX& joints) {
  constexpr int kSamples = 24, kRefinements = 3;
  const auto worth = [&](double position) {
    VectorX tried = joints;
    tried[dof] = position;
    return end.At(tried).z() * metre_rad - 0.05 * std::abs(position - from[dof]);
  };
  double best = joints[dof], most = worth(best), low = range.low, high = range.high;
  for (int pass = 0; pass < kRefinements; ++pass) {
    const double step = (high - low) / kSamples;
    for (int k = 0; k <= kSamples; ++k) {
      const double position = low + k * step, value = worth(position);
      if (value <= most + 1e-12) continue;
      most = value;
      best = position;
    }
    low = range.Clamp(best - step);
    high = range.Clamp(best + step);
  }
  joints[dof] = best;
}

/// The collision-free share of a straight line in joint space, and the pair of links that ends it.
struct FreeShare {
  double share = 1.0;
  std::optional<Overlap> met;
};

FreeShare FreeShareOf(PathCheck& check, const VectorX& from, const VectorX& to) {
  constexpr int kHalvings = 7;
  FreeShare free{1.0, check.FirstMeeting(from, to)};
  if (!free.met) return free;
  double low = 0.0, high = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (check.FirstMeeting(from, from + middle * (to - from)) ? high : low) = middle;
  }
  free.share = 0.95 * low;
  return free;
}

}  // namespace

Result<VectorX> RaisedArm(const RobotModel& model, const Limb& arm, const VectorX& from) {
  constexpr int kRounds = 8;
  constexpr double kLeast = 0.25;  // of the leg's length
  LimbEnd end(model, arm);
  VectorX raised = from;
  for (int round = 0; round < kRounds; ++round) {
    const VectorX before = raised;
    for (const int dof : arm.dofs)
      MoveToBest(end, from, 10.0 / model.leg_length_m(), Range::Of(model, dof), dof, raised);
    if ((raised - before).cwiseAbs().maxCoeff() < 1e-3) break;
  }
  PathCheck check(model, StandingConfiguration(model));
  const FreeShare free = FreeShareOf(check, from, raised);
  raised = from + free.share * (raised - from);
  const double gain = end.At(raised).z() - end.At(from).z();
  if (!free.met || gain >= kLeast * model.leg_length_m()) return raised;
  return Failure{FailureKind::kInfeasible,
                 FailureCode::kSelfCollision,
                 "RaisedArm",
                 fmt::format("the arm that ends in '{}' can be raised by only {:.3f} m before '{}' and '{}' collide; "
                             "{:.3f} m or more is needed",
                             model.bodies[static_cast<std::size_t>(arm.end_body)].name, gain, free.met->link_a,
                             free.met->link_b, kLeast * model.leg_length_m()),
                 {}};
}

Result<Wave> WaveOf(const RobotModel& model, const Limb& arm, const VectorX& raised) {
  constexpr double kSwing = 0.35, kTry = 0.05;  // [rad]
  LimbEnd end(model, arm);
  int best = -1;
  double most = 0.0;
  for (const int dof : arm.dofs) {
    if (Slides(model, dof)) continue;
    const Range range = Range::Of(model, dof);
    VectorX tried = raised;
    tried[dof] = range.Clamp(raised[dof] + kTry);
    VectorX other = raised;
    other[dof] = range.Clamp(raised[dof] - kTry);
    const double sideways = std::abs(end.At(tried).y() - end.At(other).y());
    if (sideways <= most) continue;
    most = sideways;
    best = dof;
  }
  if (best < 0) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kNoWave,
                   "WaveOf",
                   fmt::format("the arm that ends in '{}' has no joint that moves it sideways",
                               model.bodies[static_cast<std::size_t>(arm.end_body)].name),
                   {}};
  }
  PathCheck check(model, StandingConfiguration(model));
  const Range range = Range::Of(model, best);
  const auto swung = [&](double by) {
    VectorX to = raised;
    to[best] = range.Clamp(raised[best] + by);
    return VectorX(raised + FreeShareOf(check, raised, to).share * (to - raised));
  };
  return Wave{swung(kSwing), swung(-kSwing)};
}

VectorX NoddedHead(const RobotModel& model, const Limb& head, const VectorX& from, double down_rad) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  int nods = head.dofs.front();
  double most = 0.0;
  for (const int dof : head.dofs) {
    const double along_y = scratch.axis_W[static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(dof)])].y();
    if (std::abs(along_y) <= std::abs(most)) continue;
    most = along_y;
    nods = dof;
  }
  VectorX joints = from;
  joints[nods] = Range::Of(model, nods).Clamp(from[nods] + (most > 0.0 ? down_rad : -down_rad));
  return joints;
}

}  // namespace gaitwright
