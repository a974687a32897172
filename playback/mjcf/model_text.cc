// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "kinematics/base/text.h"
#include "kinematics/collision/shape_extent.h"
#include "kinematics/model/joint_losses.h"
#include "planning/plan/sole_support.h"
#include "planning/plan/terrain_shapes.h"
#include "playback/engine/world.h"
#include "playback/mjcf/elements_internal.h"
#include "playback/mjcf/model_text_internal.h"

namespace gaitwright::mujoco {
namespace {

constexpr double kPointFootRadius = 0.005;   // of a point foot's sphere [m]
constexpr double kSoleSphereRadius = 0.002;  // [m]
constexpr double kPlateThickness = 0.01;     // [m]
// plate above corner level; it touches only where corner spheres do not [m]
constexpr double kPlateLift = 0.0002;
constexpr double kLeastMass = 1e-11;     // [kg] of bodies without mass, which MuJoCo refuses
constexpr double kLeastInertia = 1e-14;  // [kg m^2]

/// X_JB of the child body at a joint position.
Pose JointMotion(const Joint& joint, double position) {
  Pose X = Pose::Identity();
  if (joint.is_prismatic()) {
    X.translation() = position * joint.axis_J;
  } else {
    X.linear() = Eigen::AngleAxisd(position, joint.axis_J).toRotationMatrix();
  }
  return X;
}

class Writer {
 public:
  Writer(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
         const FileParts* parts)
      : model_(model), terrain_(terrain), q_(q), options_(options), parts_(parts), bumps_(BumpsOf(model, q, options)) {
    locked_.assign(model.dof_names.size(), false);
    for (const int dof : options.locked_dofs) locked_[static_cast<std::size_t>(dof)] = true;
    children_.resize(model.bodies.size());
    for (std::size_t i = 0; i < model.joints.size(); ++i)
      children_[static_cast<std::size_t>(model.joints[i].parent_body)].push_back(static_cast<int>(i) + 1);
  }

  ModelText Write() {
    WriteGroundOfWorld();
    const std::string robot = BodyText(0), gears = Gears();
    text_.fields = std::move(ground_.fields);
    text_.mjcf = fmt::format(
        "<mujoco model=\"{}\">\n"
        "<compiler angle=\"radian\" coordinate=\"local\" inertiafromgeom=\"false\" boundmass=\"{}\" "
        "boundinertia=\"{}\" autolimits=\"false\"/>\n"
        "<option timestep=\"{}\" gravity=\"0 0 {}\" integrator=\"{}\" cone=\"elliptic\" solver=\"Newton\" "
        "iterations=\"{}\" tolerance=\"1e-12\" jacobian=\"dense\" impratio=\"{}\"/>\n"
        "<size njmax=\"{}\" nconmax=\"{}\"/>\n"
        "<default><geom contype=\"1\" conaffinity=\"2\" {}/></default>\n"
        "<asset>\n{}{}</asset>\n<worldbody>\n{}{}</worldbody>\n{}{}</mujoco>\n",
        EscapedXml(model_.name), Number(kLeastMass), Number(kLeastInertia), Number(options_.step_s), Number(-kGravity),
        parts_ == nullptr ? "Euler" : "implicit", kIterations, Number(kImpratio), kMostRows, kMostContacts,
        ContactAttributes(options_), ground_.assets, assets_, ground_.geoms, robot, gears,
        parts_ == nullptr ? "" : Motors() + KeyFrame());
    return std::move(text_);
  }

 private:
  static constexpr int kIterations = 100, kMostContacts = 400, kMostRows = 3 * kMostContacts + 300;
  static constexpr double kImpratio = 100.0;  // friction is stiffer than the normal direction, so that feet creep less

  bool Locked(const Joint& joint) const { return locked_[static_cast<std::size_t>(joint.dof)]; }

  std::string BodyText(int index) {
    const auto i = static_cast<std::size_t>(index);
    const Body& body = model_.bodies[i];
    std::string text;
    if (index == 0) {
      text = fmt::format("<body name=\"{}\">\n<freejoint/>\n", EscapedXml(body.name));
    } else {
      const Joint& joint = model_.joints[i - 1];
      const bool fixed = Locked(joint);
      const double position = fixed ? joint.multiplier * q_[7 + joint.dof] + joint.offset : 0.0;
      text = fmt::format("<body name=\"{}\" {}>\n", EscapedXml(body.name),
                         PlaceOf(joint.X_PJ * JointMotion(joint, position)));
      if (!fixed) {
        text += fmt::format("<joint name=\"{}\" type=\"{}\" axis=\"{}\"{}/>\n", EscapedXml(joint.name),
                            joint.is_prismatic() ? "slide" : "hinge", Numbers(joint.axis_J), Losses(joint));
      }
    }
    text += Inertial(body, index == 0);
    text += Geoms(index);
    for (const int child : children_[i]) text += BodyText(child);
    return text + "</body>\n";
  }

