// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {

enum class MjcfGeomType { kSphere, kCapsule, kCylinder, kEllipsoid, kBox, kMesh };

/// A geom in its body's frame. `size` is as in MuJoCo: radius, half of the length, half of the edges.
struct MjcfGeom {
  std::string owner, name;
  MjcfGeomType type = MjcfGeomType::kSphere;
  Pose X_BG = Pose::Identity();
  Vector3 size = Vector3::Zero();
  std::string mesh;       ///< name of the asset
  bool collides = true;   ///< it may touch others: `contype` or `conaffinity` is not zero, or a <pair> names it
  bool is_shown = true;   ///< in a group that MuJoCo draws by default
  bool is_shell = false;  ///< its mass is on its surface
  double group = 0.0;
  std::optional<double> mass;  ///< [kg]
  double density = 1000.0;     ///< [kg/m^3], used if there is no mass
};

/// A mesh asset: a point p of the file is the point A p + b of the geom.
struct MjcfMeshAsset {
  std::string owner, file;  ///< file as the URDF has it, "inline:NAME" for vertices in the model; "" for neither
  MjcfMesh inner;           ///< with "inline:NAME": the mesh; its convex hull where the model gives no triangles
  Vector3 scale = Vector3::Ones(), p_ref = Vector3::Zero();
  Matrix3 R_ref = Matrix3::Identity();
  bool is_shell = false;  ///< mass is on the surface

  Matrix3 A() const { return scale.asDiagonal() * R_ref.transpose(); }
  Vector3 b() const { return -A() * p_ref; }
};

using MjcfMeshAssets = std::map<std::string, MjcfMeshAsset>;

/// The <mesh> elements of all <asset>. Throws a Failure if two have the same name.
MjcfMeshAssets ReadMjcfMeshes(MjcfContext& context);

/// The asset that a geom names. Throws a Failure if it does not exist.
const MjcfMeshAsset& MjcfMeshOf(const MjcfGeom& geom, const MjcfMeshAssets& assets);

/// Names of the geoms in a <pair> of <contact>.
std::set<std::string> MjcfPairedGeoms(const MjcfContext& context);

/// The geoms of a body. Types such as planes and height fields are left out with a note.
std::vector<MjcfGeom> ReadMjcfGeoms(MjcfContext& context, const MjcfBody& body, const std::set<std::string>& paired);

/// If no geom of the robot collides, enables the geoms that are not shown, which are usually the collision geometry. An
/// example is a model whose contacts are pairs in another file. @param geoms  by body.
void LetHiddenMjcfGeomsCollide(MjcfContext& context, std::vector<std::vector<MjcfGeom>>& geoms);

}  // namespace gaitwright
