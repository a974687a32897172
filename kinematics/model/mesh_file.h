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

/// Reads an STL (text or binary), OBJ or Collada (.dae) file. A Collada file's unit and up-axis are kept to: its
/// numbers become metres, with z up. Failure: no such file, another kind of file, one that
/// cannot be read (with the reason), one without triangles or with numbers that are not finite.
Result<Mesh> ReadMesh(const std::string& path);

/// Points with the convex hull of those given, sorted: each once; of over 512 of them those that are farthest in one of
/// 1024 directions spread over the sphere, whose hull is smaller by at most 0.2 % of the mesh's radius.
std::vector<Vector3> HullPoints(std::vector<Vector3> points);

/// Path of a file that a URDF names: a path relative to `folder` (the URDF's; "" the present one) or absolute,
/// `file://PATH`, or `package://NAME/PATH`, where FindPackage looks for folders of the package and the first that holds
/// the file is taken. Failure `no_file`: there is none; the message lists where it was looked for.
Result<std::string> FindMeshFile(const std::string& name, const std::string& folder,
                                 const PackageFolders& packages = {});

}  // namespace gaitwright