  std::string Inertial(const Body& body, bool base) const {
    const double scale = options_.mass_scale * options_.inertia_scale, mass = options_.mass_scale * body.mass;
    Vector3 p_BC = body.p_BC;
    if (base) p_BC += Vector3(options_.com_shift_x_m, options_.com_shift_y_m, options_.com_shift_z_m);
    const Matrix3 I = scale * body.I_C;
    if (mass <= 0.0) {
      return fmt::format("<inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"{} {} {}\"/>\n", Number(kLeastMass),
                         Number(kLeastInertia), Number(kLeastInertia), Number(kLeastInertia));
    }
    // Written by principal axes, because MuJoCo computes them with fewer digits.
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(I);
    Pose X_BM = Pose::Identity();
    X_BM.linear() = solver.eigenvectors();
    if (X_BM.linear().determinant() < 0.0) X_BM.linear().col(0) *= -1.0;
    X_BM.translation() = p_BC;
    return fmt::format("<inertial {} mass=\"{}\" diaginertia=\"{}\"/>\n", PlaceOf(X_BM), Number(mass),
                       Numbers(Moments(solver.eigenvalues())));
  }

  /// Principal moments, ascending. MuJoCo refuses moments of a plate or a rod that violate the triangle inequality by
  /// rounding.
  static Vector3 Moments(const Vector3& ascending) {
    constexpr double kRounding = 1e-9;
    Vector3 moments = ascending.cwiseMax(kLeastInertia);
    const double lacking = (1.0 + kRounding) * moments[2] - moments[0] - moments[1];
    if (lacking > 0.0 && lacking < 1e-3 * moments[2]) moments.head<2>().array() += 0.5 * lacking;
    return moments;
  }

  std::string Part(const GeomPart& part) {
    text_.parts.push_back(part);
    return fmt::format("name=\"g{}\"", text_.parts.size() - 1);
  }

  std::string Geoms(int body) {
    std::string text;
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      if (model_.feet[f].body == body) text += FootGeoms(static_cast<int>(f));
    }
    for (const Shape& shape : model_.collision_shapes) {
      if (shape.body != body || IsShapeOfAFoot(model_, shape)) continue;
      if (shape.type == ShapeType::kMesh && shape.vertices.size() < 4) continue;
      text += fmt::format("<geom {} {} {}/>\n", Part({-1, shape.link}), ShapeText(shape, NextMesh(), assets_),
                          PlaceOf(shape.X_BS));
    }
    return text;
  }

  std::string FootGeoms(int index) {
    const Foot& foot = model_.feet[static_cast<std::size_t>(index)];
    const GeomPart part{index, foot.link};
    std::string text;
    const auto sphere = [&](const Vector3& p_F, double radius) {
      const Vector3 p_B = foot.X_BF * p_F;
      text +=
          fmt::format("<geom {} type=\"sphere\" size=\"{}\" pos=\"{}\"/>\n", Part(part), Number(radius), Numbers(p_B));
    };
    if (foot.type == FootType::kSphere) sphere(Vector3::Zero(), foot.radius);
    if (foot.type == FootType::kPoint) sphere({0.0, 0.0, kPointFootRadius}, kPointFootRadius);
    if (!foot.has_sole()) return text;
    const bool all_over = foot.type == FootType::kSole && options_.sole_contact == "auto" && ground_.finest_m > 0.0;
    const std::vector<Vector2> places =
        all_over ? SoleSamples(foot.sole_F, kSoleSampling * ground_.finest_m) : foot.sole_F;
    for (const Vector2& p : places) sphere({p.x(), p.y(), kSoleSphereRadius}, kSoleSphereRadius);
    const bool plate = options_.sole_contact == "plate" || (options_.sole_contact == "auto" && ground_.has_edges);
    if (!plate || foot.sole_F.size() < 3) return text;
    std::vector<Vector3> corners;
    for (const Vector2& p : foot.sole_F) {
      corners.emplace_back(p.x(), p.y(), kPlateLift);
      corners.emplace_back(p.x(), p.y(), kPlateLift + kPlateThickness);
    }
    text += fmt::format("<geom {} {} {}/>\n", Part(part), MeshText(corners, NextMesh(), assets_), PlaceOf(foot.X_BF));
    return text;
  }

  std::string NextMesh() { return fmt::format("m{}", meshes_++); }

