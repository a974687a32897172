// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <mutex>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/base/free_memory_internal.h"
#include "kinematics/model/joint_losses.h"
#include "kinematics/model/load_robot.h"
#include "playback/control/joint_pd.h"
#include "playback/play/make_world.h"
#include "playback/play/whole_steps.h"
#include "playback/policy/policy_controller_internal.h"
#include "playback/sensing/sensing_controller.h"
#include "workflows/walk/idle_options.h"
#include "workflows/walk/plan_recovery.h"

namespace gaitwright {

GainOptions GainsFor(const PlayRequest& request) {
  constexpr double kLongest = 0.1;  // of explicit_step_s [s]
  GainOptions gains = request.gains;
  if (request.play.world.actuation != "torque" || gains.explicit_step_s != 0.0) return gains;
  const double delay_s =
      DriveLoopOf(request.sensing.drive_loop) == DriveLoop::kSensed ? request.sensing.LoopDelay() : 0.0;
  gains.explicit_step_s = std::min(request.play.world.step_s + delay_s, kLongest);
  return gains;
}

Result<RobotModel> ChooseRobot(const std::string& name, const std::string& urdf_path) {
  return urdf_path.empty() ? LoadNamedRobot(name) : LoadRobot(urdf_path);
}

Result<RobotModel> RobotOf(const MotionPlan& plan) {
  Result<RobotModel> model = LoadRobotFromText(plan.urdf_text, plan.yaml_text, plan.robot, plan.meshes);
  if (model && model->hash != plan.robot_hash) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kRobotHash,
                   "RobotOf",
                   fmt::format("the plan was made for robot {} ({}), but contains another ({})", plan.robot,
                               plan.robot_hash, model->hash),
                   {"make the plan again"}};
  }
  return model;
}

namespace {

/// The stabiliser's options for the kind of state that the controller receives.
StabilisedOptions StabilisedFor(const PlayRequest& request) {
  StabilisedOptions options = request.stabilised;
  if (request.sensing.state != StateSourceNames().front()) options.stance_damping *= options.sensed_damping;
  return options;
}

std::unique_ptr<Controller> BareController(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                           const std::optional<RecoveryPlans>& recovery) {
  const GainOptions gains = GainsFor(request);
  if (request.policy != nullptr)
    return std::make_unique<PolicyController>(model, request.policy, plan.whole_body.start_s, gains);
  CheckController(request.controller);
  if (request.controller == "joint-pd") return std::make_unique<JointPd>(model, plan, gains);
  if (request.controller == "stabilised") return MakeStabilised(model, plan, StabilisedFor(request), gains);
  if (recovery) return MakeRecovering(model, plan, *recovery, request.recovering, StabilisedFor(request), gains);
  const Result<RecoveryPlans> planned = PlanRecovery(model);
  if (!planned) throw InvalidArgument(planned.failure().message);
  return MakeRecovering(model, plan, *planned, request.recovering, StabilisedFor(request), gains);
}

/// A controller with its own copy of the robot, whose joints have no losses.
class OfLosslessJoints final : public Controller {
 public:
  OfLosslessJoints(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                   const std::optional<RecoveryPlans>& recovery)
      : model_(WithoutLosses(model)), inner_(BareController(model_, plan, request, recovery)) {}

  JointCommand Update(const ControlInput& input) override { return inner_->Update(input); }
  void Reset() override { inner_->Reset(); }
  const BaseEstimate* Estimate() const override { return inner_->Estimate(); }
  std::string Name() const override { return inner_->Name(); }

 private:
  const RobotModel model_;
  const std::unique_ptr<Controller> inner_;
};

void CheckLoop(const PlayRequest& request) {
  if (DriveLoopOf(request.sensing.drive_loop) == DriveLoop::kOwn || request.play.world.actuation == "torque") return;
  throw InvalidArgument("option 'drive_loop' is 'sensed', which needs play.actuation=torque");
}

/// @throws InvalidArgument for a sensor rate whose period is not a whole number of time steps.
void CheckRates(PlayRequest request) {
  for (const OptionField& field : request.sensing.Fields()) {
    const double* rate_hz = field.key.ends_with("_rate_hz") ? std::get<double*>(field.target) : nullptr;
    if (rate_hz != nullptr && *rate_hz > 0.0 && !FirstIdle(request, {field.key}))
      (void)WholeSteps(field.key, *rate_hz, request.play.world.step_s);
  }
}

}  // namespace

const std::vector<std::string>& ControllerNames() {
  static const std::vector<std::string> names = {"stabilised", "joint-pd", "recovering"};
  return names;
}

void CheckController(const std::string& name) {
  const std::vector<std::string>& names = ControllerNames();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InvalidArgument(fmt::format("there is no controller '{}'; accepted: '{}'", name, fmt::join(names, "', '")));
}

std::unique_ptr<Controller> MakeController(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                           const std::optional<RecoveryPlans>& recovery) {
  CheckLoop(request);
  CheckRates(request);
  std::unique_ptr<Controller> bare = request.play.world.joint_losses
                                         ? BareController(model, plan, request, recovery)
                                         : std::make_unique<OfLosslessJoints>(model, plan, request, recovery);
  return BehindSensors(model, plan, std::move(bare), request.sensing);
}

