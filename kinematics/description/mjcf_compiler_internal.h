// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/description/mjcf_attributes_internal.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {

/// Source of the inertia of bodies.
enum class MjcfInertiaSource {
  kInertial,           ///< only <inertial>
  kInertialElseGeoms,  ///< <inertial>, or geoms for a body without it
  kGeoms,              ///< only geoms
};

/// The settings of <compiler>. If there are several <compiler>, the last one has priority.
struct MjcfCompiler {
  bool degrees = true;           ///< angles are in degrees; keyframes and actuators are always in radians
  std::string eulerseq = "xyz";  ///< axes of `euler`; small letters rotate with the frame, capital letters are fixed
  std::string meshdir;           ///< relative to the model's folder
  bool strippath = false;        ///< file names are used without their paths
  bool autolimits = true;        ///< a range is active without its flag
  MjcfInertiaSource inertia = MjcfInertiaSource::kInertialElseGeoms;
  double lowest_group = 0.0, highest_group = 5.0;  ///< groups of geoms that contribute to the inertia
  double boundmass = 0.0, boundinertia = 0.0;      ///< smallest mass and inertia of a body [kg, kg m^2]
  bool balanceinertia = false;  ///< principal moments that violate the triangle inequality become their mean
  double settotalmass = 0.0;    ///< all bodies are scaled to this total mass [kg]; 0: no scaling

  /// An angle of the model in radians.
  double Radians(double angle) const;
};

/// Throws a Failure for wrong values and for global coordinates.
MjcfCompiler ReadMjcfCompiler(const MjcfDocument& document);

/// The rotation of `quat`, `axisangle`, `euler`, `xyaxes` or `zaxis`, from the element's frame to the frame around it.
/// Throws a Failure for two orientations, and for axes that are zero or parallel.
Matrix3 MjcfRotation(const MjcfAttributes& attributes, const MjcfCompiler& compiler);

/// The pose of `pos` and MjcfRotation.
Pose MjcfPose(const MjcfAttributes& attributes, const MjcfCompiler& compiler);

/// The smallest rotation from z to a direction that is not zero; half a turn about x for -z.
Matrix3 MjcfRotationOfZ(const Vector3& direction);

}  // namespace gaitwright
