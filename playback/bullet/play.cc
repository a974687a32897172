// SPDX-License-Identifier: BSD-3-Clause
#include "playback/bullet/play.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/version.h"
#include "planning/plan/check_motion.h"
#include "playback/bullet/fall_watch_internal.h"
#include "playback/bullet/off_plan_internal.h"
#include "playback/bullet/stance_recorder_internal.h"
#include "playback/bullet/world.h"

namespace gaitwright {
namespace {

constexpr double kLongestPlan = 3600.0;   // [s]
constexpr double kBumpsBeyondPlan = 2.0;  // bumpy ground around where the plan goes [m]

Failure Mismatch(const std::string& code, const std::string& message, const std::string& hint) {
  return {FailureKind::kBadInput, code, "Play", message, {hint}};
}

/// Why the plan cannot be played by this robot; empty code when it can.
Failure Misfit(const RobotModel& model, const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  if (w.size() == 0 || w.step_s <= 0.0) {
    return Mismatch("plan_without_motion", "the plan has no whole-body motion to play", "plan it again");
  }
  if (!(plan.duration_s() <= kLongestPlan) || !std::isfinite(w.start_s)) {
    return Mismatch("plan_too_long",
                    fmt::format("the plan lasts {:.6g} s from {:.6g} s on; at most {} s are played", plan.duration_s(),
                                w.start_s, kLongestPlan),
                    "see that its 'step_s' is right");
  }
  if (!model.hash.empty() && !plan.robot_hash.empty() && plan.robot_hash != model.hash) {
    return Mismatch("plan_of_other_robot",
                    fmt::format("the plan was made for robot '{}' ({}), and this is '{}' ({})", plan.robot,
                                plan.robot_hash, model.name, model.hash),
                    "play it with the robot in the plan itself, or plan again");
  }
  try {
    CheckMotion(model, w);
  } catch (const InvalidArgument& error) {
    return Mismatch("plan_of_other_robot", error.what(), "plan again for this robot");
  }
  return {};
}

/// Why a push of the options never comes; empty code when all do, or none is asked for.
Failure LatePush(const MotionPlan& plan, const PlayOptions& options) {
  const double end_s = plan.whole_body.end_s() + options.hold_s;
  for (const TimedPush& push : bullet::PushesOf(options)) {
    if (push.at_s < end_s) continue;
    return Mismatch(
        "late_push",
        fmt::format("the push begins at {} s, when the playback has ended: it ends at {:.3f} s", push.at_s, end_s),
        "push earlier");
  }
  return {};
}

/// The world's options with what the plan says: which joints never move, and where it goes.
WorldOptions WorldOf(const MotionPlan& plan, const PlayOptions& options) {
  WorldOptions world = options.world;
  Vector2 low = plan.whole_body.q.front().head<2>(), high = low;
  for (const VectorX& q : plan.whole_body.q) {
    low = low.cwiseMin(q.head<2>());
    high = high.cwiseMax(q.head<2>());
  }
  world.bumps_from_W = low - Vector2::Constant(kBumpsBeyondPlan);
  world.bumps_to_W = high + Vector2::Constant(kBumpsBeyondPlan);
  if (!options.lock_unmoved) return world;
  const VectorX& first = plan.whole_body.q.front();
  for (Eigen::Index i = 7; i < first.size(); ++i) {
    const bool still = std::all_of(plan.whole_body.q.begin(), plan.whole_body.q.end(),
                                   [&](const VectorX& q) { return std::abs(q[i] - first[i]) < 1e-9; });
    if (still) world.locked_dofs.push_back(static_cast<int>(i) - 7);
  }
  return world;
}

/// A state turned rigidly by X.
VectorX Moved(const Pose& X, VectorX q) {
  const Quaternion turn(X.linear());
  q.head<3>() = X * Vector3(q.head<3>());
  q.segment<4>(3) = (turn * Quaternion(q[6], q[3], q[4], q[5])).normalized().coeffs();
  return q;
}

VectorX MovedVelocity(const Pose& X, VectorX v) {
  v.head<3>() = X.linear() * Vector3(v.head<3>());
  v.segment<3>(3) = X.linear() * Vector3(v.segment<3>(3));
  return v;
}

/// Means and peaks since the last sample.
class Interval {
 public:
  void Add(const BulletWorld& world) {
    if (steps_ == 0) {
      sample_.tau = VectorX::Zero(world.tau().size());
      sample_.tau_peak = sample_.tau;
      sample_.wrenches.assign(world.feet().size(), {});
    }
    ++steps_;
    sample_.tau += world.tau();
    sample_.tau_peak = sample_.tau_peak.cwiseMax(world.tau().cwiseAbs());
    sample_.contact = 0;
    for (std::size_t i = 0; i < world.feet().size(); ++i) {
      const FootContact& foot = world.feet()[i];
      sample_.wrenches[i].force_W += foot.wrench.force_W;
      sample_.wrenches[i].moment_W += foot.wrench.moment_W;
      if (foot.touching) sample_.contact |= FootBit(static_cast<int>(i));
    }
  }

