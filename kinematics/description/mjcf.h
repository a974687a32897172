// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Triangles of a mesh, in its own frame and unit.
struct MjcfMesh {
  std::vector<Vector3> vertices;
  std::vector<Eigen::Vector3i> triangles;  ///< indices into vertices
};

/// A mesh given by its vertices in the model itself.
struct MjcfInlineMesh {
  std::string file;  ///< name that the URDF has in place of a file: "inline:NAME"
  MjcfMesh mesh;
};

/// The robot of a MuJoCo model (MJCF) as texts for LoadRobotFromText.
struct ConvertedMjcf {
  std::string urdf;
  std::vector<MjcfInlineMesh> meshes;  ///< meshes that the model contains instead of naming a file
  std::string yaml;                  ///< name, standing posture, gains, rotor inertias: data that a URDF cannot contain
  std::string yaml_without_posture;  ///< `yaml` without the posture of the keyframe, for a keyframe that is refused
                                     ///< (code `robot_yaml`) because the feet are not on level ground
  std::vector<std::string>
      notes;  ///< elements that were left out or converted differently, each with file, line and element
};

/// Reads a mesh file by the path in the URDF, which is absolute or relative to the model's folder. Only needed for
/// bodies whose inertia MuJoCo computes from a mesh.
using MjcfMeshReader = std::function<Result<MjcfMesh>(const std::string& path)>;

/// Functions that read the files named by a model.
struct MjcfFiles {
  std::function<Result<std::string>(const std::string& file)>
      text;  ///< reads an included file by its name in `<include>`
  MjcfMeshReader mesh;
};

/// Whether a text is a MuJoCo model: its root element is <mujoco> or <mujocoinclude>.
bool IsMjcf(const std::string& text);

/// Converts a MuJoCo model into a URDF and a robot.yaml. Paths of meshes in the URDF are relative to the folder of
/// `path`.
///
/// = Converted directly =
///   bodies, joints with their anchors, limits, damping, friction and armature, inertia (given or from geoms), geoms,
///   effort limits and servo gains of actuators, linear joint equalities (mimic), the keyframe `home` or the first one
///
/// = Converted with changes =
///   ellipsoid: a capsule or box around it
///   prismatic joint without range: 1 km in both directions
///   joint without actuator, if other joints have one: effort limit 0, which means that it has no motor
///   joint whose actuators have no force limit, and all joints of a model without actuators: effort 1e6, unknown
///   closed loop of connect or weld in a small part that carries no foot, such as a gripper: its joints are locked
///   actuator of a tendon or slider-crank: left out
///   fixed tendon with a narrow range of length: transmits the torque of motors to a joint without a motor
///   first body without free joint: floating base
///
/// @param read_mesh  for inertia from meshes; without it, a body with such an inertia is refused.
/// @return the texts, or a Failure of kind kBadInput that names file, line, element and value: not XML; wrong numbers
/// or names; connect and weld that close other loops or tie the robot to the world; equalities that are not linear;
/// <replicate>, <attach>, <composite>, <flexcomp>; more than 16 MiB of text, 200 levels, 100 files or 1000 bodies.
/// Format: MuJoCo XML reference, https://mujoco.readthedocs.io/en/stable/XMLreference.html
Result<ConvertedMjcf> ConvertMjcf(const std::string& path, const MjcfMeshReader& read_mesh = {});

/// Converts the text of a model. @param name  name of the model's file, for messages.
Result<ConvertedMjcf> ConvertMjcfText(const std::string& text, const MjcfFiles& files = {},
                                      const std::string& name = "model.xml");

}  // namespace gaitwright
