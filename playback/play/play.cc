// SPDX-License-Identifier: BSD-3-Clause
#include "playback/play/play.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "kinematics/base/version.h"
#include "kinematics/stability/standing_width_internal.h"
#include "planning/plan/carried_plan.h"
#include "playback/engine/bounds_internal.h"
#include "playback/play/fall_watch_internal.h"
#include "playback/play/make_world.h"
#include "playback/play/off_plan_internal.h"
#include "playback/play/playable_internal.h"
#include "playback/play/stance_recorder_internal.h"
#include "playback/play/whole_steps.h"

namespace gaitwright {
namespace {

// Reasons for ending a playback early.
constexpr char kNoPhysics[] = "the physics gave a state that is not finite or far out of range";
constexpr char kNoCommand[] = "the controller gave a command that is not finite";
constexpr char kNoEstimate[] = "the controller's estimate of the base is not finite or far out of range";

bool IsPhysical(const BaseEstimate& estimate) {
  using engine::kMostOfState, engine::Within;
  return Within(estimate.p_WB, kMostOfState) && Within(estimate.R_WB.coeffs(), kMostOfState) &&
         Within(estimate.v_WB, kMostOfState) && Within(estimate.w_WB, kMostOfState);
}

/// Means and peaks since the last sample.
class Interval {
 public:
  void Add(const World& world) {
    if (steps_ == 0) {
      sample_.tau = VectorX::Zero(world.tau().size());
      sample_.tau_peak = sample_.effort_use = sample_.tau;
      sample_.wrenches.assign(world.feet().size(), {});
    }
    ++steps_;
    sample_.tau += world.tau();
    sample_.tau_peak = sample_.tau_peak.cwiseMax(world.motor_torque().cwiseAbs());
    sample_.effort_use = sample_.effort_use.cwiseMax(world.effort_use());
    sample_.contact = 0;
    for (std::size_t i = 0; i < world.feet().size(); ++i) {
      const FootContact& foot = world.feet()[i];
      sample_.wrenches[i].force_W += foot.wrench.force_W;
      sample_.wrenches[i].moment_W += foot.wrench.moment_W;
      if (foot.touching) sample_.contact |= FootBit(static_cast<int>(i));
    }
  }

