// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A part of the robot that is nearer to a solid of the ground than allowed.
struct GroundHit {
  const std::string* link = nullptr;
  int foot = -1;  ///< foot to which the shape belongs, or -1
  double distance_m = 0.0;
  int part = -1;  ///< index of the part, for ExitPlaneOf
  int body = -1;  ///< index of the body in the model
};

/// Direction of escape of a part near a solid: the solid is beyond the plane at p_W perpendicular to normal_W.
struct ExitPlane {
  Vector3 p_W = Vector3::Zero();        ///< nearest or deepest point of the part
  Vector3 normal_W = Vector3::UnitZ();  ///< direction in which the distance grows fastest
};

/// Smallest distance of a robot's parts to solids [m]; negative allows penetration.
struct GroundLimits {
  std::vector<double> foot_m;  ///< by foot
  double body_m = 0.0;         ///< for all other parts
};

/// Computes distances between a robot's shapes and all solids of a terrain along a motion. A spherical foot is its
/// sphere. Other shapes of a foot may protrude beyond the foot's own surface, as a sole's box may by rounding. This is
/// allowed. Intended for motions: a part is checked again only after it may have moved by its distance, so small
/// changes of the pose are cheap. The result does not depend on this. Conservative advancement: Mirtich,
/// Impulse-based Dynamic Simulation, 1996, section 2.3.
class GroundWatch {
 public:
  /// @throws InvalidArgument for an invalid terrain (SolidsOf).
  GroundWatch(const RobotModel& model, const Terrain& terrain);

  /// The parts nearer than their limits at the scratch's pose, in the order of the model's shapes. Needs
  /// ForwardKinematics.
  const std::vector<GroundHit>& Look(const DynamicsScratch& scratch, const GroundLimits& limits);

  /// For a hit of the last Look: direction in which the distance grows fastest, from differences over 2 mm.
  ExitPlane ExitPlaneOf(const GroundHit& hit) const;

  /// Smallest distance of a foot's parts to a solid, with the foot's frame F (sphere: its centre) at X_WF. The allowed
  /// protrusion beyond the foot's surface is added. At most within_m.
  NearestSolid NearestToFoot(int foot, const Pose& X_WF, double within_m) const;

  const ShapeScene& solids() const { return solids_; }
  int num_parts() const { return static_cast<int>(parts_.size()); }

  /// Distance of a point to all solids, at most 0.1 m; negative inside, by the depth.
  double PointDistance(const Vector3& p_W) const;

 private:
  struct Part {
    PreparedShape shape;
    int foot = -1;
    double reaches_m = 0.0;  // protrusion beyond its foot's surface
    Pose X_FS = Pose::Identity();
    Pose X_WS = Pose::Identity();  // pose of the last query, and the lower bound of the distance there
    double known_m = -1e300;
  };
  void AddFeet(const RobotModel& model);
  void AddShape(const RobotModel& model, const Shape& shape);

  ShapeScene solids_;
  double highest_m_;  // of all solids
  std::vector<Part> parts_;
  PreparedShape grain_;
  std::vector<GroundHit> hits_;
};

}  // namespace gaitwright
