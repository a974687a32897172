// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/convex_distance_internal.h"
#include "workflows/repair/part_feet_internal.h"

namespace gaitwright {
namespace {

constexpr int kSweeps = 40;
constexpr double kLittle = 1e-5;  // [m] that may be lacking
constexpr double kBeside = 0.3;   // of a unit normal: least horizontal part with which feet part along it

std::size_t At(int i) { return static_cast<std::size_t>(i); }

/// Shapes of a foot in its contact frame.
std::vector<Shape> ShapesOf(const RobotModel& model, const Foot& foot) {
  std::vector<Shape> shapes;
  if (foot.radius > 0.0) {
    Shape ball;
    ball.type = ShapeType::kSphere;
    ball.size.x() = foot.radius;
    ball.X_BS.translation().z() = foot.radius;
    return {ball};
  }
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body != foot.body) continue;
    shapes.push_back(shape);
    shapes.back().X_BS = foot.X_BF.inverse() * shape.X_BS;
  }
  return shapes;
}

/// The smallest distance of two feet on their places.
ConvexDistance DistanceOfFeet(const std::vector<Shape>& a, const Pose& X_WA, const std::vector<Shape>& b,
                              const Pose& X_WB) {
  ConvexDistance nearest;
  nearest.distance_m = INFINITY;
  for (const Shape& of_a : a) {
    for (const Shape& of_b : b) {
      const ConvexDistance at = DistanceOf(of_a, X_WA * of_a.X_BS, of_b, X_WB * of_b.X_BS);
      if (at.distance_m < nearest.distance_m) nearest = at;
    }
  }
  return nearest;
}

class FeetParter {
 public:
  FeetParter(const RobotModel& model, const Terrain& terrain, double least_m,
             std::vector<std::vector<PinnedPlace>>& stances)
      : terrain_(terrain), least_m_(least_m), stances_(stances) {
    const CollisionChecker checker(model);
    for (const Foot& foot : model.feet) shapes_.push_back(ShapesOf(model, foot));
    for (int f = 0; f < static_cast<int>(stances.size()); ++f) {
      for (int g = f + 1; g < static_cast<int>(stances.size()); ++g) {
        const int a = model.feet[At(f)].body, b = model.feet[At(g)].body;
        const bool checked = std::ranges::any_of(checker.pairs(), [&](const std::pair<int, int>& pair) {
          const int of_a = model.collision_shapes[At(pair.first)].body,
                    of_b = model.collision_shapes[At(pair.second)].body;
          return (of_a == a && of_b == b) || (of_a == b && of_b == a);
        });
        if (checked) feet_.emplace_back(f, g);
      }
    }
  }

  void Run() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool moved = false;
      for (const auto& [f, g] : feet_) moved = PartStances(f, g) || moved;
      if (!moved) return;
    }
  }

 private:
  bool PartStances(int f, int g) {
    bool moved = false;
    for (PinnedPlace& a : stances_[At(f)]) {
      for (PinnedPlace& b : stances_[At(g)]) {
        if (a.rows.first <= b.rows.last && b.rows.first <= a.rows.last) moved = Part(f, a, g, b) || moved;
      }
    }
    return moved;
  }

  bool Part(int f, PinnedPlace& a, int g, PinnedPlace& b) {
    const ConvexDistance at = DistanceOfFeet(shapes_[At(f)], a.X_WF, shapes_[At(g)], b.X_WF);
    const double lacking = least_m_ - at.distance_m;
    if (!(lacking > kLittle)) return false;
    Vector2 along = at.n_W.head<2>();
    double gained = along.norm();  // of the distance by a unit of shift
    if (gained < kBeside) {
      along = (b.X_WF.translation() - a.X_WF.translation()).head<2>();
      if (along.norm() < kLittle) along = -a.X_WF.linear().col(1).head<2>();
      gained = 1.0;
    }
    const Vector2 shift = 0.5 * lacking / gained * along.normalized();
    const bool a_moved = Move(a, -shift), b_moved = Move(b, shift);
    return a_moved || b_moved;
  }

  /// @return false where there is no ground.
  bool Move(PinnedPlace& place, const Vector2& shift) const {
    const Vector2 from = place.X_WF.translation().head<2>();
    const GroundPoint before = GroundAt(terrain_, from), after = GroundAt(terrain_, from + shift);
    if (before.patch < 0 || after.patch < 0) return false;
    place.X_WF.translation().head<2>() += shift;
    place.X_WF.translation().z() += after.height_m - before.height_m;
    place.parted_m += shift.norm();
    return true;
  }

  const Terrain& terrain_;
  const double least_m_;
  std::vector<std::vector<PinnedPlace>>& stances_;
  std::vector<std::vector<Shape>> shapes_;  // by foot
  std::vector<std::pair<int, int>> feet_;   // that are checked against each other
};

}  // namespace

void PartFeet(const RobotModel& model, const Terrain& terrain, double least_m,
              std::vector<std::vector<PinnedPlace>>& stances) {
  FeetParter(model, terrain, least_m, stances).Run();
}

}  // namespace gaitwright
