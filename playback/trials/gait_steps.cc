// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/gait_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "playback/engine/bumps.h"
#include "playback/engine/world.h"
#include "playback/play/off_plan_internal.h"

namespace gaitwright {
namespace {

constexpr double kTogether = 0.01;  // feet that land within this time of each other belong to one step [s]
constexpr double kNear = 0.1;       // a foot that lands later or earlier than this has not landed in that step [s]

/// Footholds with the same time of landing.
struct PlannedStep {
  double time_s = 0.0;
  std::vector<const Foothold*> footholds;
};

/// Whether a foot stands on this foothold when the plan begins.
bool IsFirst(const MotionPlan& plan, const Foothold& foothold) {
  return foothold.touchdown_s <= plan.whole_body.start_s + kTogether;
}

std::vector<PlannedStep> PlannedSteps(const MotionPlan& plan) {
  std::vector<PlannedStep> steps;
  for (const Foothold& foothold : plan.footsteps.footholds) {
    if (IsFirst(plan, foothold)) continue;
    if (steps.empty() || foothold.touchdown_s > steps.back().time_s + kTogether)
      steps.push_back({foothold.touchdown_s, {}});
    steps.back().footholds.push_back(&foothold);
  }
  return steps;
}

/// Place and heading of the base in plan view.
struct Heading {
  Vector2 p_WB = Vector2::Zero();
  double yaw_rad = 0.0;

  Vector2 Beside(const Vector2& p_W) const { return Eigen::Rotation2Dd(-yaw_rad) * Vector2(p_W - p_WB); }
};

Heading HeadingOf(const VectorX& q) { return {q.head<2>(), YawOf(BaseRotation(q))}; }

Heading Planned(const MotionPlan& plan, double time_s) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, time_s, sample);
  return HeadingOf(sample.q);
}

/// Interpolates between the samples around a time. @pre the log has samples
Heading Measured(const PlaybackLog& log, double time_s) {
  const auto later = [](const LogSample& sample, double t) { return sample.time_s < t; };
  const auto next = std::lower_bound(log.samples.begin(), log.samples.end(), time_s, later);
  if (next == log.samples.begin()) return HeadingOf(next->q);
  if (next == log.samples.end()) return HeadingOf(log.samples.back().q);
  const LogSample& before = *(next - 1);
  const double share = (time_s - before.time_s) / (next->time_s - before.time_s);
  const Heading a = HeadingOf(before.q), b = HeadingOf(next->q);
  return {a.p_WB + share * (b.p_WB - a.p_WB), a.yaw_rad + share * WrapAngle(b.yaw_rad - a.yaw_rad)};
}

/// The measured landing nearest to the planned one; null if none is near.
const StanceRecord* LandingOn(const Foothold& foothold, const PlaybackLog& log) {
  const StanceRecord* nearest = nullptr;
  double off_s = kNear;
  for (const StanceRecord& stance : log.stances) {
    const double off = std::abs(stance.touchdown_s - foothold.touchdown_s);
    if (stance.foot != foothold.foot || off > off_s || stance.touchdown_s <= log.start_s) continue;
    nearest = &stance;
    off_s = off;
  }
  return nearest;
}

/// Impulse of a push between two times [N s].
Vector3 ImpulseWithin(const TimedPush& push, double from_s, double to_s) {
  const double time = std::min(push.at_s + push.for_s, to_s) - std::max(push.at_s, from_s);
  return std::max(time, 0.0) * push.force_W;
}

/// Evaluates the steps of one playback.
class StepReader {
 public:
  StepReader(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options, const PlaybackLog& log)
      : plan_(plan),
        log_(log),
        pushes_(playing::PushesOf(options)),
        bumps_(BumpsOf(model, plan.whole_body.q.front(), options.world)),
        X_flat_(GroundTilt(plan.terrain, options.world, bumps_.start).inverse()),
        under_(model.feet.size(), 0.0),
        before_s_(plan.whole_body.start_s) {
    for (const Foothold& foothold : plan.footsteps.footholds) {
      if (IsFirst(plan, foothold))
        under_[static_cast<std::size_t>(foothold.foot)] = BumpAt(foothold.X_WF.translation());
    }
  }

