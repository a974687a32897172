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
#include "playback/mjcf/model_text_internal.h"

namespace gaitwright::mujoco {
namespace {

constexpr double kPointFootRadius = 0.005;   // of a point foot's sphere [m]
constexpr double kSoleSphereRadius = 0.002;  // [m]
constexpr double kPlateThickness = 0.01;     // [m]
constexpr double kPlateLift = 0.0002;        // of the plate over the corners: it touches where they do not [m]
constexpr double kObstacleFriction = 0.8;
constexpr double kFieldBase = 1.0;       // depth of the solid under a height field [m]
constexpr double kLeastMass = 1e-11;     // [kg] of bodies without mass, which MuJoCo does not have
constexpr double kLeastInertia = 1e-14;  // [kg m^2]

std::string Number(double value) { return fmt::format("{:.17g}", value); }

template <class Vector>
std::string Numbers(const Vector& values) {
  std::string text;
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i > 0 ? " " : "") + Number(values[i]);
  return text;
}

std::string PlaceOf(const Pose& X) {
  const Quaternion q(X.linear());
  return fmt::format("pos=\"{}\" quat=\"{} {} {} {}\"", Numbers(Vector3(X.translation())), Number(q.w()), Number(q.x()),
                     Number(q.y()), Number(q.z()));
}

/// X_JB of the child when its joint stands at a position.
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
    const std::string ground = Ground(), robot = BodyText(0), gears = Gears();
    text_.mjcf = fmt::format(
        "<mujoco model=\"{}\">\n"
        "<compiler angle=\"radian\" coordinate=\"local\" inertiafromgeom=\"false\" boundmass=\"{}\" "
        "boundinertia=\"{}\" autolimits=\"false\"/>\n"
        "<option timestep=\"{}\" gravity=\"0 0 {}\" integrator=\"{}\" cone=\"elliptic\" solver=\"Newton\" "
        "iterations=\"{}\" tolerance=\"1e-12\" jacobian=\"dense\" impratio=\"{}\"/>\n"
        "<size njmax=\"{}\" nconmax=\"{}\"/>\n"
        "<default><geom contype=\"1\" conaffinity=\"2\" condim=\"3\" solref=\"{} 1\" solimp=\"{}\"/></default>\n"
        "<asset>\n{}</asset>\n<worldbody>\n{}{}</worldbody>\n{}{}</mujoco>\n",
        EscapedXml(model_.name), Number(kLeastMass), Number(kLeastInertia), Number(options_.step_s), Number(-kGravity),
        parts_ == nullptr ? "Euler" : "implicit", kIterations, Number(kImpratio), kMostRows, kMostContacts,
        Number(std::max(2.0 * options_.step_s, kContactTime * std::sqrt(options_.contact_softness))), kContactImpedance,
        assets_, ground, robot, gears, parts_ == nullptr ? "" : Motors() + KeyFrame());
    return std::move(text_);
  }

 private:
  static constexpr int kIterations = 100, kMostContacts = 400, kMostRows = 3 * kMostContacts + 300;
  static constexpr double kImpratio = 100.0;     // friction is harder than normals: feet creep less
  static constexpr double kContactTime = 0.004;  // [s]
  static constexpr const char* kContactImpedance = "0.95 0.99 0.0005";

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
    // By principal axes: MuJoCo's own find them to fewer digits.
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(I);
    Pose X_BM = Pose::Identity();
    X_BM.linear() = solver.eigenvectors();
    if (X_BM.linear().determinant() < 0.0) X_BM.linear().col(0) *= -1.0;
    X_BM.translation() = p_BC;
    return fmt::format("<inertial {} mass=\"{}\" diaginertia=\"{}\"/>\n", PlaceOf(X_BM), Number(mass),
                       Numbers(Moments(solver.eigenvalues())));
  }

  /// Principal moments, ascending. MuJoCo refuses those of a plate or a rod that break the triangle inequality by
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
      text += fmt::format("<geom {} {} {}/>\n", Part({-1, shape.link}), ShapeText(shape), PlaceOf(shape.X_BS));
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
    const bool all_over = foot.type == FootType::kSole && options_.sole_contact == "auto" && finest_m_ > 0.0;
    const std::vector<Vector2> places = all_over ? SoleSamples(foot.sole_F, kSoleSampling * finest_m_) : foot.sole_F;
    for (const Vector2& p : places) sphere({p.x(), p.y(), kSoleSphereRadius}, kSoleSphereRadius);
    const bool plate = options_.sole_contact == "plate" || (options_.sole_contact == "auto" && has_edges_);
    if (!plate || foot.sole_F.size() < 3) return text;
    std::vector<Vector3> corners;
    for (const Vector2& p : foot.sole_F) {
      corners.emplace_back(p.x(), p.y(), kPlateLift);
      corners.emplace_back(p.x(), p.y(), kPlateLift + kPlateThickness);
    }
    text += fmt::format("<geom {} {} {}/>\n", Part(part), MeshText(corners), PlaceOf(foot.X_BF));
    return text;
  }

  /// A mesh of points, of which MuJoCo takes the convex hull. It moves a mesh to its own centre and principal axes and
  /// makes up for that in the geom's pose.
  std::string MeshText(const std::vector<Vector3>& vertices) {
    const int number = meshes_++;
    assets_ += fmt::format("<mesh name=\"m{}\" vertex=\"", number);
    for (const Vector3& p : vertices) assets_ += Numbers(p) + " ";
    assets_ += "\"/>\n";
    return fmt::format("type=\"mesh\" mesh=\"m{}\"", number);
  }

  std::string ShapeText(const Shape& shape) {
    switch (shape.type) {
      case ShapeType::kBox:
        return fmt::format("type=\"box\" size=\"{}\"", Numbers(Vector3(0.5 * shape.size)));
      case ShapeType::kSphere:
        return fmt::format("type=\"sphere\" size=\"{}\"", Number(std::max(shape.size.x(), 1e-6)));
      case ShapeType::kCylinder:
        return fmt::format("type=\"cylinder\" size=\"{} {}\"", Number(shape.size.x()), Number(0.5 * shape.size.y()));
      case ShapeType::kCapsule:
        return fmt::format("type=\"capsule\" size=\"{} {}\"", Number(shape.size.x()), Number(0.5 * shape.size.y()));
      case ShapeType::kMesh:
        break;
    }
    return MeshText(shape.vertices);
  }

  std::string Solid(const std::string& shape, const Pose& X_WS, double friction) {
    const double coefficient = options_.friction > 0.0 ? options_.friction : friction;
    return fmt::format(
        "<geom name=\"t{}\" {} {} friction=\"{} 0 0\" contype=\"2\" conaffinity=\"1\" priority=\"1\"/>\n", solids_++,
        shape, PlaceOf(X_tilt_ * X_WS), Number(coefficient));
  }

  std::string Ground() {
    X_tilt_ = GroundTilt(terrain_, options_, bumps_.start);
    text_.solids = SolidNames(terrain_, bumps_.amplitude > 0.0);
    std::string text;
    for (const Obstacle& obstacle : terrain_.obstacles)
      text += Solid(ShapeText(ShapeOf(obstacle)), obstacle.X_WO, kObstacleFriction);
    if (bumps_.amplitude > 0.0)
      return text + FieldText(BumpyGround(terrain_, options_, bumps_), FrictionOf(terrain_, options_, bumps_.start));
    for (const TerrainPatch& patch : terrain_.patches) text += PatchText(patch);
    for (const HeightField& field : terrain_.height_fields) text += FieldText(field, field.friction);
    return text;
  }

  std::string PatchText(const TerrainPatch& patch) {
    if (patch.outline_T.empty()) return Solid("type=\"plane\" size=\"0 0 1\"", patch.X_WT, patch.friction);
    has_edges_ = true;
    std::vector<Vector3> corners;
    for (const Vector3& corner_W : SolidUnder(patch)) corners.push_back(patch.X_WT.inverse() * corner_W);
    return Solid(MeshText(corners), patch.X_WT, patch.friction);
  }

  /// MuJoCo parts the cells of a field by the diagonal that ours do not have: so the field is turned a quarter to the
  /// left, where its rows go along our x.
  std::string FieldText(const HeightField& field, double friction) {
    finest_m_ = finest_m_ > 0.0 ? std::min(finest_m_, field.resolution_m) : field.resolution_m;
    const auto [low, high] = std::minmax_element(field.height_m.begin(), field.height_m.end());
    const double rise = std::max(*high - *low, 1e-6);
    FieldHeights heights;
    heights.rows = field.columns;  // of MuJoCo's: along its own y, which is our -x
    heights.columns = field.rows;  // along its own x, which is our y
    heights.heights.resize(field.height_m.size());
    for (int row = 0; row < heights.rows; ++row) {
      for (int column = 0; column < heights.columns; ++column) {
        const int x = field.columns - 1 - row, y = column;
        const double height = field.height_m[static_cast<std::size_t>(y * field.columns + x)];
        heights.heights[static_cast<std::size_t>(row * heights.columns + column)] =
            static_cast<float>((height - *low) / rise);
      }
    }
    const Vector2 extent = field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
    Pose X_WS = Pose::Identity();
    X_WS.linear() = Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitZ()).toRotationMatrix();
    X_WS.translation() << field.origin_W + 0.5 * extent, *low;
    const std::size_t number = text_.fields.size();
    assets_ += fmt::format("<hfield name=\"h{}\" {} size=\"{} {} {} {}\"/>\n", number,
                           parts_ == nullptr ? fmt::format("nrow=\"{}\" ncol=\"{}\"", heights.rows, heights.columns)
                                             : fmt::format("file=\"{}\"", EscapedXml(parts_->heights.at(number))),
                           Number(0.5 * extent.y()), Number(0.5 * extent.x()), Number(rise), Number(kFieldBase));
    text_.fields.push_back(std::move(heights));
    return Solid(fmt::format("type=\"hfield\" hfield=\"h{}\"", number), X_WS, friction);
  }

  /// Mimicking joints follow by equality constraints, as stiff as the step allows.
  std::string Gears() const {
    std::string text;
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const Joint& joint = model_.joints[i];
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

  /// Attributes of a joint in a file: its limits, and its share of what the joints of its coordinate lose.
  std::string Losses(const Joint& joint) const {
    if (parts_ == nullptr) return "";
    std::string text =
        fmt::format(" damping=\"{}\" frictionloss=\"{}\"", Number(joint.damping), Number(joint.friction));
    if (!joint.is_mimic) text += fmt::format(" armature=\"{}\"", Number(LossesOf(model_, joint.dof).rotor_inertia));
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper))
      text += fmt::format(" limited=\"true\" range=\"{} {}\"", Number(joint.lower), Number(joint.upper));
    return text;
  }

  /// Of each coordinate a motor with the gains of a PD: control is the target position.
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

  /// Positions of all joints in the order of the file, which is that of the bodies as they are written.
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
  Pose X_tilt_ = Pose::Identity();
  bool has_edges_ = false;
  double finest_m_ = 0.0;
  int meshes_ = 0, solids_ = 0;
  std::string assets_;
  ModelText text_;
};

}  // namespace

ModelText WriteModel(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
                     const FileParts* parts) {
  return Writer(model, terrain, q, options, parts).Write();
}

}  // namespace gaitwright::mujoco