  LogSample Take(double time_s, const BulletWorld& world) {
    const double share = 1.0 / steps_;
    sample_.time_s = time_s;
    sample_.q = world.q();
    sample_.v = world.v();
    sample_.tau *= share;
    for (ContactWrench& wrench : sample_.wrenches) {
      wrench.force_W *= share;
      wrench.moment_W *= share;
    }
    steps_ = 0;
    return std::move(sample_);
  }

 private:
  int steps_ = 0;
  LogSample sample_;
};

/// One playback from start to end.
class Playback {
 public:
  Playback(const RobotModel& model, const MotionPlan& plan, Controller& controller, const PlayOptions& options)
      : model_(model),
        plan_(plan),
        controller_(controller),
        options_(options),
        world_options_(WorldOf(plan, options)),
        step_s_(options.world.step_s),
        stride_(StrideOf(options)),
        world_(model, plan.terrain, plan.whole_body.q.front(), world_options_),
        stances_(static_cast<int>(model.feet.size()), world_.total_mass_kg() * kGravity, step_s_,
                 1.0 / options.log_rate_hz),
        fall_(model, plan, options.fall_height_lowest) {
    input_.step_s = step_s_;
    input_.wrenches.resize(model.feet.size());
    for (const TimedPush& push : bullet::PushesOf(options))
      pushes_.emplace_back(push, bullet::PushedBody(model, push.on));
  }

  PlaybackLog Run() {
    const Vector2 start_W = plan_.whole_body.q.front().head<2>();
    const Pose X_tilt = GroundTilt(plan_.terrain, world_options_, start_W);
    const VectorX q_start = Moved(X_tilt, plan_.whole_body.q.front());
    world_.SetState(q_start, MovedVelocity(X_tilt, plan_.whole_body.v.front()));
    if (bullet::StartsOff(options_)) {
      world_.SetState(bullet::MovedOff(model_, options_, q_start), world_.v());
      world_.LiftOutOfGround(q_start);
    }
    controller_.Reset();
    StartLog(start_W);
    Settle();
    const long steps = std::lround((plan_.duration_s() + options_.hold_s) / step_s_);
    fall_.Start(log_.start_s);
    double end_s = log_.start_s;
    for (long k = 0; k < steps; ++k) {
      const double time_s = log_.start_s + static_cast<double>(k) * step_s_;
      if (!OneStep(time_s)) break;
      Record(time_s);
      end_s = log_.start_s + static_cast<double>(k + 1) * step_s_;
      if ((k + 1) % stride_ == 0) log_.samples.push_back(interval_.Take(end_s, world_));
      if (fall_.Over(end_s)) break;
    }
    FinishEstimates(end_s);
    log_.stances = stances_.Finish(end_s);
    return std::move(log_);
  }

 private:
  static long StrideOf(const PlayOptions& options) {
    const double steps = 1.0 / (options.log_rate_hz * options.world.step_s);
    if (std::abs(steps - std::round(steps)) > 1e-6 || steps < 0.5) {
      const double per_second = 1.0 / options.world.step_s, nearest = per_second / std::max(1.0, std::round(steps));
      throw InvalidArgument(
          fmt::format("option 'log_rate_hz' is {} Hz, which does not divide the {} steps per second; "
                      "the nearest that does is {:.6g}",
                      options.log_rate_hz, per_second, nearest));
    }
    return std::lround(steps);
  }