  GaitStep Next(const PlannedStep& planned) {
    GaitStep step;
    AddPushes(planned.time_s, step);
    step.landed = true;
    const double share = 1.0 / static_cast<double>(planned.footholds.size());
    for (const Foothold* foothold : planned.footholds) AddLanding(*foothold, share, step);
    AddGround(planned, step);
    if (!step.landed) step.late_s = step.forward_m = step.left_m = 0.0;
    before_s_ = planned.time_s;
    return step;
  }

 private:
  void AddPushes(double time_s, GaitStep& step) const {
    Vector3 impulse_W = Vector3::Zero();
    for (const TimedPush& push : pushes_) impulse_W += ImpulseWithin(push, before_s_, time_s);
    const Vector2 impulse = Eigen::Rotation2Dd(-Planned(plan_, time_s).yaw_rad) * Vector2(impulse_W.head<2>());
    step.push_forward_n_s = impulse.x();
    step.push_left_n_s = impulse.y();
  }

  void AddLanding(const Foothold& foothold, double share, GaitStep& step) {
    const StanceRecord* landing = LandingOn(foothold, log_);
    const Vector3 p_planned = foothold.X_WF.translation();
    under_[static_cast<std::size_t>(foothold.foot)] = BumpAt(landing != nullptr ? landing->p_touchdown_W : p_planned);
    if (landing == nullptr) {
      step.landed = false;
      return;
    }
    const double time_s = landing->touchdown_s;
    const Vector2 off = Measured(log_, time_s).Beside(landing->p_touchdown_W.head<2>()) -
                        Planned(plan_, time_s).Beside(p_planned.head<2>());
    step.late_s += share * (time_s - foothold.touchdown_s);
    step.forward_m += share * off.x();
    step.left_m += share * off.y();
  }

  /// @pre the places of the landing feet are known.
  void AddGround(const PlannedStep& planned, GaitStep& step) const {
    double landing = 0.0, others = 0.0;
    std::vector<char> lands(under_.size(), 0);
    for (const Foothold* foothold : planned.footholds) lands[static_cast<std::size_t>(foothold->foot)] = 1;
    int count = 0;
    for (std::size_t foot = 0; foot < under_.size(); ++foot) {
      (lands[foot] != 0 ? landing : others) += under_[foot];
      count += lands[foot];
    }
    const int left = static_cast<int>(under_.size()) - count;
    step.ground_m = landing / count - (left > 0 ? others / left : 0.0);
  }

  double BumpAt(const Vector3& p_W) const {
    if (bumps_.amplitude == 0.0) return 0.0;
    return bumps_.HeightAt(Vector3(X_flat_ * p_W).head<2>());
  }

  const MotionPlan& plan_;
  const PlaybackLog& log_;
  const std::vector<TimedPush> pushes_;
  const Bumps bumps_;
  const Pose X_flat_;          ///< from the actual ground to the ground without slope
  std::vector<double> under_;  ///< height of the bumps under each foot, at its current or last stance [m]
  double before_s_;            ///< time of the previous step
};

}  // namespace

GaitScale GaitScaleOf(const RobotModel& model, const MotionPlan& plan) {
  GaitScale scale{model.leg_length_m(), model.total_mass_kg, 0.0};
  const std::vector<PlannedStep> steps = PlannedSteps(plan);
  if (steps.size() > 1)
    scale.step_s = (steps.back().time_s - steps.front().time_s) / static_cast<double>(steps.size() - 1);
  return scale;
}

std::vector<GaitStep> GaitStepsOf(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options,
                                  const PlaybackLog& log) {
  std::vector<GaitStep> steps;
  if (plan.whole_body.q.empty() || log.samples.empty()) return steps;
  StepReader reader(model, plan, options, log);
  for (const PlannedStep& planned : PlannedSteps(plan)) steps.push_back(reader.Next(planned));
  return steps;
}

}  // namespace gaitwright
