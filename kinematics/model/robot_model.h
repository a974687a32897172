// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/model/finding.h"
#include "kinematics/model/motor.h"
#include "kinematics/model/transmission.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Type of a joint's motion. A continuous joint is a revolute joint without position limits.
enum class JointType { kRevolute, kContinuous, kPrismatic };

/// One moving joint; it carries the body of the same index plus one (`RobotModel::bodies`).
///
/// = Notation =
///   P  frame of the parent body      J  frame of the joint at position zero; the child body's frame moves from it
struct Joint {
  std::string name;
  JointType type = JointType::kRevolute;
  int parent_body = 0;                         ///< index into bodies, less than the child's
  Pose X_PJ = Pose::Identity();                ///< in the parent body's frame
  Vector3 axis_J = Vector3::UnitZ();           ///< unit
  double lower = 0.0, upper = 0.0;             ///< [rad] or [m]; -inf and inf when continuous
  double velocity_limit = 0.0;                 ///< [rad/s] or [m/s]
  double effort_limit = 0.0;                   ///< [N m] or [N]
  bool velocity_limit_is_placeholder = false;  ///< the limit is reported but not checked
  bool effort_limit_is_placeholder = false;
  double damping = 0.0;   ///< viscous damping [N m s/rad]
  double friction = 0.0;  ///< dry friction, against any motion [N m]

  /// Index of the independent joint coordinate that moves it; position = multiplier * q_joint[dof] + offset.
  /// A joint that mimics no other has its own dof, multiplier 1 and offset 0.
  int dof = 0;
  double multiplier = 1.0;
  double offset = 0.0;
  bool is_mimic = false;

  bool is_prismatic() const { return type == JointType::kPrismatic; }
};

/// A rigid body: a URDF link with every link fixed to it. Body 0 is the floating base in the URDF root link's frame.
struct Body {
  std::string name;                ///< the heaviest link merged into it
  double mass = 0.0;               ///< [kg]; 0 for a massless intermediate link
  Vector3 p_BC = Vector3::Zero();  ///< centre of mass [m]
  Matrix3 I_C = Matrix3::Zero();   ///< about the centre of mass, in axes parallel to the body frame [kg m^2]
};

/// Any URDF link by name, as a frame fixed in a body.
struct Frame {
  std::string name;
  int body = 0;
  Pose X_BF = Pose::Identity();
};

/// Kinds of geometry that a URDF may give a link.
enum class ShapeType { kBox, kCylinder, kSphere, kCapsule, kMesh };

/// Collision or visual geometry fixed in a body; cylinder and capsule lie along z of S.
struct Shape {
  ShapeType type = ShapeType::kBox;
  std::string link;  ///< URDF link it belongs to
  int body = 0;
  Pose X_BS = Pose::Identity();
  Vector3 size = Vector3::Zero();  ///< box: edge lengths; cylinder, capsule: (radius, length, 0); sphere: (radius, 0,
                                   ///< 0); mesh: scale
  std::string mesh_file;           ///< mesh: as written in the URDF
  std::vector<Vector3> vertices;   ///< collision mesh: vertices of its convex hull in S, scaled; visual mesh: empty
};

/// The points that span the convex hull of a mesh file. Nothing else of the mesh is used.
struct MeshHull {
  std::string file;               ///< as written in the URDF
  std::vector<Vector3> vertices;  ///< in the mesh's frame, before the URDF's scale

  bool operator==(const MeshHull&) const = default;
};

/// A collision mesh of the URDF that is missing or cannot be read; contacts of its link are unknown.
struct MissingMesh {
  std::string link;
  std::string why;  ///< reason, with the name of the file
};

/// Type of a foot's contact with the ground; FootTypeNames has the names.
enum class FootType {
  kPoint,   ///< a point: three constraints
  kSphere,  ///< rolling contact: the contact point is a radius below the centre
  kLine,    ///< a sole without ankle roll
  kSole,    ///< a flat convex polygon: six constraints
};

/// "point", "sphere", "line", "sole": the names in files, in the order of FootType.
const std::vector<std::string>& FootTypeNames();

/// The part of a leg that touches the ground.
///
/// = Notation =
///   F  sole frame: z points up and x forward in the nominal standing posture; its origin is the middle of the sole
///      polygon (sole, line), the sphere's centre (sphere) or the point itself
struct Foot {
  std::string name;  ///< the link's name
  std::string link;
  int body = 0;
  FootType type = FootType::kPoint;
  Pose X_BF = Pose::Identity();
  double radius = 0.0;          ///< sphere [m]
  std::vector<Vector2> sole_F;  ///< sole, line: corners in F's xy plane, counter-clockwise [m]
  std::string derived_from;     ///< source of its type and size, as text

