// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
#include "playback/score/stability_report.h"
#include "playback/sensing/sensing_options.h"

namespace gaitwright {

/// How a plan is played and judged.
struct PlayRequest {
  std::string controller = "stabilised";  ///< or one of ControllerNames()
  PlayOptions play;
  StabilisedOptions stabilised;
  RecoveringOptions recovering;
  GainOptions gains;
  SensingOptions sensing;
  ScoreOptions score;

  OptionFields Fields() {
    return Joined({Prefixed("play", play.Fields()), Prefixed("stabilised", stabilised.Fields()),
                   Prefixed("recovering", recovering.Fields()), Prefixed("gains", gains.Fields()), sensing.Fields(),
                   Prefixed("score", score.Fields())});
  }
};

/// What was measured and what it is worth.
struct PlayedWalk {
  PlaybackLog log;
  StabilityReport report;
  double realtime_factor = 0.0;  ///< simulated time over CPU time
};

/// A robot by name, or by the path of a URDF when that is not empty.
Result<RobotModel> ChooseRobot(const std::string& name, const std::string& urdf_path);

/// The robot that a plan carries in itself.
Result<RobotModel> RobotOf(const MotionPlan& plan);

/// The gains asked for, bounded for explicit torque control at the playback's own step, and the age of what it acts on,
/// unless another step is given.
GainOptions GainsFor(const PlayRequest& request);

/// Those that there are: stabilised, joint-pd, recovering.
const std::vector<std::string>& ControllerNames();
/// @throws InvalidArgument listing them for another name.
void CheckController(const std::string& name);

/// The controller of that name, behind the sensors asked for; where the joints' losses do not act (play.joint_losses)
/// it knows of none. Model and plan must outlive it.
/// @param recovery  what 'recovering' does; nothing where it is to be planned now.
/// @throws InvalidArgument as of CheckController, for a loop of the drives that the actuation does not have, and for a
/// plan that the controller is not for.
std::unique_ptr<Controller> MakeController(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                           const std::optional<RecoveryPlans>& recovery = {});

/// Plays and scores. The log's options are all of the request's, not only those of the physics.
Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request);

/// The same with a controller of somebody's own, behind the sensors asked for; the request's `controller` and what
/// shapes it are not looked at.
Result<PlayedWalk> PlayWalk(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                            std::unique_ptr<Controller> own);

/// The options of a plan and of its playback that are not at their usual values, by the plan's and the log's own words.
std::vector<OptionChange> ChangedOptions(const MotionPlan& plan, const PlaybackLog& log);

}  // namespace gaitwright
