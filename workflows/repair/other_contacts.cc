// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"
#include "workflows/repair/other_contacts_internal.h"

namespace gaitwright {
namespace {

/// Height of the lowest point of a shape over the ground below it; infinite without ground. Needs ForwardKinematics.
double HeightOver(const Terrain& terrain, const DynamicsScratch& scratch, const Shape& shape) {
  const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
  const Vector3 down_S = -X_WS.linear().row(2).transpose();
  const Vector3 lowest_W = X_WS * SupportPoint(shape, down_S);
  const GroundPoint ground = GroundAt(terrain, lowest_W.head<2>());
  return ground.patch < 0 ? INFINITY : lowest_W.z() - ground.height_m;
}

/// Shapes of links that are far from the ground in the standing posture.
std::vector<const Shape*> ShapesOffTheGround(const RobotModel& model, double least_m) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Terrain flat = FlatTerrain();
  std::vector<const Shape*> shapes;
  for (const Shape& shape : model.collision_shapes) {
    const bool of_foot = std::ranges::any_of(model.feet, [&](const Foot& foot) { return foot.body == shape.body; });
    if (!of_foot && HeightOver(flat, scratch, shape) > least_m) shapes.push_back(&shape);
  }
  return shapes;
}

}  // namespace

std::vector<OtherContact> FindOtherContacts(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion,
                                            double height_m, const RepairOptions& options) {
  constexpr double kEvery = 0.05;   // [s]
  constexpr double kFarther = 4.0;  // times the height that counts, in the standing posture
  const double low_m = options.stand_height * model.leg_length_m();
  const std::vector<const Shape*> shapes = ShapesOffTheGround(model, kFarther * low_m);
  const int every = std::max(1, static_cast<int>(std::lround(kEvery / motion.step_s)));
  DynamicsScratch scratch(model);
  std::vector<OtherContact> contacts, open;
  for (int row = 0; row < motion.size(); row += every) {
    const double at_s = motion.TimeOf(row);
    ForwardKinematics(model, motion.q[static_cast<std::size_t>(row)], scratch);
    for (const Shape* shape : shapes) {
      if (HeightOver(terrain, scratch, *shape) - height_m > low_m) continue;
      const auto known = std::ranges::find(open, shape->link, &OtherContact::link);
      if (known == open.end())
        open.push_back({shape->link, at_s, at_s});
      else
        known->end_s = at_s;
    }
    const bool ends = row + every >= motion.size();
    for (std::size_t i = 0; i < open.size();) {
      if (!ends && open[i].end_s == at_s) {
        ++i;
        continue;
      }
      if (open[i].end_s - open[i].start_s >= options.least_stance_s) contacts.push_back(open[i]);
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  std::ranges::stable_sort(contacts, {}, &OtherContact::start_s);
  return contacts;
}

}  // namespace gaitwright
