// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "planning/paths/body_space.h"
#include "planning/paths/field_room.h"
#include "planning/paths/foothold_map.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// What keeps a robot from standing somewhere.
struct Hindrance {
  std::string what;  ///< name of the obstacle or surface; empty for missing ground
  PlanarPose at;     ///< of the base
  std::string text;  ///< for people: a clause that names it and the place
};

/// Whether a robot can be at planar poses of its base: its room is clear of obstacles and of ground too high to step
/// on, and each foot finds ground within its reach, of tolerable slope and within a step's height of the plane through
/// all of them. With two feet or fewer that plane is level, as for FitBase.
///
/// Caches ground queries, so repeated queries are cheap; the result does not depend on this. The terrain must outlive
/// it.
class PoseCheck {
 public:
  PoseCheck(const RobotModel& model, const Terrain& terrain, const BodySpaceOptions& options);
  PoseCheck(const PoseCheck&) = delete;
  PoseCheck& operator=(const PoseCheck&) = delete;

  /// Whether the robot can be at a pose.
  bool IsFree(const PlanarPose& at);

  /// Every pose on the straight way from a, which is known to be free, to b included; so densely that no point of the
  /// room moves farther than its margin between two.
  bool IsFreeBetween(const PlanarPose& a, const PlanarPose& b);
  /// Whether a path along waypoints is free; the first one is known to be free.
  bool IsFreeAlong(const std::vector<PlanarPose>& way);

  /// Why a pose is not free; nothing when it is.
  std::optional<Hindrance> WhyNot(const PlanarPose& at);

  const BodySpace& space() const { return space_; }
  long num_checks() const { return num_checks_; }

 private:
  /// Where the robot stands at a pose.
  struct Footing {
    int lacking = -1;       ///< foot that finds no ground, or
    int too_high = -1;      ///< that finds it too high or low, or
    bool tilted = false;    ///< all of which are on too steep a plane
    double height_m = 0.0;  ///< of the plane at the base's origin
    Vector2 slope_G = Vector2::Zero();
    double rise_m = 0.0;  ///< of sloping ground within the legs' box, where the plane is level
    bool clear = false;   ///< the room touches nothing there
    bool stands() const { return lacking < 0 && too_high < 0 && !tilted; }
  };

  Footing FootingAt(const PlanarPose& at);
  bool NearestFootholds(const PlanarPose& at, Footing& footing);
  bool FootholdsNear(const PlanarPose& at, double height_m);
  void FitPlane(const PlanarPose& at, Footing& footing) const;
  Pose PlaneAt(const PlanarPose& at, const Footing& footing) const;
  bool IsClear(const PlanarPose& at, const Footing& footing) const;
  Pose PoseOfBox(std::size_t box, const Pose& X_WG, double rise_m) const;
  Hindrance NoFoothold(const PlanarPose& at, const Footing& footing);

  const RobotModel& model_;
  const Terrain& terrain_;
  BodySpace space_;
  ShapeScene scene_, obstacles_;  ///< all but the height fields; the obstacles alone
  std::vector<FieldRoom> fields_;
  std::vector<PreparedShape> boxes_;
  FootholdMap map_;
  std::vector<Vector2> offsets_;  ///< of footholds from standing places, the nearest first, for a foot on the left
  MatrixX slope_of_heights_;      ///< least squares over the standing places
  Vector2 middle_G_ = Vector2::Zero();
  std::vector<double> height_m_, nearest_m_;  ///< of footholds, by foot
  std::vector<Vector2> local_slope_;          ///< of their ground, by foot
  Vector2 half_legs_ = Vector2::Zero();       ///< half the size of the legs' box in plan view
  double step_m_ = 0.0;
  long num_checks_ = 0;
};

}  // namespace gaitwright
