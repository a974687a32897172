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
  std::optional<double> sole_give_m;  ///< in place of that of all feet
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
  std::optional<double> sole_give_m;  ///< what of a foot's shapes is that little over their lowest point is its sole
  int sole_give_line = 0;
};

/// Derives legs, feet, symmetry and a standing posture from the tree and its collision geometry; names are not used.
///
///   legs      chains whose end can come nearly as far down as the lowest of all (arms and heads cannot)
///   feet      under a leg of five or more joints the flat bottom of boxes, cylinders, meshes or corner spheres: a sole
///             (a line where no joint rolls it); else a sphere at the far end of the last body: it rolls; else the
///             farthest point
///   posture   each leg bends in its own upright plane (leg_plane.h). Without a sole: foot under its hip, 0.62 of the
///             straight length below it, or where its slides are half out; of a leg that sprawls, as far out of its
///             upright axis as below its hip. With a sole: 0.92, sole level. The knee bends to the side that its limits
///             allow more of. Other joints: nearest to zero. Then all feet move alike until the centre of mass stands
///             over their middle; on soles it may stay half the way from there to their edges.
/// @param given    overrides; if it names feet, only their links are feet.
/// @param standing given joint positions by coordinate; NaN for those to derive.
/// @return the number of legs. Failure kBadInput: `no_legs` when there are fewer than two, or none where feet
/// are named, `robot_feet` for named feet
/// that cannot be. @throws InvalidArgument with the line of an override that contradicts the robot.
Result<int> DeriveLegs(RobotModel& model, const LegChoices& given, const VectorX& standing);

/// Bodies at the ends of legs: leaves that can come down nearly as far as the lowest. Lowest first.
std::vector<int> EndBodies(const RobotModel& model);

}  // namespace gaitwright