  /// The ground as played: turned, and with bumps instead of its surfaces.
  void WriteGroundOfWorld() {
    const bool has_bumps = bumps_.amplitude > 0.0;
    text_.solids = SolidNames(terrain_, has_bumps);
    GroundStyle style;
    style.X_tilt = GroundTilt(terrain_, options_, bumps_.start);
    style.friction = options_.friction;
    style.attributes = "contype=\"2\" conaffinity=\"1\" priority=\"1\"";
    for (std::size_t i = 0; i < text_.solids.size(); ++i) style.names.push_back(fmt::format("t{}", i));
    if (parts_ != nullptr) style.height_files = parts_->heights;
    if (!has_bumps) {
      ground_ = WriteGround(terrain_, style);
      return;
    }
    Terrain bumpy{terrain_.name, {}, {BumpyGround(terrain_, options_, bumps_)}, terrain_.obstacles};
    bumpy.height_fields.front().friction = FrictionOf(terrain_, options_, bumps_.start);
    ground_ = WriteGround(bumpy, style);
  }

  /// Mimic joints follow by equality constraints, as stiff as the step allows.
  std::string Gears() const {
    std::string text;
    for (const Joint& joint : model_.joints) {
      if (!joint.is_mimic || Locked(joint)) continue;
      text += fmt::format(
          "<joint joint1=\"{}\" joint2=\"{}\" polycoef=\"{} {} 0 0 0\" solref=\"{} 1\" solimp=\"0.9999 0.9999 "
          "0.001\"/>\n",
          EscapedXml(joint.name), LeaderOf(joint.dof), Number(joint.offset), Number(joint.multiplier),
          Number(2.0 * options_.step_s));
    }
    return text.empty() ? "" : "<equality>\n" + text + "</equality>\n";
  }

  std::string LeaderOf(int dof) const { return EscapedXml(model_.dof_names[static_cast<std::size_t>(dof)]); }

  /// Attributes of a joint in a file: its limits, and its share of the losses of its coordinate.
  std::string Losses(const Joint& joint) const {
    if (parts_ == nullptr) return "";
    std::string text =
        fmt::format(" damping=\"{}\" frictionloss=\"{}\"", Number(joint.damping), Number(joint.friction));
    if (!joint.is_mimic) text += fmt::format(" armature=\"{}\"", Number(LossesOf(model_, joint.dof).rotor_inertia));
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper))
      text += fmt::format(" limited=\"true\" range=\"{} {}\"", Number(joint.lower), Number(joint.upper));
    return text;
  }

  /// For each coordinate, a motor with PD gains; its control is the target position.
  std::string Motors() const {
    std::string text;
    for (int dof = 0; dof < model_.num_dofs(); ++dof) {
      const double kp = parts_->stiffness[dof], kd = parts_->damping[dof], limit = model_.dof_effort_limit(dof);
      const std::string range =
          std::isfinite(limit) && limit > 0.0
              ? fmt::format(" forcelimited=\"true\" forcerange=\"{} {}\"", Number(-limit), Number(limit))
              : "";
      text += fmt::format(
          "<general name=\"{0}\" joint=\"{0}\" biastype=\"affine\" gainprm=\"{1}\" biasprm=\"0 -{1} -{2}\"{3}/>\n",
          LeaderOf(dof), Number(kp), Number(kd), range);
    }
    return text.empty() ? "" : "<actuator>\n" + text + "</actuator>\n";
  }

  /// Positions of all joints in the order of the file, i.e. of the bodies as they are written.
  void AddPositions(int body, std::string& text) const {
    if (body > 0) {
      const Joint& joint = model_.joints[static_cast<std::size_t>(body) - 1];
      if (!Locked(joint)) text += " " + Number(joint.multiplier * q_[7 + joint.dof] + joint.offset);
    }
    for (const int child : children_[static_cast<std::size_t>(body)]) AddPositions(child, text);
  }

  std::string KeyFrame() const {
    const Eigen::Vector4d xyzw = q_.segment<4>(3);
    std::string positions =
        fmt::format("{} {} {}", Numbers(Vector3(q_.head<3>())), Number(xyzw[3]), Numbers(Vector3(xyzw.head<3>())));
    AddPositions(0, positions);
    return fmt::format("<keyframe>\n<key name=\"start\" qpos=\"{}\" ctrl=\"{}\"/>\n</keyframe>\n", positions,
                       Numbers(VectorX(q_.tail(model_.num_dofs()))));
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const VectorX& q_;
  const WorldOptions& options_;
  const FileParts* parts_;
  const Bumps bumps_;
  std::vector<bool> locked_;
  std::vector<std::vector<int>> children_;  // by body
  GroundText ground_;
  int meshes_ = 0;
  std::string assets_;
  ModelText text_;
};

}  // namespace

ModelText WriteModel(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
                     const FileParts* parts) {
  return Writer(model, terrain, q, options, parts).Write();
}

}  // namespace gaitwright::mujoco
