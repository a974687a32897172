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

/// The reason why a robot cannot stand at a pose.
struct Hindrance {
  std::string what;  ///< name of the obstacle or surface; empty for missing ground
  PlanarPose at;     ///< pose of the base
  std::string text;  ///< clause for messages, with the obstacle and the place
};

/// Checks whether a robot can be at planar poses of its base. Its space must be clear of obstacles and of ground that
/// is too high to step on. Each foot must find ground within its reach, with an acceptable slope, and within a step
/// height of the plane through all feet. With two feet or fewer that plane is level, as in FitBase.
///
/// Caches ground queries, so repeated queries are cheap; the result does not depend on this. The terrain must outlive
/// the object.
class PoseCheck {
 public:
  PoseCheck(const RobotModel& model, const Terrain& terrain, const BodySpaceOptions& options);
  PoseCheck(const PoseCheck&) = delete;
  PoseCheck& operator=(const PoseCheck&) = delete;

  /// Whether the robot can be at a pose.
  bool IsFree(const PlanarPose& at);

  /// Checks the straight path from a (known to be free) to b, including b. Samples are so dense that no point of the
  /// robot's space moves farther than its margin between two of them.
  bool IsFreeBetween(const PlanarPose& a, const PlanarPose& b);
  /// Whether a path along waypoints is free; the first one is known to be free.
  bool IsFreeAlong(const std::vector<PlanarPose>& path);

  /// Reason why a pose is not free; nothing if it is free.
  std::optional<Hindrance> ReasonRefused(const PlanarPose& at);

  const BodySpace& space() const { return space_; }
  long num_checks() const { return num_checks_; }

 private:
  /// Result of placing the feet at a pose.
  struct Footing {
    int lacking = -1;       ///< foot without ground, or -1
    int too_high = -1;      ///< foot whose ground is too high or too low, or -1
    bool tilted = false;    ///< true if the plane through the feet is too steep
    double height_m = 0.0;  ///< height of the plane at the base's origin
    Vector2 slope_G = Vector2::Zero();
    double rise_m = 0.0;  ///< rise of sloping ground within the legs' box, if the plane is level
    bool clear = false;   ///< true if the robot's space touches no obstacle
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
  ShapeScene scene_, obstacles_;  ///< solids without height fields; obstacles only
  std::vector<FieldRoom> fields_;
  std::vector<PreparedShape> boxes_;
  FootholdMap map_;
  std::vector<Vector2> offsets_;  ///< of footholds from standing places, sorted by distance, for a left foot
  MatrixX slope_of_heights_;      ///< least-squares fit over the standing places
  Vector2 middle_G_ = Vector2::Zero();
  std::vector<double> height_m_, nearest_m_;  ///< ground heights of footholds, by foot
  std::vector<Vector2> local_slope_;          ///< slopes of that ground, by foot
  Vector2 half_legs_ = Vector2::Zero();       ///< half the size of the legs' box in plan view
  double step_m_ = 0.0;
  long num_checks_ = 0;
};

}  // namespace gaitwright
