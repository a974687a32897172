// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/description/find_package.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Triangles of a mesh in its own frame and unit.
struct Mesh {
  std::vector<Vector3> vertices;
  std::vector<Eigen::Vector3i> triangles;  ///< indices into vertices
};

/// Reads an STL (text or binary), OBJ or Collada (.dae) file. The unit and up axis of a Collada file are applied, so
/// its mesh is in metres with z up. Failure: the file does not exist, has another format, cannot be read (with the
/// reason), has no triangles, or contains a number that is not finite.
Result<Mesh> ReadMesh(const std::string& path);

/// The given points without duplicates, sorted. More than 512 points are reduced to those that are farthest in one of
/// 1024 directions spread over the sphere. The hull of these is smaller by at most 0.2 % of the mesh's radius.
std::vector<Vector3> HullPoints(std::vector<Vector3> points);

/// Path of a file that a URDF names. The name may be an absolute path, a path relative to `folder` (the folder of the
/// URDF; "" is the current folder), `file://PATH`, or `package://NAME/PATH`. For a package, the first folder of
/// FindPackage that contains the file is used. Failure `no_file`: the file does not exist; the message lists the
/// searched places.
Result<std::string> FindMeshFile(const std::string& name, const std::string& folder,
                                 const PackageFolders& packages = {});

}  // namespace gaitwright
