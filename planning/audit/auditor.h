// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/convex_hull.h"
#include "planning/audit/audit.h"
#include "planning/audit/findings.h"
#include "planning/audit/ground_watch.h"
#include "planning/audit/joint_watch.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/support_plane.h"

namespace gaitwright {

/// One audit of a plan. Each Check... function does one check, or several that use the same data.
class Auditor {
 public:
  Auditor(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options);
  /// Runs all checks at all samples.
  AuditReport Run();
  /// After Run.
  std::vector<BrokenTime> Broken() const { return findings_.Broken(); }

 private:
  void NamePlaces();
  void NoteUnknown(AuditReport& report) const;
  bool AllFinite() const;  // at the present sample
  bool Hanging(double time_s) const;
  bool InMiddle(int foot, double time_s, bool of_stance) const;
  bool SwingsThroughout(int foot, double time_s) const;
  bool Flies(double time_s) const;

  /// Surface under a foot at its present or last foothold, or the highest ground if the foothold names no surface.
  struct Footing {
    int foothold = -1;
    Vector3 normal_W = Vector3::UnitZ();
    double friction = 0.0;
  };
  void FindFooting(double time_s);  // sets footing_, X_WF_ and points_ at the scratch's pose
  Polygon SupportNow(int foot, double time_s) const;
  double PressureSlack(int foot, double normal_n, double time_s) const;
  bool HoldsSurface(int surface) const { return surface >= 0 && surface < plan_.terrain.num_surfaces(); }

  // Checks of one sample (audit_forces.cc, audit_flight.cc, audit_motion.cc)
  void CheckDynamics(double time_s);
  void CheckFlight(double time_s);
  void EndFlight();
  void NoteFlight(int place, double time_s, double share);
  void RemarkOnFlight(double lasted_s, double carried);
  double FlightMoment() const { return model_.weight_n() * model_.leg_length_m(); }
  void CheckContactForces(double time_s);
  void CheckZmp(double time_s);
  void CheckWrenchCone(double time_s);
  void CheckStanceFeet(double time_s);
  void CheckOnEdge(int foot, const Foothold& foothold, double time_s);
  void CheckFeetHeights(double time_s);
  double DepthLetPass(int foot, double time_s) const;
  void CheckHeight(const std::string& where, const Vector3& p_W, double limit, double time_s);
  void CheckBodies(double time_s);
  void CheckSolids(double time_s);
  void NearestOfAll(double time_s);
  void CheckReach(double time_s);
  // Checks of the whole plan (audit_columns.cc, audit_consistency.cc, audit_swings.cc)
  void CheckColumns();
  void CheckCentroidal();
  void CheckPendulum();
  void CheckSchedule();
  void CheckParts();
  void CheckStart();
  void CheckStartSpeeds();
  void CheckStartTilt(const Quaternion& R_WB);
  void CheckHanging(const MotionPart& part);
  void CheckStand(const MotionPart& part);
  void CheckCommand(const MotionPart& part, const PlanarPose& start);
  void CheckFootholds();
  void CheckFoothold(const Foothold& foothold, const ContactInterval& interval);
  void CheckHeelOff(const Foothold& foothold);
  bool RestsAcross(const Foothold& foothold) const;
  void CheckAcross(const Foothold& foothold);
  void CheckOnPatch(const Foothold& foothold, const TerrainPatch& patch);
  void CheckOnField(const Foothold& foothold);
  void CheckSwings();
  void CheckSwing(const SwingTrajectory& swing, const ContactInterval& gap);
  void CheckSwingPath(const SwingTrajectory& swing);
  void CheckSwingClearance(int foot, const Pose& X_WF, double time_s, double limit);

  /// Notes a violation of consistency unless `off` is at most `limit`.
  void Expect(const std::string& where, double time_s, double off, double limit, const char* unit) {
    findings_.Near(places_.columns, time_s, off / limit, 1.0, 1.0 - off / limit);
    if (!(off <= limit)) findings_.Note(Law::kConsistency, where, time_s, off, limit, unit);
  }
  /// Whether the needed force presses on the ground and on a plane strongly enough for a meaningful ZMP.
  bool PressesOn(const GroundPlane& plane) const;
  bool AllPressOn(const GroundPlane& plane) const;
  bool Slides(int dof) const { return model_.LeaderOf(dof).is_prismatic(); }
  const std::string& FootName(int foot) const { return model_.feet[static_cast<std::size_t>(foot)].name; }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const AuditOptions& options_;
  DynamicsScratch scratch_;
  CollisionChecker collision_;
  GroundWatch watch_;
  GroundLimits limits_to_ground_;
  std::vector<Polygon> support_F_;  // by foothold: the part of the sole on its surface
  WholeBodySample sample_;
  VectorX needed_;  // generalised forces of the motion
  FootSet stance_ = 0;
  bool forces_hold_ = false;      // the plan's contact forces give the needed wrench, inside their cones
  bool flies_ = false;            // no foot is in contact; see Flies
  bool between_stances_ = false;  // feet land or lift from the row before this time to the row after it, both included
  bool at_switch_ = false;        // a foot lands or lifts within one sample of this time
  GroundPlane plane_;             // through the points of the standing feet
  double com_height_m_ = 0.0;     // above plane_
  std::vector<Footing> footing_;  // by foot
  std::vector<Pose> X_WF_;        // by foot: contact frames
  ContactsByFoot points_;         // by foot: points at which it can push
  std::vector<Vector3> slip_W_;   // by foot: travel of the material contact point in this stance
  std::vector<int> foothold_;     // by foot: the present or last foothold
  int samples_;
  Findings findings_;
  std::vector<std::string> remarks_;
  JointWatch joints_;
  /// The present flight, with the centroidal momentum at its first and at its last sample.
  struct Flight {
    bool begun = false;
    double start_s = 0.0, last_s = 0.0;
    Vector6 first_W = Vector6::Zero(), last_W = Vector6::Zero();
    std::vector<std::pair<double, double>> samples = {};  // time, and the larger share of force and moment
  };
  Flight flight_;
  bool remarked_on_flight_ = false;
  /// Indices of places in findings_.
  struct Places {
    int columns, base_force, base_moment, fall, spin, zmp, reference, self, body;
    std::vector<int> residual;                             // by dof
    std::vector<int> reach, friction, press, swing, edge;  // by foot
  } places_;
  std::vector<double> efforts_;                          // by dof: limit, before derating
  std::vector<std::vector<ContactInterval>> intervals_;  // by foot: contact intervals
};

}  // namespace gaitwright
