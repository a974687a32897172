// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/description/mjcf_geoms_internal.h"

namespace gaitwright {

/// A geometry of the URDF in a body's frame B, with the name and attributes of its element.
struct MjcfUrdfShape {
  std::string element;
  std::vector<std::pair<std::string, std::string>> attributes;
  Pose X_BS = Pose::Identity();
};

/// The geom as a shape of the URDF. Nothing, with a note, for a mesh without a file or with an unsupported format. An
/// ellipsoid becomes a capsule around it, or a box if it is too flat for a capsule.
std::optional<MjcfUrdfShape> ShapeOfMjcfGeom(MjcfContext& context, const MjcfGeom& geom, const MjcfMeshAssets& assets);

/// Numbers that read back exactly, with spaces between them.
std::string MjcfText(const Vector3& v);
std::string MjcfText(double value);

/// Roll, pitch and yaw of the URDF [rad]: R = Rz(yaw) Ry(pitch) Rx(roll).
Vector3 MjcfRollPitchYaw(const Matrix3& R);

}  // namespace gaitwright
