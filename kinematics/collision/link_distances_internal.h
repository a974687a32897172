// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/collision/convex_distance_internal.h"
#include "kinematics/collision/shape_scene.h"
#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Two links whose shapes are near each other, or a link and a solid.
struct NearPair {
  int pair = 0;  ///< index, from 0 to LinkDistances::num_pairs()
  double distance_m = 0.0;
};

/// Signed distances of the pairs of shapes that CollisionChecker checks, and of all shapes that belong to no foot to
/// fixed solids, with gradients. Negative distances are depths of overlaps.
class LinkDistances {
 public:
  /// The model must outlive this.
  explicit LinkDistances(const RobotModel& model, FixedSolids solids = {});

  int num_pairs() const { return static_cast<int>(pairs_.size()); }
  /// The links or solids of a pair, such as "'left_hand' and 'left_hip'".
  std::string NameOf(int pair) const;
  /// Distance of two links in the standing posture [m], positive; for a link and a solid, that of
  /// the link to the ground.
  double standing_m(int pair) const { return pairs_[Of(pair)].standing_m; }

  /// Distance of a pair at the scratch's pose. Needs ForwardKinematics, and so do the functions below.
  ConvexDistance At(int pair, const DynamicsScratch& scratch) const;

  /// Number of points that PointsAt gives: several for a link and a solid, because a flat link can touch it in several.
  int num_points(int pair) const { return IsSolid(pairs_[Of(pair)].b) ? kPointsOfSolids : 1; }
  /// The pair's distance at its points, the nearest first. Where a link faces a plane side of a solid, the others are
  /// those of its corners that are nearest to this side, apart from each other; else they are all the first.
  void PointsAt(int pair, const DynamicsScratch& scratch, std::vector<ConvexDistance>& points) const;

  /// Adds a multiple of the derivative of a pair's distance along the directions of v:
  ///   n . (J_B - J_A),   J of the witness points.
  /// For two links the columns of the base are zero, since the distance does not depend on the place of the robot.
  /// @param gradient  size nv.
  void AddGradient(int pair, const ConvexDistance& at, const DynamicsScratch& scratch, double multiple,
                   Eigen::Ref<VectorX> gradient) const;

  /// Pairs that are nearer than `within_m`, in order of their index. For motions: a pair is examined again only when
  /// its shapes may have moved far enough, so that small changes of the pose are cheap; the result does not depend on
  /// this.
  const std::vector<NearPair>& Near(const DynamicsScratch& scratch, double within_m);

 private:
  static constexpr int kPointsOfSolids = 4;
  struct Part {
    double radius = 0.0;           // about the shape's origin
    Pose X_BS = Pose::Identity();  // in the robot's base
    double path_m = 0.0;           // bound on the path length of any of its points since the start
  };
  struct Pair {
    int a = 0, b = 0;  // robot's shapes, then solids, then half spaces
    double standing_m = 0.0;
    double free_m;  // sum of the two paths up to which the distance is surely positive; less the depth of an overlap
  };
  static std::size_t Of(int i) { return static_cast<std::size_t>(i); }
  int num_shapes() const { return static_cast<int>(model_.collision_shapes.size()); }
  bool IsSolid(int i) const { return i >= num_shapes(); }
  const HalfSpace* HalfSpaceOf(int i) const;
  const Shape& ShapeOf(int i) const;
  const std::string& NameOfPart(int i) const;
  Pose PoseOf(int i, const DynamicsScratch& scratch) const;
  void AddSolidPairs(const DynamicsScratch& standing);
  std::optional<HalfSpace> SideFacing(int solid, const ConvexDistance& nearest) const;
  void Move(const DynamicsScratch& scratch);
  void AddPointGradient(int body, const Vector3& p_WQ, const Vector3& along_W, const DynamicsScratch& scratch,
                        Eigen::Ref<VectorX> gradient) const;

  const RobotModel& model_;
  FixedSolids solids_;
  std::vector<Part> parts_;  // by shape of the robot, then of the solids
  std::vector<Pair> pairs_;
  std::vector<NearPair> near_;
};

}  // namespace gaitwright
