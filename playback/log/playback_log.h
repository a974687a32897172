// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Estimate of the base that the controller used.
struct BaseEstimate {
  Vector3 p_WB = Vector3::Zero();  ///< [m]
  Quaternion R_WB = Quaternion::Identity();
  Vector3 v_WB = Vector3::Zero(), w_WB = Vector3::Zero();  ///< in W [m/s], [rad/s]
};

/// Measurements of one log interval, at its end. Forces and torques are means over the interval.
struct LogSample {
  double time_s = 0.0;
  VectorX q, v;        ///< in the orders of RobotModel
  VectorX tau;         ///< applied at the independent joints, mean [N m]
  VectorX tau_peak;    ///< by motor (ActuatorOf): largest magnitude in the interval [N m]
  VectorX effort_use;  ///< by motor: largest share of the current limit, 1 at the limit; 0 without a limit
  std::vector<ContactWrench> wrenches;  ///< by foot: mean over the interval, moment about the contact frame origin
  FootSet contact = 0;                  ///< feet in contact at time_s
  std::optional<BaseEstimate> estimate = {};  ///< of q and v, if the controller used one; in all samples or in none
};

/// One stay of a foot on the ground, as measured.
struct StanceRecord {
  int foot = 0;
  double touchdown_s = 0.0, liftoff_s = 0.0;  ///< liftoff_s is the playback's end if the foot still stands
  Vector3 p_touchdown_W = Vector3::Zero();    ///< contact point [m]
  double touchdown_speed_m_s = 0.0;           ///< of the foot, just before contact
  double slip_m = 0.0;                        ///< integral of the tangential speed of the material contact point
  double peak_normal_n = 0.0;                 ///< low-passed by the log interval
  double penetration_m = 0.0;                 ///< at the deepest point
  double friction_use_max = 0.0;  ///< tangential over mu times normal, where the normal force is over 5 % of m g
};

/// A contact of a body that is not a foot.
struct BodyContact {
  double time_s = 0.0;
  std::string link;
  bool operator==(const BodyContact&) const = default;
};

/// Deepest penetration of a robot into the ground or an obstacle.
struct Penetration {
  double depth_m = 0.0;  ///< 0 without contact; then the names are empty
  std::string link;      ///< of the robot, as in its description
  std::string solid;     ///< name of the patch, height field or obstacle; "ground" with bumps

  bool operator==(const Penetration&) const = default;
};

/// A force on the robot during a time interval.
struct TimedPush {
  Vector3 force_W = Vector3::Zero();  ///< [N]
  double at_s = 0.0, for_s = 0.1;     ///< on the plan's clock
  std::string on = "base";            ///< see PlayOptions::push_on

  bool operator==(const TimedPush&) const = default;
};

/// Outcome of a gate of the plan, after its phase ended.
struct GateRecord {
  std::string phase;
  double at_s = 0.0, waited_s = 0.0;  ///< on the plan's clock, which stops while waiting
  bool met = true;                    ///< whether the condition was measured

  bool operator==(const GateRecord&) const = default;
};

/// What ended a playback early.
enum class StoppedBy { kPhysics, kController };
/// The name in files: `physics` or `controller`.
const char* StoppedByName(StoppedBy by);

/// Measurements of a simulation; never copied from the plan. A pure value.
struct PlaybackLog {
  static constexpr int kSchema = 5;
  static constexpr double kReportedPenetration = 0.001;  ///< [m]

  std::string program_version;  ///< of the program that played
  std::string robot, robot_hash, plan_hash, controller;
  double start_s = 0.0, log_rate_hz = 200.0, step_s = 0.001;
  double total_mass_kg = 0.0, friction = 0.0;
  std::vector<LogSample> samples;
  std::vector<StanceRecord> stances;       ///< sorted by touch-down
  std::vector<BodyContact> body_contacts;  ///< first contact of each link
  std::vector<GateRecord> gates;           ///< of the plan, up to the end of the playback
  std::vector<TimedPush> pushes;           ///< pushes that began during the playback, in order of their start
  VectorX saturated_s;                     ///< time each motor (ActuatorOf) spent at its effort limit [s]
  std::vector<std::pair<std::string, std::string>>
      options;                                   ///< every option of the playback, "play." before those of Play
  std::optional<Penetration> start_penetration;  ///< in the first posture, if deeper than kReportedPenetration
  std::string broke_off;  ///< reason of an early end, such as a state that is not finite; else ""
  StoppedBy broke_off_by = StoppedBy::kPhysics;  ///< after an early end
};

}  // namespace gaitwright
