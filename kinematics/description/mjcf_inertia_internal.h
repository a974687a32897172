// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/description/mjcf_geoms_internal.h"

namespace gaitwright {

/// Mass, centre and inertia of a body, in the axes of its frame B.
struct MjcfInertia {
  double mass = 0.0;               ///< [kg]
  Vector3 p_BC = Vector3::Zero();  ///< [m]
  Matrix3 I_C = Matrix3::Zero();   ///< about the centre [kg m^2]
};

/// Volume, centre and second moment of a solid of density 1.
struct MjcfVolume {
  double volume = 0.0;               ///< [m^3]
  Vector3 centre = Vector3::Zero();  ///< [m]
  Matrix3 second = Matrix3::Zero();  ///< integral of r r^T about the centre [m^5]
};

/// The solid enclosed by the triangles of a closed mesh. Nothing if the mesh is not closed or encloses no volume.
///   Each triangle (a, b, c) adds the tetrahedron (0, a, b, c): volume det(a b c) / 6, first moment volume (a + b + c)
///   / 4, second moment volume ((a + b + c)(a + b + c)^T + a a^T + b b^T + c c^T) / 20.
std::optional<MjcfVolume> VolumeOfMjcfMesh(const MjcfMesh& mesh);

/// Inertia of a solid with a given mass about its centre: mass / volume (trace(S) 1 - S).
Matrix3 InertiaOfMjcfVolume(const MjcfVolume& volume, double mass);

/// Finds the inertia of bodies as required by <compiler>: from <inertial> or from geoms, with the bounds of <compiler>.
class MjcfInertias {
 public:
  MjcfInertias(MjcfContext& context, const MjcfMeshAssets& assets) : context_(context), assets_(assets) {}

  /// Throws a Failure for wrong values, and for a mesh that is needed for the inertia but cannot be read.
  MjcfInertia Of(const MjcfBody& body, const std::vector<MjcfGeom>& geoms);

 private:
  MjcfInertia FromElement(const MjcfPart& part) const;
  MjcfInertia FromGeoms(const std::vector<MjcfGeom>& geoms);
  MjcfVolume VolumeOf(const MjcfGeom& geom);
  MjcfVolume VolumeOfMesh(const MjcfGeom& geom);
  void Bound(MjcfInertia& inertia) const;

  MjcfContext& context_;
  const MjcfMeshAssets& assets_;
  std::map<std::string, MjcfVolume> of_file_;
};

}  // namespace gaitwright
