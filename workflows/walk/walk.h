// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/search/plan_walk.h"
#include "playback/control/gains.h"
#include "playback/control/recovering.h"
#include "playback/control/stabilised.h"
#include "playback/play/play.h"
#include "playback/score/agreement.h"
#include "playback/score/stability_report.h"
#include "playback/sensing/sensing_options.h"

namespace gaitwright {

struct FittedPolicy;

/// Request for playing and scoring a plan.
struct PlayRequest {
  std::string controller = "stabilised";  ///< one of ControllerNames()
  PlayOptions play;
  StabilisedOptions stabilised;
  RecoveringOptions recovering;
  GainOptions gains;
  SensingOptions sensing;
  ScoreOptions score;
  /// A learned policy that replaces `controller`, which is then "policy"; its plan is a CommandedPlan. See
  /// playback/policy/fit_policy_internal.h.
  std::shared_ptr<const FittedPolicy> policy = nullptr;

  OptionFields Fields() {
    return Joined({Prefixed("play", play.Fields()), Prefixed("stabilised", stabilised.Fields()),
                   Prefixed("recovering", recovering.Fields()), Prefixed("gains", gains.Fields()), sensing.Fields(),
                   Prefixed("score", score.Fields())});
  }
};

/// Log of a playback and its score.
struct ScoredPlayback {
  PlaybackLog log;
  StabilityReport report;
  double realtime_factor = 0.0;  ///< simulated time over CPU time
};

/// A playback in a second engine, and how it agrees with the first (A).
struct SecondPlayback : ScoredPlayback {
  Agreement agreement;
};

/// A plan played in one engine, or in two (`play.engine` "both"), both of which must pass.
struct PlayedWalk : ScoredPlayback {
  std::shared_ptr<const SecondPlayback> second = {};  ///< null if only one engine has played

  bool pass() const { return report.pass && (second == nullptr || second->report.pass); }
  double score() const { return second == nullptr ? report.score : std::min(report.score, second->report.score); }
  /// The playback that decides: the one that fails, otherwise the one with the lower score; the first if equal.
  const ScoredPlayback& decisive() const;
};

/// The default engine for proving a plan: "both", or "bullet" in a program that was built without MuJoCo.
std::string ProvingEngine();

/// A robot by name, or by the path of a URDF if that is not empty.
Result<RobotModel> ChooseRobot(const std::string& name, const std::string& urdf_path);

/// The robot that a plan contains.
Result<RobotModel> RobotOf(const MotionPlan& plan);

/// The requested gains, bounded for explicit torque control at the playback's step plus the feedback delay, unless
/// another step is given.
GainOptions GainsFor(const PlayRequest& request);

/// All controllers: stabilised, joint-pd, recovering.
const std::vector<std::string>& ControllerNames();
/// Name of the controller of a request with a learned policy; not one of ControllerNames().
inline constexpr char kPolicyController[] = "policy";
/// @throws InvalidArgument for another name; it lists the controllers.
void CheckController(const std::string& name);

/// The controller of this name, with the requested sensors; if joint losses are disabled (play.joint_losses), it
/// assumes none. Model and plan must outlive it.
/// @param recovery  plans of 'recovering'; if empty, they are planned in this call.
/// @throws InvalidArgument as of CheckController, for a drive loop that the actuation does not support, and for a plan
/// that the controller does not support.
std::unique_ptr<Controller> MakeController(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                           const std::optional<RecoveryPlans>& recovery = {});

/// Plays and scores, in both engines at the same time if `play.engine` is "both"; then the request's callbacks are
/// called from the first only. If the second engine refuses the robot or the ground (EngineRefusal), only the first one
/// decides, and its notes say so. Logs contain all options of the request, not only those of the physics.
Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request);

/// As above with your own controller, behind the requested sensors; the request's `controller` and its options are
/// ignored. With both engines, the playbacks run one after the other, and the controller is reset between them.
Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                            std::unique_ptr<Controller> own);

/// The options of a plan and its playback that differ from their defaults, from the plan and the log.
std::vector<OptionChange> ChangedOptions(const MotionPlan& plan, const PlaybackLog& log);

}  // namespace gaitwright
