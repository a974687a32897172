// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/description/mjcf_attributes_internal.h"
#include "kinematics/description/mjcf_document_internal.h"

namespace gaitwright {

/// Where the inertia of bodies comes from.
enum class MjcfInertiaSource {
  kInertial,           ///< <inertial> alone
  kInertialElseGeoms,  ///< geoms where a body has no <inertial>
  kGeoms,              ///< geoms alone
};

/// What <compiler> says; several of them say it together, the last one first.
struct MjcfCompiler {
  bool degrees = true;           ///< unit of angles; keyframes and actuators are in radians all the same
  std::string eulerseq = "xyz";  ///< axes of `euler`; small letters turn with the frame, capital ones stand still
  std::string meshdir;           ///< relative to the model's folder
  bool strippath = false;        ///< paths in names of files are left out
  bool autolimits = true;        ///< a range alone limits
  MjcfInertiaSource inertia = MjcfInertiaSource::kInertialElseGeoms;
  double lowest_group = 0.0, highest_group = 5.0;  ///< groups of geoms that have a part in inertia
  double boundmass = 0.0, boundinertia = 0.0;      ///< least that a body has [kg, kg m^2]
  bool balanceinertia = false;  ///< principal moments that break the triangle inequality become their mean
  double settotalmass = 0.0;    ///< [kg] that all bodies together are scaled to; 0: they are not

  /// An angle of the model in radians.
  double Radians(double angle) const;
};

/// Throws a Failure on values that are wrong and on global coordinates.
MjcfCompiler ReadMjcfCompiler(const MjcfDocument& document);

/// The rotation of `quat`, `axisangle`, `euler`, `xyaxes` or `zaxis`: from the element's frame into that around it.
/// Throws a Failure on two of them, and on axes that are zero or parallel.
Matrix3 MjcfRotation(const MjcfAttributes& attributes, const MjcfCompiler& compiler);

/// `pos` and that rotation.
Pose MjcfPose(const MjcfAttributes& attributes, const MjcfCompiler& compiler);

/// The smallest rotation that turns z into a direction, which is not zero; half a turn about x for -z.
Matrix3 MjcfRotationOfZ(const Vector3& direction);

}  // namespace gaitwright