  void StartLog(const Vector2& start_W) {
    log_.program_version = Version();
    log_.robot = model_.name;
    log_.robot_hash = model_.hash;
    log_.plan_hash = MotionHash(plan_);
    log_.controller = controller_.Name();
    log_.start_s = plan_.whole_body.start_s;
    log_.log_rate_hz = options_.log_rate_hz;
    log_.step_s = step_s_;
    log_.total_mass_kg = world_.total_mass_kg();
    log_.friction = FrictionOf(plan_.terrain, world_options_, start_W);
    log_.saturated_s = VectorX::Zero(model_.num_dofs());
    PlayOptions copy = options_;
    log_.options = TextsOf(Prefixed("play", copy.Fields()));
  }

  /// The clock stands at the plan's start.
  void Settle() {
    const long steps = std::lround(options_.settle_s / step_s_);
    for (long k = 0; k < steps; ++k) OneStep(log_.start_s, false);
  }

  void ReadState(double time_s) {
    input_.time_s = time_s;
    input_.q = world_.q();
    input_.v = world_.v();
  }

  bool OneStep(double time_s, bool may_push = true) {
    ReadState(time_s);
    if (may_push) Push(time_s);
    const JointCommand command = controller_.Update(input_);
    LogEstimate();
    world_.Step(command);
    input_.contact = 0;
    for (std::size_t i = 0; i < world_.feet().size(); ++i) {
      input_.wrenches[i] = world_.feet()[i].wrench;
      if (world_.feet()[i].touching) input_.contact |= FootBit(static_cast<int>(i));
    }
    return world_.q().allFinite() && world_.v().allFinite();
  }

  void Push(double time_s) {
    for (const auto& [push, body] : pushes_) {
      const double since_s = time_s - push.at_s;
      if (since_s <= -0.5 * step_s_ || since_s >= push.for_s - 0.5 * step_s_) continue;
      body == bullet::kWholeRobot ? world_.PushRobot(push.force_W) : world_.PushBody(body, push.force_W);
    }
  }

  /// What a controller makes of the state that was logged last, it tells when it is asked the next time.
  void LogEstimate() {
    const BaseEstimate* estimate = controller_.Estimate();
    if (estimate != nullptr && !log_.samples.empty() && !log_.samples.back().estimate)
      log_.samples.back().estimate = *estimate;
  }

  void FinishEstimates(double end_s) {
    if (controller_.Estimate() == nullptr || log_.samples.empty() || log_.samples.back().estimate) return;
    ReadState(end_s);
    if (input_.q.allFinite() && input_.v.allFinite()) controller_.Update(input_);
    LogEstimate();
  }

  void Record(double time_s) {
    interval_.Add(world_);
    stances_.Add(time_s, world_.feet());
    fall_.Add(time_s + step_s_, world_);
    for (std::size_t i = 0; i < world_.saturated().size(); ++i) {
      if (world_.saturated()[i] != 0) log_.saturated_s[static_cast<Eigen::Index>(i)] += step_s_;
    }
    for (const std::string& link : world_.body_contacts()) {
      const bool known = std::any_of(log_.body_contacts.begin(), log_.body_contacts.end(),
                                     [&](const BodyContact& contact) { return contact.link == link; });
      if (!known) log_.body_contacts.push_back({time_s, link});
    }
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  Controller& controller_;
  PlayOptions options_;
  WorldOptions world_options_;
  double step_s_;
  long stride_;
  BulletWorld world_;
  bullet::StanceRecorder stances_;
  bullet::FallWatch fall_;
  Interval interval_;
  std::vector<std::pair<TimedPush, int>> pushes_;  ///< with the body they act on
  ControlInput input_;
  PlaybackLog log_;
};

}  // namespace

Result<PlaybackLog> Play(const RobotModel& model, const MotionPlan& plan, Controller& controller,
                         const PlayOptions& options) {
  PlayOptions checked = options;
  CheckOptions(checked.Fields());
  Failure misfit = Misfit(model, plan);
  if (misfit.code.empty()) misfit = LatePush(plan, options);
  if (!misfit.code.empty()) return misfit;
  return Playback(model, plan, controller, options).Run();
}

}  // namespace gaitwright
