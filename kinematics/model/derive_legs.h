// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// User's data of a foot that the URDF does not contain.
struct FootOverride {
  std::string link;
  std::optional<FootType> type;
  double radius_m = 0.0;
  std::vector<Vector2> sole_m;        ///< corners in the link's frame's xy plane, counter-clockwise
  std::optional<double> sole_give_m;  ///< replaces the value for all feet
  int line = 0;                       ///< line in the file
};

/// User's data of the leg that ends in a foot.
struct LegOverride {
  std::string foot;
  std::vector<std::string> joints;  ///< all of its moving joints, base first; empty if not given
  std::string knee;                 ///< joint; "" if not given
  double knee_sign = 0.0;           ///< 0 if not given
  int line = 0;
};

/// Two feet whose legs mirror each other.
struct MirrorPair {
  std::string first, second;
  int line = 0;
};

/// User's data of legs; all of it is optional.
struct LegChoices {
  std::vector<FootOverride> feet;
  std::vector<LegOverride> legs;
  std::optional<std::vector<MirrorPair>> mirror_pairs;  ///< all of them, if given
  std::optional<double> sole_give_m;  ///< height above a foot's lowest point up to which its shapes are its sole
  int sole_give_line = 0;
};

/// Derives legs, feet, symmetry and a standing posture from the tree and its collision geometry; names are not used.
///
///   legs      Chains whose ends reach nearly as low as the lowest one. Arms and heads do not.
///   feet      A leg of five or more joints has a sole: the flat bottom of boxes, cylinders, meshes or corner spheres.
///             It is a line if no joint rolls it. Otherwise the foot is a sphere at the far end of the last body, which
///             rolls. Otherwise it is the farthest point.
///   posture   Each leg bends in its own upright plane (leg_plane.h). A foot without a sole is below its hip at 0.62 of
///             the straight length, or where its prismatic joints are at half their stroke. The foot of a sprawling leg
///             is as far out from the leg's upright axis as it is below its hip. A foot with a sole is at 0.92 of the
///             straight length, and its sole is level. The knee bends to the side where its limits allow more. Other
///             joints are as near to zero as their limits allow. Finally all feet move by the same distance until the
///             centre of mass is above the middle of the feet. On soles, it may be up to halfway between the middle
///             and their edges.
/// @param given    overrides; if it names feet, only their links are feet.
/// @param standing given joint positions by coordinate; NaN for those to derive.
/// @return the number of legs. Failure kBadInput: `no_legs` for fewer than two legs (none if feet are named),
/// `robot_feet` for named feet that are not possible.
/// @throws InvalidArgument with the line of an override that contradicts the robot.
Result<int> DeriveLegs(RobotModel& model, const LegChoices& given, const VectorX& standing);

/// Bodies at the ends of legs, lowest first: leaves of the tree that reach nearly as low as the lowest one.
std::vector<int> EndBodies(const RobotModel& model);

}  // namespace gaitwright
