// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"
#include "planning/plan/adjustment.h"
#include "planning/plan/gait.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A walking command: speeds and, by `extent`, the distance.
struct WalkCommand {
  enum class Extent { kDistance, kGoal, kSteps, kDuration };

  Extent extent = Extent::kDistance;
  double speed_m_s = 0.0;          ///< along the body's x; 0 uses the default if no other speed is given
  double lateral_speed_m_s = 0.0;  ///< along the body's y, left positive
  double yaw_rate_rad_s = 0.0;     ///< left positive
  double distance_m = 0.0;         ///< kDistance: length of the path; 0 with only a yaw rate is a quarter turn
  double duration_s = 0.0;         ///< kDuration: walking time, in whole cycles
  double goal_x_m = 0.0, goal_y_m = 0.0, goal_yaw_rad = 0.0;  ///< kGoal: base pose in its start frame
  int steps = 0;               ///< kSteps; kGoal unless 0: number of footfalls; the last ones close the stance
  double step_length_m = 0.0;  ///< kSteps without a speed: advance of the robot in each footfall

  bool operator==(const WalkCommand&) const = default;
};

/// A pose in plan view: x, y, yaw.
struct PlanarPose {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

  bool operator==(const PlanarPose&) const = default;
};

/// The planar path of the base over time, dense enough for linear interpolation.
struct BasePath {
  std::vector<double> time_s;
  std::vector<PlanarPose> pose;
};

/// The place of contact of a foot during one stance.
///
/// X_WF is the pose at touch-down of the sole frame (sole, line), or of the contact point on the ground with z along
/// the ground's normal (point, sphere). A spherical foot rolls: its contact point moves by `roll_W` until lift-off.
/// From `heel_off_s` on, a sole stands on its front edge only and turns about it until lift-off; see
/// heel_off_internal.h.
struct Foothold {
  int foot = 0;
  Pose X_WF = Pose::Identity();
  Vector3 roll_W = Vector3::Zero();  ///< [m]
  int patch = 0;                     ///< index of the surface: patches first, then height fields
  double touchdown_s = 0.0, liftoff_s = 0.0;
  std::optional<double> heel_off_s = {};  ///< nothing for a sole that stays flat
};

/// Footholds sorted by touch-down time, then foot. Each interval of contact of the schedule has exactly one.
struct FootstepPlan {
  std::vector<Foothold> footholds;
};

/// Sorts footholds by touch-down time, then by foot.
void SortFootholds(FootstepPlan& plan);

/// Index of the foothold of `foot` at `time_s`: the last one that began before, or the first one; -1 if the foot has
/// none.
int FootholdAt(const FootstepPlan& plan, int foot, double time_s);

/// Centre of mass, its derivatives and the zero-moment point on a uniform grid; one entry per sample.
struct CentroidalTrajectory {
  double start_s = 0.0, step_s = 0.0;
  std::vector<Vector3> p_WC, v_WC, a_WC;
  std::vector<Vector2> p_WZ;  ///< reference of the multibody ZMP [m]
  double omega_rad_s = 0.0;   ///< frequency of the pendulum model of the plan

  int size() const { return static_cast<int>(p_WC.size()); }
};

/// Motion of one foot's contact frame over one swing, see kinematics/trajectory/swing_curve.h: a straight minimum-jerk
/// move plus a bump along z or, around obstacles, a detour.
struct SwingTrajectory {
  int foot = 0;
  double start_s = 0.0, end_s = 0.0;
  Pose X_WF_start = Pose::Identity(), X_WF_end = Pose::Identity();
  double lift_m = 0.0;                 ///< height of the bump above the straight line between the ends, at half time
  double clearance_m = 0.0;            ///< achieved: smallest height of the whole sole above the ground in mid swing
  std::vector<Vector3> detour_W = {};  ///< control points of the spline that replaces the bump [m]; may be empty
  double cruise = 0.0;                 ///< share of the swing time at constant speed along the straight line
};

/// Force of the ground on a foot, and its moment about the origin of the foothold's contact frame, in W.
struct ContactWrench {
  Vector3 force_W = Vector3::Zero();   ///< [N]
  Vector3 moment_W = Vector3::Zero();  ///< [N m] about the origin of the foot's contact frame at that time

  bool operator==(const ContactWrench&) const = default;
};

/// Uniform grid of whole-body states; row k is at start_s + k * step_s.
struct WholeBodyTrajectory {
  double start_s = 0.0, step_s = 0.0;
  std::vector<VectorX> q;                            ///< size 7 + n
  std::vector<VectorX> v;                            ///< size 6 + n
  std::vector<VectorX> a;                            ///< size 6 + n
  std::vector<VectorX> tau;                          ///< feed-forward torques of the independent joints, size n
  std::vector<std::vector<ContactWrench>> wrenches;  ///< by foot

  int size() const { return static_cast<int>(q.size()); }
  double end_s() const { return size() == 0 ? start_s : start_s + (size() - 1) * step_s; }
};

/// Origin of a plan: everything needed to make it again. Holds no path, host, date or duration.
struct Provenance {
  std::string program_version;
  std::string made_by;                                       ///< stage or importer that made the plan
  std::vector<std::pair<std::string, std::string>> options;  ///< every option that shapes the motion
  std::uint64_t seed = 0;

  bool operator==(const Provenance&) const = default;
};

/// A part of a motion: one gait, or standing still, with its command.
struct MotionPart {
  Gait gait;  ///< StandingGait for standing still
  WalkCommand command;
  PlanarPose goal;                    ///< commanded end of the base, in W
  double start_s = 0.0, end_s = 0.0;  ///< each part ends where the next one starts
};

/// A time at which a motion waits until the planned state is measured: the end of a phase.
struct PlanGate {
  double at_s = 0.0;
  std::string phase;            ///< phase that ends at this time, such as "lift front"
  double joints_within = 0.15;  ///< tolerance of each joint position [rad] or [m]
  FootSet contact = 0;          ///< feet that carry force
  double longest_s = 2.0;       ///< longest wait; after it the motion continues

  bool operator==(const PlanGate&) const = default;
};

/// A complete motion of a robot, with everything needed to execute and to check it.
struct MotionPlan {
  static constexpr int kSchema = 4;

  std::string robot;                 ///< name
  std::string robot_hash;            ///< RobotModel::hash
  std::string urdf_text, yaml_text;  ///< of the robot, so that the plan is self-contained
  std::vector<MeshHull> meshes;      ///< hulls of the robot's collision meshes (not in the texts)
  Provenance provenance;
  std::vector<MotionPart> parts;  ///< one or more, in order
  PlanarPose goal;                ///< goal of the last part
  Terrain terrain;
  ContactSchedule schedule;
  FootstepPlan footsteps;
  CentroidalTrajectory centroidal;
  std::vector<SwingTrajectory> swings;
  WholeBodyTrajectory whole_body;
  std::vector<PlanGate> gates;        ///< in order of time
  std::vector<std::string> warnings;  ///< limits that the plan knowingly exceeds
  std::vector<Adjustment> adjustments;

  double duration_s() const { return whole_body.end_s() - whole_body.start_s; }
};

/// The part at a time: at a boundary the later one, beyond the ends the first or last one; null without parts.
const MotionPart* PartAt(const std::vector<MotionPart>& parts, double time_s);

/// The names of the parts' gaits, such as "trot, stand, bound".
std::string GaitNames(const std::vector<MotionPart>& parts);

}  // namespace gaitwright
