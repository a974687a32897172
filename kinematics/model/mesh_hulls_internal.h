// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Convex hulls of mesh files by their content: equal files are parsed once, whatever their names are. A file that
/// changed between two calls is read anew. Several threads may use one object.
class MeshHulls {
 public:
  /// HullPoints of the mesh. Failure as of ReadMesh; a failure is not kept.
  Result<std::vector<Vector3>> Of(const std::string& path);

  /// Number of different meshes that were parsed.
  std::size_t size() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<Vector3>> by_content_;
};

/// The hulls that LoadRobot keeps until the program ends, since commands load a robot more than once.
MeshHulls& HullsOfThisRun();

}  // namespace gaitwright
