// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/mjcf.h"
#include "kinematics/description/mjcf_compiler_internal.h"
#include "kinematics/description/mjcf_defaults_internal.h"

namespace gaitwright {

inline constexpr std::size_t kMostMjcfNotes = 1000;

/// Common data of all parts of the conversion.
struct MjcfContext {
  MjcfContext(const std::string& text, const MjcfFiles& given, const std::string& name)
      : document(text, name, given.text), compiler(ReadMjcfCompiler(document)), defaults(document), files(given) {}

  /// Adds a note for the user about an element. The number of notes is limited; the last one says that there are more.
  void Note(const std::string& owner, const std::string& what);
  bool has_many_notes() const { return notes.size() > kMostMjcfNotes; }

  MjcfDocument document;
  MjcfCompiler compiler;
  MjcfDefaults defaults;
  const MjcfFiles& files;
  std::vector<std::string> notes;
  bool friction_is_noted = false;
};

enum class MjcfJointType { kHinge, kSlide, kBall, kFree };

/// A joint of a body, in the body's frame B: the body moves about or along the axis through `pos`.
struct MjcfJoint {
  std::string owner, name;
  MjcfJointType type = MjcfJointType::kHinge;
  Vector3 pos = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();
  double ref = 0.0;                                ///< its position in the pose of the file [rad, m]
  std::optional<std::pair<double, double>> range;  ///< [rad, m]
  std::optional<double> force_limit;               ///< limit of the sum of all its actuators [N m, N]
  double damping = 0.0, friction = 0.0, armature = 0.0;

  /// Number of its values in the qpos of a keyframe.
  std::size_t num_positions() const;
  bool is_scalar() const { return type == MjcfJointType::kHinge || type == MjcfJointType::kSlide; }
};

/// An element of a body, with the frame F around it.
struct MjcfPart {
  const tinyxml2::XMLElement* element = nullptr;
  Pose X_BF = Pose::Identity();
  std::string childclass;
};

/// = Notation =
///   B  the body's frame      P  the parent body's frame; the world for the first body of a tree
struct MjcfBody {
  std::string owner, name;
  int parent = -1;  ///< index of a body before it; -1 for the world
  bool is_mocap = false;
  Pose X_PB = Pose::Identity();
  std::vector<int> joints;  ///< indices, in the order in which they move the body
  std::vector<MjcfPart> geoms;
  std::optional<MjcfPart> inertial;
};

/// The bodies and joints of a model in MuJoCo's order: depth first. The robot is one of the trees.
struct MjcfTree {
  std::vector<MjcfBody> bodies;
  std::vector<MjcfJoint> joints;
  int root = -1;               ///< the robot's first body
  std::vector<bool> in_robot;  ///< by body
  std::map<std::string, int> body_named, joint_named;
  std::map<std::string, int> body_of_site;  ///< by the site's name; -1 for a site of the world
  std::vector<int> body_of;                 ///< by joint

  bool IsRobotJoint(int joint) const;
  /// Whether the joint becomes a joint of the URDF: it belongs to the robot and does not join its first body to the
  /// world.
  bool Moves(int joint) const;
};

/// Throws a Failure for unsupported elements, duplicate names, and more than 1000 bodies.
MjcfTree ReadMjcfTree(MjcfContext& context);

/// Reads a joint of a body. @param part  its element.
MjcfJoint ReadMjcfJoint(MjcfContext& context, const MjcfPart& part);

/// The bound of a range of two numbers for both directions: the smaller magnitude of its ends, or the larger one if the
/// smaller is zero. Adds a note if the magnitudes differ.
double MjcfEitherSide(MjcfContext& context, const MjcfAttributes& attributes, const std::string& key);

}  // namespace gaitwright