namespace {

/// @param controller  already behind its sensors. @param scoring  if not null, held while the playback is scored.
Result<ScoredPlayback> PlayBy(Controller& controller, const RobotModel& model, const MotionPlan& plan,
                              const PlayRequest& request, std::mutex* scoring = nullptr) {
  PlayRequest checked = request;
  const CpuClock clock;
  Result<PlaybackLog> log = Play(model, plan, controller, request.play);
  if (!log) return log.failure();
  ScoredPlayback played;
  const double cpu = std::max(clock.elapsed_s(), 1e-9);
  played.log = std::move(*log);
  played.log.options = TextsOf(checked.Fields());
  if (!played.log.samples.empty())
    played.realtime_factor = (played.log.samples.back().time_s - played.log.start_s) / cpu;
  const auto alone = scoring == nullptr ? std::unique_lock<std::mutex>() : std::unique_lock(*scoring);
  played.report = Score(model, plan, played.log, request.score);
  if (scoring != nullptr) ReleaseFreedMemory();
  return played;
}

constexpr char kBoth[] = "both";
constexpr double kLongPlayback = 60.0;  // [s]

PlayRequest InEngine(PlayRequest request, const std::string& engine) {
  request.play.world.engine = engine;
  return request;
}

/// Plays in the engine of the request.
Result<ScoredPlayback> PlayInOne(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                 std::mutex* scoring = nullptr) {
  return PlayBy(*MakeController(model, plan, request), model, plan, request, scoring);
}

Result<PlayedWalk> AlonePlayed(Result<ScoredPlayback> played) {
  if (!played) return played.failure();
  return PlayedWalk{std::move(*played)};
}

Result<PlayedWalk> BothPlayed(const RobotModel& model, const MotionPlan& plan, Result<ScoredPlayback> first,
                              Result<ScoredPlayback> second) {
  if (!first) return first.failure();
  if (!second) return second.failure();
  Agreement agreement = AgreementOf(model, plan, first->log, second->log);
  auto other = std::make_shared<const SecondPlayback>(SecondPlayback{std::move(*second), std::move(agreement)});
  return PlayedWalk{std::move(*first), std::move(other)};
}

}  // namespace

std::string ProvingEngine() { return EngineNames().size() > 1 ? kBoth : EngineNames().front(); }

const ScoredPlayback& PlayedWalk::decisive() const {
  if (second == nullptr) return *this;
  const bool second_decides = report.pass != second->report.pass ? report.pass : second->report.score < report.score;
  if (second_decides) return *second;
  return *this;
}

Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request) {
  PlayRequest checked = request;
  CheckOptions(checked.Fields());
  if (request.play.world.engine != kBoth) return AlonePlayed(PlayInOne(model, plan, request));
  PlayRequest other = InEngine(request, "mujoco");
  other.play.on_phase = {};
  // A policy that is a function may not be called by two threads, and may have a memory.
  const bool in_order = request.policy != nullptr && request.policy->source.function;
  // Scoring takes twice the memory of a log, so long playbacks are scored one after the other.
  std::mutex one_scores;
  std::mutex* const scoring = plan.duration_s() > kLongPlayback ? &one_scores : nullptr;
  auto later = std::async(in_order ? std::launch::deferred : std::launch::async,
                          [&, scoring] { return PlayInOne(model, plan, other, scoring); });
  Result<ScoredPlayback> first = PlayInOne(model, plan, InEngine(request, "bullet"), scoring);
  try {
    Result<ScoredPlayback> second = later.get();
    return BothPlayed(model, plan, std::move(first), std::move(second));
  } catch (const EngineRefusal& refusal) {
    if (first) first->report.notes.push_back(fmt::format("not played in a second engine: {}", refusal.what()));
    return AlonePlayed(std::move(first));
  }
}

Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                            std::unique_ptr<Controller> own) {
  PlayRequest checked = request;
  CheckOptions(checked.Fields());
  CheckLoop(request);
  CheckRates(request);
  const std::unique_ptr<Controller> controller = BehindSensors(model, plan, std::move(own), request.sensing);
  if (request.play.world.engine != kBoth) return AlonePlayed(PlayBy(*controller, model, plan, request));
  Result<ScoredPlayback> first = PlayBy(*controller, model, plan, InEngine(request, "bullet"));
  PlayRequest other = InEngine(request, "mujoco");
  other.play.on_phase = {};
  controller->Reset();
  return BothPlayed(model, plan, std::move(first), PlayBy(*controller, model, plan, other));
}

std::vector<OptionChange> ChangedOptions(const MotionPlan& plan, const PlaybackLog& log) {
  WalkRequest walk;
  PlayRequest play;
  std::vector<OptionChange> changes = ChangesFrom(RequestFields(walk), plan.provenance.options);
  for (OptionChange& change : ChangesFrom(play.Fields(), log.options)) changes.push_back(std::move(change));
  return changes;
}

}  // namespace gaitwright
