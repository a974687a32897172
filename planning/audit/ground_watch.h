// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A part of the robot that is nearer to a solid of the ground than it may be.
struct GroundHit {
  const std::string* link = nullptr;
  int foot = -1;  ///< the foot that it is a shape of, or -1
  double distance_m = 0.0;
  int part = -1;  ///< for WayOutOf
  int body = -1;  ///< of the model
};

/// How a part comes near to a solid: the plane at right angles to the way out that touches it has the solid beyond.
struct WayOut {
  Vector3 p_W = Vector3::Zero();        ///< the part's point that is nearest, or deepest
  Vector3 normal_W = Vector3::UnitZ();  ///< along which it comes away fastest
};

/// Smallest distance of a robot's parts to solids [m]; negative allows penetration.
struct GroundLimits {
  std::vector<double> foot_m;  ///< by foot
  double body_m = 0.0;         ///< of all other parts
};

/// Computes distances between a robot's shapes and all solids of a terrain along a motion. A sphere foot is its ball;
/// other shapes of a foot that reach beyond the foot's own surface, as a sole's box may by its roundings, are given
/// what they reach. Meant for motions: a part is checked again only when it may have moved by its distance, so small
/// changes of the pose are cheap; the result does not depend on this. Conservative advancement: Mirtich, Impulse-based
/// Dynamic Simulation, 1996, section 2.3.
class GroundWatch {
 public:
  /// @throws InvalidArgument for an invalid terrain (SolidsOf).
  GroundWatch(const RobotModel& model, const Terrain& terrain);

  /// The parts nearer than their limits at the scratch's pose, in the order of the model's shapes. Needs
  /// ForwardKinematics.
  const std::vector<GroundHit>& Look(const DynamicsScratch& scratch, const GroundLimits& limits);

  /// For a hit of the last Look: the slope of its distance by where the part is, by differences over two millimetres.
  WayOut WayOutOf(const GroundHit& hit) const;

  /// How near one foot's parts come to a solid with its frame F (of a sphere: its centre) at X_WF, what they may reach
  /// beyond the foot's surface added; at most within_m.
  NearestSolid NearestToFoot(int foot, const Pose& X_WF, double within_m) const;

  const ShapeScene& solids() const { return solids_; }
  int num_parts() const { return static_cast<int>(parts_.size()); }

  /// How far a point is outside of all solids, negative by its depth inside; at most a tenth of a metre.
  double PointDistance(const Vector3& p_W) const;

 private:
  struct Part {
    PreparedShape shape;
    int foot = -1;
    double reaches_m = 0.0;  // beyond its foot's surface
    Pose X_FS = Pose::Identity();
    Pose X_WS = Pose::Identity();  // where it was looked at last, and how far it was away at least
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