  LogSample Take(double time_s, const World& world) {
    const double share = 1.0 / steps_;
    sample_.time_s = time_s;
    sample_.q = world.q();
    sample_.v = world.v();
    sample_.tau *= share;
    constexpr double kDigits = 1e4;  // rounding down keeps values below a limit from reaching it
    sample_.effort_use = (kDigits * sample_.effort_use).array().floor() / kDigits;
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

/// A push, the body that it acts on, and whether it has begun.
struct PushToCome {
  TimedPush push;
  int body = 0;
  bool began = false;
};

/// One playback from start to end.
class Playback {
 public:
  Playback(const RobotModel& model, const MotionPlan& plan, Controller& controller, const PlayOptions& options)
      : model_(model),
        plan_(plan),
        controller_(controller),
        options_(options),
        world_options_(playing::WorldOf(plan, options)),
        step_s_(options.world.step_s),
        stride_(WholeSteps("log_rate_hz", options.log_rate_hz, options.world.step_s)),
        world_(MakeWorld(model, plan.terrain, plan.whole_body.q.front(), world_options_)),
        stances_(static_cast<int>(model.feet.size()), world_->total_mass_kg() * kGravity, step_s_,
                 1.0 / options.log_rate_hz),
        fall_(model, plan, options.fall_height_lowest) {
    input_.step_s = step_s_;
    input_.lead_steps = world_options_.lead_steps();
    input_.wrenches.resize(model.feet.size());
    for (const TimedPush& push : playing::PushesOf(options))
      pushes_.push_back({push, playing::PushedBody(model, push.on)});
  }

  PlaybackLog Run() {
    const Vector2 start_W = plan_.whole_body.q.front().head<2>();
    const Pose X_tilt = GroundTilt(plan_.terrain, world_options_, start_W);
    const VectorX q_start = CarriedState(X_tilt, plan_.whole_body.q.front());
    world_->SetState(q_start, CarriedRates(X_tilt, plan_.whole_body.v.front()));
    if (playing::StartsOff(options_)) {
      world_->SetState(playing::MovedOff(model_, options_, q_start), world_->v());
      world_->LiftOutOfGround(q_start);
    }
    controller_.Reset();
    StartLog(start_W);
    const Penetration deepest = world_->DeepestPenetration();
    if (deepest.depth_m > PlaybackLog::kReportedPenetration) log_.start_penetration = deepest;
    const double end_s = Settle() ? FollowPlan() : log_.start_s;
    FinishEstimates(end_s);
    log_.stances = stances_.Finish(end_s);
    return std::move(log_);
  }

 private:
  void StartLog(const Vector2& start_W) {
    log_.program_version = Version();
    log_.robot = model_.name;
    log_.robot_hash = model_.hash;
    log_.plan_hash = MotionHash(plan_);
    log_.controller = controller_.Name();
    log_.start_s = plan_.whole_body.start_s;
    log_.log_rate_hz = options_.log_rate_hz;
    log_.step_s = step_s_;
    log_.total_mass_kg = world_->total_mass_kg();
    log_.friction = FrictionOf(plan_.terrain, world_options_, start_W);
    log_.saturated_s = VectorX::Zero(model_.num_dofs());
    PlayOptions copy = options_;
    log_.options = TextsOf(Prefixed("play", copy.Fields()));
  }

  /// Lets the robot settle, if it can stand still; the clock stays at the plan's start. @return whether the playback
  /// can continue.
  bool Settle() {
    const long steps = CanStandStill(model_) ? std::lround(options_.settle_s / step_s_) : 0;
    for (long k = 0; k < steps; ++k) {
      if (!OneStep(log_.start_s, false)) return false;
    }
    return true;
  }

  /// Waits at the gates of the plan up to a time. @return whether the playback can continue.
  bool PassGates(double time_s) {
    constexpr double kTime = 1e-9;
    for (; next_gate_ < plan_.gates.size() && plan_.gates[next_gate_].at_s <= time_s + kTime; ++next_gate_) {
      const PlanGate& gate = plan_.gates[next_gate_];
      const long longest = std::lround(gate.longest_s / step_s_);
      GateRecord record{gate.phase, gate.at_s, 0.0, IsMet(gate, time_s)};
      for (long k = 0; k < longest && !record.met; ++k) {
        if (!OneStep(time_s, false)) return false;
        record.waited_s = static_cast<double>(k + 1) * step_s_;
        record.met = IsMet(gate, time_s);
      }
      log_.gates.push_back(record);
      if (options_.on_phase) options_.on_phase(record);
    }
    return true;
  }

  bool IsMet(const PlanGate& gate, double time_s) const {
    const WholeBodyTrajectory& w = plan_.whole_body;
    const double row = std::clamp(std::round((time_s - w.start_s) / w.step_s), 0.0, w.size() - 1.0);
    const VectorX& planned = w.q[static_cast<std::size_t>(row)];
    const Eigen::Index n = model_.num_dofs();
    const double off = n == 0 ? 0.0 : (world_->q().tail(n) - planned.tail(n)).cwiseAbs().maxCoeff();
    return off <= gate.joints_within && (gate.contact & ~input_.contact) == 0;
  }

  /// @return the end time.
  double FollowPlan() {
    const long steps = std::lround((plan_.duration_s() + options_.hold_s) / step_s_);
    fall_.Start(log_.start_s);
    double end_s = log_.start_s;
    for (long k = 0; k < steps && !fall_.Over(end_s); ++k) {
      if (!PassGates(end_s) || !OneStep(end_s)) break;
      Record(end_s);
      end_s = log_.start_s + static_cast<double>(k + 1) * step_s_;
      if ((k + 1) % stride_ == 0) log_.samples.push_back(interval_.Take(end_s, *world_));
    }
    return end_s;
  }

  void ReadState(double time_s) {
    input_.time_s = time_s;
    input_.q = world_->q();
    input_.v = world_->v();
  }

  bool OneStep(double time_s, bool may_push = true) {
    ReadState(time_s);
    if (may_push) Push(time_s);
    const JointCommand command = controller_.Update(input_);
    if (!LogEstimate()) return BreakOff(StoppedBy::kController, kNoEstimate);
    if (!IsFinite(command)) return BreakOff(StoppedBy::kController, kNoCommand);
    world_->Step(command);
    if (!IsPhysical(*world_)) return BreakOff(StoppedBy::kPhysics, kNoPhysics);
    input_.contact = 0;
    for (std::size_t i = 0; i < world_->feet().size(); ++i) {
      input_.wrenches[i] = world_->feet()[i].wrench;
      if (world_->feet()[i].touching) input_.contact |= FootBit(static_cast<int>(i));
    }
    return true;
  }

  /// Logs the reason, and at least one sample: the last valid state. @return false
  bool BreakOff(StoppedBy by, const char* why) {
    log_.broke_off = why;
    log_.broke_off_by = by;
    if (!log_.samples.empty()) return false;
    const VectorX none = VectorX::Zero(model_.num_dofs());
    log_.samples.push_back({input_.time_s, input_.q, input_.v, none, none, none, input_.wrenches, input_.contact, {}});
    LogEstimate();
    return false;
  }

  void Push(double time_s) {
    for (auto& [push, body, began] : pushes_) {
      const double share = playing::ShareOfStep(push, time_s, step_s_);
      if (share == 0.0) continue;
      if (!began && push.force_W.allFinite()) log_.pushes.push_back(push);
      began = true;
      const Vector3 force_W = share * push.force_W;
      body == playing::kWholeRobot ? world_->PushRobot(force_W) : world_->PushBody(body, force_W);
    }
  }

  /// Adds the controller's estimate to the last logged sample. The controller gives it only in its next update. A
  /// sample with an invalid estimate is removed, unless it is the only one. @return false if the estimate is invalid
  bool LogEstimate() {
    const BaseEstimate* estimate = controller_.Estimate();
    if (estimate == nullptr) return true;
    const bool waits = !log_.samples.empty() && !log_.samples.back().estimate;
    if (IsPhysical(*estimate)) {
      if (waits) log_.samples.back().estimate = *estimate;
      return true;
    }
    if (waits && log_.samples.size() > 1) log_.samples.pop_back();
    return false;
  }

  void FinishEstimates(double end_s) {
    if (!log_.broke_off.empty() || controller_.Estimate() == nullptr) return;
    if (log_.samples.empty() || log_.samples.back().estimate) return;
    ReadState(end_s);
    controller_.Update(input_);
    if (!LogEstimate()) BreakOff(StoppedBy::kController, kNoEstimate);
  }

  void Record(double time_s) {
    interval_.Add(*world_);
    stances_.Add(time_s, world_->feet());
    fall_.Add(time_s + step_s_, *world_);
    log_.saturated_s += step_s_ * (world_->effort_use().array() >= 1.0).cast<double>().matrix();
    for (const std::string& link : world_->body_contacts()) {
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
  std::unique_ptr<World> world_;
  playing::StanceRecorder stances_;
  playing::FallWatch fall_;
  Interval interval_;
  std::vector<PushToCome> pushes_;
  std::size_t next_gate_ = 0;
  ControlInput input_;
  PlaybackLog log_;
};

}  // namespace

Result<PlaybackLog> Play(const RobotModel& model, const MotionPlan& plan, Controller& controller,
                         const PlayOptions& options) {
  if (auto failure = ReasonNotPlayed(model, plan, options)) return *failure;
  return Playback(model, plan, controller, options).Run();
}

}  // namespace gaitwright
