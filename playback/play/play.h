// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "playback/engine/controller.h"
#include "playback/engine/world_options.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// Options of a playback.
struct PlayOptions {
  WorldOptions world;
  double log_rate_hz = 200.0;
  double settle_s = 0.2;
  double hold_s = 0.3;
  Vector3 push_force_W = Vector3::Zero();
  double push_at_s = 0.0;
  double push_for_s = 0.1;
  std::string push_on = "base";
  double start_x_m = 0.0, start_y_m = 0.0, start_z_m = 0.0;
  double start_roll_rad = 0.0, start_pitch_rad = 0.0, start_yaw_rad = 0.0;
  bool lock_unmoved = false;
  double fall_height_lowest = 0.4;

  /// Pushes in addition to the push of the fields above.
  std::vector<TimedPush> more_pushes = {};
  /// Called when a phase of the plan ends (MotionPlan::gates), before the clock goes on; may be empty.
  std::function<void(const GateRecord& phase)> on_phase = {};
  /// Start positions of the independent joints if different from the plan, within their limits, size n [rad] or [m];
  /// empty for the plan's.
  VectorX start_joints = VectorX();

  OptionFields Fields() {
    return Joined(
        {world.Fields(),
         WithBasics({"log_rate_hz", "settle_s", "hold_s", "push_force_x_n", "push_force_y_n", "push_force_z_n",
                     "push_at_s", "push_for_s", "push_on"},
                    {{"log_rate_hz", &log_rate_hz, "Hz", 1.0, 100000.0,
                      "Samples per second in the log; must divide 1 / step_s."},
                     {"settle_s", &settle_s, "s", 0.0, 10.0,
                      "Time that the robot stands in the plan's first posture before the plan's clock starts."},
                     {"hold_s", &hold_s, "s", 0.0, 60.0, "Time that the playback continues after the plan's end."},
                     {"push_force_x_n", &push_force_W.x(), "N", -1e5, 1e5,
                      "Pushing force on the robot along x of the world frame."},
                     {"push_force_y_n", &push_force_W.y(), "N", -1e5, 1e5,
                      "Pushing force on the robot along y of the world frame."},
                     {"push_force_z_n", &push_force_W.z(), "N", -1e5, 1e5,
                      "Pushing force on the robot along z of the world frame."},
                     {"push_at_s", &push_at_s, "s", 0.0, 1e6, "Time on the plan's clock at which the push begins."},
                     {"push_for_s", &push_for_s, "s", 0.0, 1e6, "Duration of the push."},
                     {"push_on", &push_on, "", 0.0, 0.0,
                      "Point of the push: centre of mass of the base (base), of the whole robot (robot), or of the "
                      "body of a named link."},
                     {"start_x_m", &start_x_m, "m", -10.0, 10.0,
                      "Offset of the start from the plan's first base position, along x of the world frame."},
                     {"start_y_m", &start_y_m, "m", -10.0, 10.0,
                      "Offset of the start from the plan's first base position, along y of the world frame."},
                     {"start_z_m", &start_z_m, "m", -10.0, 10.0,
                      "Upward offset of the start from the plan's first base position; a displaced robot is also "
                      "lifted clear of the ground."},
                     {"start_roll_rad", &start_roll_rad, "rad", -3.2, 3.2,
                      "Rotation of the start from the plan's first base orientation, about x of the base."},
                     {"start_pitch_rad", &start_pitch_rad, "rad", -3.2, 3.2,
                      "Rotation of the start from the plan's first base orientation, about y of the base."},
                     {"start_yaw_rad", &start_yaw_rad, "rad", -3.2, 3.2,
                      "Rotation of the start from the plan's first base orientation, about z of the world frame."},
                     {"lock_unmoved", &lock_unmoved, "", 0.0, 0.0,
                      "Welds the joints that the plan never moves, which makes the simulation faster."},
                     {"fall_height_lowest", &fall_height_lowest, "1", 0.0, 1.0,
                      "Share of the planned base height above the feet's ground below which the playback ends as a "
                      "fall; 0 never ends it."}})});
  }
};

/// Plays a plan in physics. The robot starts in the plan's first state and settles; then the controller is called once
/// per step until the plan's end and a short hold. On an unplanned slope the robot starts rotated with the ground.
/// `start_*` options displace its start, clear of the ground; it then settles without external support.
///
/// At a gate of the plan the clock stops, nothing is logged, and the controller is called with this time. The gate ends
/// when every joint is near its target and the gate's feet carry force, or at its maximum waiting time.
///
/// Ends 0.3 s after a clear fall: the up axis of the base is over 1 rad from the planned one, a body that is not a foot
/// stays on the ground for 0.2 s, or the base is below `fall_height_lowest` of the plan's height (each above the mean
/// height of the standing feet, measured where they touch). Stops at once, also while the robot settles, if the
/// state or the command is not finite, or the state exceeds 1e6. Then the log holds the reason and at least one sample,
/// which may be before the end of the first interval.
///
/// The log has one sample per 1 / log_rate_hz from the plan's start, each at the end of its interval. A foot's stance
/// begins with the first step with force, and ends with the first step without force. Gaps of less than 15 ms do not
/// end a stance; short touches are kept. Stances at the start begin with the log. Deterministic: no clock, path or
/// address enters the log.
///
/// @return the log; a failure if plan and robot do not belong together, the plan lasts more than an hour, or a push
/// would begin after the end.
/// @throws InvalidArgument for an option out of range, a log rate that does not divide the steps, a push on an unknown
/// link, `start_joints` of a wrong size, or bumps over more than 10,000 m^2 of ground.
Result<PlaybackLog> Play(const RobotModel& model, const MotionPlan& plan, Controller& controller,
                         const PlayOptions& options = {});

/// Reason for which Play would refuse these arguments, without a playback; nothing if it would accept them.
/// @throws as Play does.
std::optional<Failure> ReasonNotPlayed(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options);

/// Hash of all parts of a plan that affect a playback, which ties a log to its plan: the robot, the ground with its
/// friction and obstacles (not their names), the schedule, the footholds, and every column of the whole-body rows. Data
/// without effect on the playback (goal, parts, swings, provenance) is not included; PlanHash includes all. Writing and
/// reading a plan keeps its hash.
std::string MotionHash(const MotionPlan& plan);

}  // namespace gaitwright