  bool has_sole() const { return type == FootType::kSole || type == FootType::kLine; }
};

/// A chain of joints from the base to a foot.
struct Leg {
  std::string name;
  int foot = 0;             ///< index into feet
  std::vector<int> joints;  ///< indices into joints, base first
  int mirror = -1;          ///< index of the leg on the other side, or -1
  double length_m = 0.0;    ///< from the hip joint to the contact, with the leg straight and prismatic joints extended
  int hip_joint = -1;       ///< index into joints: the first joint that bends the leg in its own plane
  int knee_joint = -1;      ///< index into joints, or -1
  double knee_sign = 0.0;   ///< sign of the knee's bend in the standing posture
};

/// A robot: joints, bodies, limits, legs, feet and geometry. Made by LoadRobot, then never changed.
///
/// State vectors have one order everywhere:
///   q = [p_WB (3), quaternion of R_WB as x y z w (4), independent joints (n)], size 7 + n
///   v = [v_WB in W (3), w_WB in W (3), joint rates (n)], size 6 + n;   a in the same order
/// Mimic joints follow their dof and have no own coordinate. Invariant: joints[i] carries bodies[i + 1]; parents come
/// before children; masses and inertias are physical.
struct RobotModel {
  std::string name, description;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Frame> frames;  ///< one for each URDF link
  std::vector<Shape> collision_shapes;
  std::vector<Shape> visual_shapes;
  std::vector<Foot> feet;  ///< feet of the legs in order, then rests: other links to lie on
  std::vector<Leg> legs;   ///< legs[i].foot == i; front before rear, left before right

  VectorX standing_joints;              ///< nominal posture of the independent joints, size n
  double standing_base_height_m = 0.0;  ///< height of the base origin above level ground in that posture
  double nominal_speed_m_s = 0.0;

  double total_mass_kg = 0.0;
  std::vector<std::string> dof_names;  ///< name of the joint that leads each independent coordinate, size n
  std::vector<int> dof_joint;          ///< index of that joint, size n

  /// Gains from robot.yaml, by dof; zero if they are derived from the effective inertia.
  VectorX stiffness, damping;               ///< [N m/rad], [N m s/rad]
  std::vector<Motor> motors;                ///< by dof; see MotorOf
  std::vector<Transmission> transmissions;  ///< motors that drive several joints together; see AddTransmission

  std::vector<Finding> findings;     ///< wrong or doubtful data in the description, and replacements
  std::vector<std::string> notes;    ///< derived data with sources and irregularities, as text
  std::string urdf_text, yaml_text;  ///< texts from which the robot was loaded
  std::vector<MeshHull> meshes;      ///< hulls of the collision shapes, each file once, in the order of the URDF
  std::vector<MissingMesh> missing_meshes;
  std::string hash;  ///< hash of the texts and the hulls

  int num_dofs() const { return static_cast<int>(dof_names.size()); }
  int nq() const { return 7 + num_dofs(); }
  int nv() const { return 6 + num_dofs(); }
  double weight_n() const { return total_mass_kg * kGravity; }

  /// Limits of an independent coordinate. Position and speed: the tightest limit of all joints that it moves. Effort:
  /// the limit of the leading joint. Infinite for placeholders. Plans and playbacks are checked against the limits of
  /// the motors (Actuator). The limits of a joint of a transmission are the bounding box of its motors' limits.
  double dof_lower(int dof) const;
  double dof_upper(int dof) const;
  double dof_velocity_limit(int dof) const;
  double dof_effort_limit(int dof) const;

  /// The joint that leads an independent coordinate.
  const Joint& LeaderOf(int dof) const;

  /// Motor data of an independent coordinate; unknown limits are infinite. For a joint of a transmission, only the
  /// limits of acceleration and jerk apply; its motors are those of TransmissionOf.
  const Motor& MotorOf(int dof) const;

  /// The transmission that drives an independent coordinate; null if it has its own motor.
  const Transmission* TransmissionOf(int dof) const;

  /// Length of the longest leg, from hip to contact, straight [m]; many limits scale with it.
  double leg_length_m() const;

  /// Index of the frame of that name. @throws InvalidArgument naming the nearest.
  int FrameIndex(const std::string& frame_name) const;
  /// Index of the independent coordinate led by that joint. @throws InvalidArgument naming the nearest.
  int DofIndex(const std::string& joint_name) const;
};

/// R_WB of a q. The quaternion may deviate from unit length.
inline Matrix3 BaseRotation(const VectorX& q) {
  return Quaternion(q[6], q[3], q[4], q[5]).normalized().toRotationMatrix();
}

/// q of the robot in its nominal standing posture, with the base above the origin of W, facing x.
VectorX StandingConfiguration(const RobotModel& model);

}  // namespace gaitwright
