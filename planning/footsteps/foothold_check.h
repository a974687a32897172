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

/// What ground a foot may be put on.
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

/// Why a foot cannot be put down.
enum class FootholdFault { kNone, kNoGround, kEdge, kSlope, kRough, kRiser, kObstacle };

/// The fault in words, such as "too near an edge".
std::string Describe(FootholdFault fault);

/// A foot put down on the ground.
struct PlacedFoot {
  int foot = 0;
  Pose X_WF = Pose::Identity();  ///< as of Foothold
  int surface = -1;              ///< number of the surface
  double risk = 0.0;             ///< 0 far from every edge on level ground, 1 at the limits
};

/// A foot put down, or why not.
struct Placing {
  FootholdFault fault = FootholdFault::kNoGround;
  PlacedFoot placed;

  bool ok() const { return fault == FootholdFault::kNone; }
};

/// Places feet on the ground and checks whether they can stand there.
///
///   point, sphere  on the highest ground; edges and risers keep away by the margin, and by a sphere's radius more;
///                  risers also by what it rolls towards them while it stands
///   sole, line     in the plane of a surface that nothing under the sole rises above; the part on the surface by the
///                  margin is `least_on` of it or more; on a height field in the plane in which it rests when
///                  loaded in its middle, touching with `least_on` of it or more and not rocking there; or across
///                  surfaces, as in the corner where a slope begins, with all corners on the ground and nothing between
///                  them above
/// Obstacles keep away by the margin, up to half a leg over the foothold. All distances are those in plan view, which
/// are never more than those on the slope. Ground that goes on beyond an edge at a slope below kGoesOn is no edge.
class FootholdChecker {
 public:
  /// tan of the slope at which ground is taken to go on rather than to end or rise.
  static constexpr double kGoesOn = 0.364;  // 20 degrees

  /// Model and ground must outlive it. @throws InvalidArgument for options out of range.
  FootholdChecker(const RobotModel& model, const GroundIndex& ground, const FootholdOptions& options);

  /// Whether there is ground on which the foot rocks in many places: soles on height fields.
  bool MayRock(int foot) const;

  /// Puts a foot's contact frame down at a place in plan view; yaw is that of its x axis.
  Placing Place(int foot, const PlanarPose& at) const;

  /// Places on each surface around, nearest to `at`, at which the foot is likely to stand: well inside and just inside
  /// of its edges, a sole also out over them as far as it may be, in its middle; and a sole just beside each of its
  /// edges. Turned like `at`, at most `radius_m` away. Appends.
  void Near(int foot, const PlanarPose& at, double radius_m, std::vector<PlanarPose>& places) const;

  /// Corners of a foot's outline in plan view, about its contact frame's origin, at a yaw: a sole, or the octagon
  /// around a sphere; a point for a point.
  Polygon OutlineAt(int foot, const PlanarPose& at) const;

  const GroundIndex& ground() const { return *ground_; }
  const FootholdOptions& options() const { return options_; }

 private:
  Placing PlacePoint(int foot, const PlanarPose& at) const;
  Placing PlaceSole(int foot, const PlanarPose& at) const;
  Placing PlaceOnPatch(int foot, const PlanarPose& at, int patch) const;
  /// Whether there is ground without steps all along a line in plan view, or around an outline.
  bool GoesOn(const Vector2& from_W, const Vector2& to_W) const;
  bool GoesOn(const Polygon& outline_W) const;
  Placing PlaceAcross(int foot, const PlanarPose& at) const;
  bool HoldsSteady(const Polygon& sole_F, const Pose& X_WF, const HeightField& field) const;
  Placing PlaceOnField(int foot, const PlanarPose& at, int surface) const;
  FootholdFault PointSurroundings(const Vector2& p_W, double clear_m, const GroundPoint& ground) const;
  double PointRisk(const Vector2& p_W, double clear_m, const GroundPoint& ground) const;
  /// Whether ground sticks out of a sole's plane under it or just beside it, or more than it may go on within the
  /// margin around it.
  bool AnythingAbove(const Polygon& outline_W, int patch, const Vector3& plane) const;
  bool SticksOut(const Polygon& outline_W, int patch, const Vector3& plane, double most_m) const;
  bool TooSteep(const Vector3& normal_W, double friction) const;
  bool HitsObstacle(int foot, const PlanarPose& at, double height_m) const;
  /// Least depths of a sole inside of edges, by their inward normals; for one outline.
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
