// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Space that a walking robot needs, and ground that it may use; lengths in leg lengths, for robots of any size.
///
/// Tuning
///   no route through a wide enough doorway       less margin, less step_forward and step_lateral
///   swings or arms graze walls along the route   more margin
///   the route is too steep for the footsteps     less step_height
struct BodySpaceOptions {
  double step_forward = 0.2;
  double step_lateral = 0.06;
  double foothold_forward = 0.35;
  double foothold_lateral = 0.2;
  double step_height = 0.3;
  double margin = 0.06;
  double sway = 0.8;
  double max_slope_deg = 30.0;
  double max_tilt_deg = 35.0;

  OptionFields Fields() {
    return WithBasics(
        {"margin"},
        {{"step_forward", &step_forward, "leg lengths", 0.0, 1.0,
          "Room that the legs need in front and behind: half of a usual step."},
         {"step_lateral", &step_lateral, "leg lengths", 0.0, 1.0, "Room that the legs need on each side."},
         {"foothold_forward", &foothold_forward, "leg lengths", 0.0, 1.0,
          "Largest forward or backward distance of a foothold from the foot's standing position."},
         {"foothold_lateral", &foothold_lateral, "leg lengths", 0.0, 1.0,
          "Largest lateral distance of a foothold from the foot's standing position."},
         {"step_height", &step_height, "leg lengths", 0.0, 1.0,
          "Highest step that the route may climb; it goes around anything higher."},
         {"margin", &margin, "leg lengths", 0.0, 1.0, "Clearance between the robot and all obstacles."},
         {"sway", &sway, "1", 0.0, 2.0,
          "Lateral sway of a biped's body, as a share of half the distance between its feet."},
         {"max_slope_deg", &max_slope_deg, "deg", 0.0, 60.0,
          "Largest slope of the ground under the feet; low friction may lower it."},
         {"max_tilt_deg", &max_tilt_deg, "deg", 0.0, 60.0, "Largest slope of the plane through the feet."}});
  }
};

/// The space that a robot needs to walk.
///
/// = Notation =
///   G  the base's frame moved down to the plane through the feet: x forward, z along the plane's normal
struct BodySpace {
  std::vector<Shape> boxes;      ///< X_BS is X_GS: one around the legs and their steps, one around the rest
  std::vector<Vector2> feet_G;   ///< contact points of the standing posture
  double foot_radius_m = 0.0;    ///< radius of the ground that a foot needs
  double reach_forward_m = 0.0;  ///< largest forward or backward distance of a foothold from the foot's standing place
  double reach_lateral_m = 0.0;  ///< largest lateral distance
  double step_height_m = 0.0;
  double margin_m = 0.0;
  double max_slope_rad = 0.0, max_tilt_rad = 0.0;
  double radius_m = 0.0;  ///< radius about the base that contains all boxes in plan view
  double leg_length_m = 0.0;
};

/// Computed from the robot's shapes and feet in the standing posture, half a step of its feet, the sway of a biped's
/// body, and a margin. The boxes begin at the height of a step, because the robot steps over or onto lower obstacles.
/// @throws InvalidArgument for an option out of range.
BodySpace BodySpaceOf(const RobotModel& model, const BodySpaceOptions& options);

}  // namespace gaitwright
