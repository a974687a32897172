// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/ground_index.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Requirements on the ground under a foot.
struct FootholdOptions {
  double margin_m = 0.005;
  double least_on = 0.6;
  double slope_deg = 30.0;
  double roughness = 0.05;

  OptionFields Fields() {
    return WithBasics(
        {"margin_m", "slope_deg"},
        {{"margin_m", &margin_m, "m", 0.0, 0.2, "Smallest distance of a foothold from edges, risers and obstacles."},
         {"least_on", &least_on, "1", 0.1, 1.0,
          "Smallest share of the sole's area that lies on its surface, inside the margin."},
         {"slope_deg", &slope_deg, "deg", 0.0, 60.0, "Largest slope of the ground under a foot."},
         {"roughness", &roughness, "1", 0.0, 0.5,
          "Largest deviation of a height field from the plane of a sole, as a share of the leg length."}});
  }
};

/// Reason why a foot cannot be put down.
enum class FootholdFault { kNone, kNoGround, kEdge, kSlope, kRough, kRiser, kObstacle };

/// Text of the fault, such as "too near an edge".
std::string Describe(FootholdFault fault);

/// A foot put down on the ground.
struct PlacedFoot {
  int foot = 0;
  Pose X_WF = Pose::Identity();  ///< as in Foothold
  int surface = -1;              ///< number of the surface
  double risk = 0.0;             ///< 0 on level ground far from edges, 1 at the limits
};

/// A foot put down, or the reason why it cannot be.
struct Placing {
  FootholdFault fault = FootholdFault::kNoGround;
  PlacedFoot placed;

  bool ok() const { return fault == FootholdFault::kNone; }
};

/// Places feet on the ground and checks whether they can stand there.
///
///   point, sphere  on the highest ground. The distance from edges and risers is at least the margin; for a sphere it
///                  also includes the radius and, to risers, the distance that it rolls during the stance
///   sole, line     in the plane of a surface, with no ground above it under the sole; at least `least_on` of the sole
///                  is on the surface, inside the margin. On a height field: in the plane in which the sole rests when
///                  loaded at its middle; at least `least_on` of it touches, and it does not rock. Across surfaces, for
///                  example where a slope begins: all corners are on the ground, and no ground between them is above
///                  the sole
///
/// The distance from obstacles is at least the margin, up to half a leg length above the foothold. All distances are
/// measured in plan view; they are never longer than those on the slope. An edge beyond which the ground continues with
/// a slope below kGoesOn is ignored.
class FootholdChecker {
 public:
  /// tan of the largest slope at which ground is treated as continuous, without an edge or riser.
  static constexpr double kGoesOn = 0.364;  // 20 degrees

  /// Model and ground must outlive the checker. @throws InvalidArgument for options out of range.
  FootholdChecker(const RobotModel& model, const GroundIndex& ground, const FootholdOptions& options);

  /// Whether the ground makes a foot rock at many places: true for soles on height fields.
  bool MayRock(int foot) const;

  /// Puts a foot's contact frame down at a place in plan view; yaw is the heading of its x axis.
  Placing Place(int foot, const PlanarPose& at) const;

  /// Appends places on each surface around `at` where the foot is likely to stand: the nearest place well inside the
  /// edges and just inside each of them; for a sole also the largest allowed overhang, and places just beside each
  /// edge. They have the yaw of `at` and are at most `radius_m` away.
  void Near(int foot, const PlanarPose& at, double radius_m, std::vector<PlanarPose>& places) const;

  /// Corners of a foot's outline in plan view at a yaw, relative to the origin of its contact frame: a sole, the
  /// octagon around a sphere, or a single point.
  Polygon OutlineAt(int foot, const PlanarPose& at) const;

  const GroundIndex& ground() const { return *ground_; }
  const FootholdOptions& options() const { return options_; }

 private:
  Placing PlacePoint(int foot, const PlanarPose& at) const;
  Placing PlaceSole(int foot, const PlanarPose& at) const;
  Placing PlaceOnPatch(int foot, const PlanarPose& at, int patch) const;
  /// Whether the ground is continuous (without steps) along a line in plan view, or around an outline.
  bool GoesOn(const Vector2& from_W, const Vector2& to_W) const;
  bool GoesOn(const Polygon& outline_W) const;
  Placing PlaceAcross(int foot, const PlanarPose& at) const;
  bool HoldsSteady(const Polygon& sole_F, const Pose& X_WF, const HeightField& field) const;
  Placing PlaceOnField(int foot, const PlanarPose& at, int surface) const;
  FootholdFault PointSurroundings(const Vector2& p_W, double clear_m, const GroundPoint& ground) const;
  double PointRisk(const Vector2& p_W, double clear_m, const GroundPoint& ground) const;
  /// Whether ground is above a sole's plane under it or just beside it, or rises too steeply within the margin around
  /// it.
  bool AnythingAbove(const Polygon& outline_W, int patch, const Vector3& plane) const;
  bool SticksOut(const Polygon& outline_W, int patch, const Vector3& plane, double most_m) const;
  bool TooSteep(const Vector3& normal_W, double friction) const;
  bool HitsObstacle(int foot, const PlanarPose& at, double height_m) const;
  /// Smallest depths of a sole inside of edges, by the inward normals of the edges; for one outline.
  using Depths = std::vector<std::pair<Vector2, double>>;
  double LeastInside(const Polygon& outline_F, const Vector2& inward, Depths& known) const;
  Polygon Eroded(const GroundSurface& surface, const Polygon& outline_F, double inside, Depths& known) const;
  double SlopeRisk(const Vector3& normal_W) const;

  const RobotModel* model_;
  const GroundIndex* ground_;
  FootholdOptions options_;
  double leg_m_;
  double tan_slope_;
};

}  // namespace gaitwright
