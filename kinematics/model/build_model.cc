// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/build_model.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/idle_joints_internal.h"
#include "kinematics/model/mend_inertia.h"
#include "kinematics/model/oversized_inertia.h"
#include "kinematics/model/solid_inertia.h"
#include "kinematics/model/urdf_pose_internal.h"
#include "kinematics/spatial/steiner.h"
#include "kinematics/spatial/symmetric_matrix.h"

namespace gaitwright {
namespace {

constexpr double kLightestRobot = 1e-6;  // [kg]

Matrix3 TensorOf(const urdf::Inertial& inertial) {
  return SymmetricMatrix(inertial.ixx, inertial.ixy, inertial.ixz, inertial.iyy, inertial.iyz, inertial.izz);
}

/// Whether all links have the same inertia although their masses differ. Such an inertia is a placeholder.
bool InertiasArePlaceholders(const urdf::ModelInterface& urdf) {
  std::vector<const urdf::Inertial*> all;
  for (const auto& [name, link] : urdf.links_) {
    if (link->inertial && link->inertial->mass > 0.0) all.push_back(link->inertial.get());
  }
  constexpr std::size_t kFew = 3;
  if (all.size() < kFew) return false;
  const auto same_mass = [&](const auto* i) { return i->mass == all.front()->mass; };
  const auto same_tensor = [&](const auto* i) { return TensorOf(*i) == TensorOf(*all.front()); };
  return std::all_of(all.begin(), all.end(), same_tensor) && !std::all_of(all.begin(), all.end(), same_mass);
}

double MassOfLinks(const urdf::ModelInterface& urdf) {
  double mass = 0.0;
  for (const auto& [name, link] : urdf.links_) mass += link->inertial ? std::max(link->inertial->mass, 0.0) : 0.0;
  return mass;
}

/// Adds a link's mass to a body. @param I  about the link's centre of mass p, in the body's axes.
void AddInertia(Body& body, double link_mass, const Vector3& p, const Matrix3& I) {
  const double mass = body.mass + link_mass;
  const Vector3 centre = mass > 0.0 ? Vector3((body.mass * body.p_BC + link_mass * p) / mass) : Vector3::Zero();
  body.I_C += I + Steiner(body.mass, body.p_BC - centre) + Steiner(link_mass, p - centre);
  body.mass = mass;
  body.p_BC = centre;
}

double LargestMoment(const Matrix3& I) { return PrincipalMoments(I).cwiseAbs().maxCoeff(); }

/// Walks the URDF's tree and fills a model.
class Builder {
 public:
  Builder(const urdf::ModelInterface& urdf, const UrdfParts& parts, const std::string& name, double scale)
      : collision_(parts.collision),
        visual_(parts.visual),
        incomplete_(parts.incomplete),
        scale_(scale),
        total_mass_(MassOfLinks(urdf)),
        placeholder_inertias_(InertiasArePlaceholders(urdf)) {
    model_.name = name;
    model_.bodies.emplace_back();
    heaviest_.push_back(-1.0);
    VisitLink(*urdf.getRoot(), 0, Pose::Identity());
    AssignCoordinates();
    for (const Body& body : model_.bodies) model_.total_mass_kg += body.mass;
    ReportMendedInertias();
    model_.stiffness = model_.damping = model_.standing_joints = VectorX::Zero(model_.num_dofs());
  }
  RobotModel Take() { return std::move(model_); }
  std::vector<LinkInertia> TakeUsedInertias() { return std::move(used_); }

 private:
  void VisitLink(const urdf::Link& link, int body, const Pose& X_BL) {
    const auto b = static_cast<std::size_t>(body);
    model_.frames.push_back({link.name, body, X_BL});
    const double mass = link.inertial ? link.inertial->mass : 0.0;
    if (mass > heaviest_[b]) {
      heaviest_[b] = mass;
      model_.bodies[b].name = link.name;
    }
    if (link.inertial) AddLink(link, X_BL, model_.bodies[b]);
    AddShapes(collision_, link.name, body, X_BL, model_.collision_shapes);
    AddShapes(visual_, link.name, body, X_BL, model_.visual_shapes);
    for (const auto& joint : link.child_joints) VisitJoint(*joint, link.child_links, body, X_BL);
  }

  Pose Scaled(const urdf::Pose& pose) const {
    Pose X = FromUrdf(pose);
    X.translation() *= scale_;
    return X;
  }

  /// Adds a link to a body, with the inertia of its shapes for a placeholder, and a repaired inertia if not physical.
  void AddLink(const urdf::Link& link, const Pose& X_BL, Body& body) {
    const urdf::Inertial& inertial = *link.inertial;
    const Pose X_LI = Scaled(inertial.origin), X_BI = X_BL * X_LI;
    const Matrix3 given = X_LI.linear() * TensorOf(inertial) * X_LI.linear().transpose();
    std::vector<const Shape*> shapes = ShapesOf(collision_, link.name);
    if (shapes.empty()) shapes = ShapesOf(visual_, link.name);
    Matrix3 I = given;
    if (const auto solid = placeholder_inertias_ ? SolidInertia(shapes, inertial.mass) : std::nullopt) {
      I = *solid;
      used_.push_back({link.name, I});
      model_.findings.push_back(
          {FindingLevel::kWarning, FailureCode::kPlaceholderInertia, RobotPart{PartKind::kLink, link.name}, 0,
           "its inertia equals that of all links, which is a placeholder; the inertia of its shapes is used"});
    } else if (auto mended = Mended(link, given, X_LI.translation(), shapes)) {
      I = mended->I;
      if (!mended->was.empty()) used_.push_back({link.name, I});
      mended_.push_back({link.name, std::move(*mended), I - given});
    }
    AddInertia(body, inertial.mass, X_BI.translation(), X_BL.linear() * I * X_BL.linear().transpose());
  }

  /// Replacement of an inertia that is not physical or too large for the link; nothing for a plausible inertia.
  std::optional<MendedInertia> Mended(const urdf::Link& link, const Matrix3& given, const Vector3& centre,
                                      const std::vector<const Shape*>& shapes) const {
    constexpr double kOfNoWeight = 1e-3;  // share of the robot's mass, as of an inertial unit
    const double mass = link.inertial->mass;
    auto mended = MendInertia(given, mass, shapes);
    if (mass < kOfNoWeight * total_mass_ || incomplete_.contains(link.name)) return mended;
    std::vector<const Shape*> known = ShapesOf(collision_, link.name);
    for (const Shape* shape : ShapesOf(visual_, link.name)) known.push_back(shape);
    std::vector<Vector3> points = {Vector3::Zero(), centre};
    for (const auto& joint : link.child_joints)
      points.push_back(Scaled(joint->parent_to_joint_origin_transform).translation());
    const Matrix3& I = mended ? mended->I : given;
    if (auto sized = MendOversizedInertia(I, mass, LinkExtent(known, points) / scale_, shapes)) return sized;
    return mended;
  }

  /// Largest moment of the whole robot about its centre of mass at joint positions zero [kg m^2].
  double RobotMoment() const {
    const std::vector<Pose> X_OB = BodyPoses(model_, VectorX::Zero(model_.num_dofs()));
    Body whole;
    for (std::size_t b = 0; b < X_OB.size(); ++b) {
      const Body& body = model_.bodies[b];
      AddInertia(whole, body.mass, X_OB[b] * body.p_BC, X_OB[b].linear() * body.I_C * X_OB[b].linear().transpose());
    }
    return LargestMoment(whole.I_C);
  }

  /// Adds a finding for each link whose inertia is repaired, except for changes that are negligible for the robot.
  void ReportMendedInertias() {
    constexpr double kOfNoAccount = 1e-6;  // share of the robot's inertia
    if (mended_.empty()) return;
    const double whole = RobotMoment();
    for (const MendedLink& mended : mended_) {
      const double share = LargestMoment(mended.change) / std::max(whole, 1e-12);
      if (mended.by.was.empty() || share < kOfNoAccount) continue;
      const Vector3 moments = PrincipalMoments(mended.by.I);
      const std::string change = share < 1.0 ? fmt::format("a change of {:.2g} % of the robot's inertia", 100.0 * share)
                                             : fmt::format("and the whole robot then has {:.4g} kg m^2", whole);
      model_.findings.push_back(
          {FindingLevel::kWarning, FailureCode::kImpossibleInertia, RobotPart{PartKind::kLink, mended.link}, 0,
           fmt::format("its inertia {}; {} is used, with the principal moments {:.4g}, {:.4g} and {:.4g} kg m^2, {}",
                       mended.by.was, mended.by.used, moments[0], moments[1], moments[2], change)});
    }
  }

  static std::vector<const Shape*> ShapesOf(const std::vector<Shape>& all, const std::string& link) {
    std::vector<const Shape*> shapes;
    for (const Shape& shape : all) {
      if (shape.link == link) shapes.push_back(&shape);
    }
    return shapes;
  }

  /// Adds the shapes of a link, with poses in the frame of its body.
  static void AddShapes(const std::vector<Shape>& from, const std::string& link, int body, const Pose& X_BL,
                        std::vector<Shape>& to) {
    for (const Shape& shape : from) {
      if (shape.link != link) continue;
      to.push_back(shape);
      to.back().body = body;
      to.back().X_BS = X_BL * shape.X_BS;
    }
  }

  void VisitJoint(const urdf::Joint& joint, const std::vector<urdf::LinkSharedPtr>& children, int body,
                  const Pose& X_BL) {
    const auto child = std::find_if(children.begin(), children.end(),
                                    [&](const auto& link) { return link->name == joint.child_link_name; });
    const Pose X_PJ = X_BL * Scaled(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::FIXED) {
      VisitLink(**child, body, X_PJ);
      return;
    }
    Joint made;
    made.name = joint.name;
    made.parent_body = body;
    made.X_PJ = X_PJ;
    made.axis_J = Vector3(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
    made.type = joint.type == urdf::Joint::PRISMATIC    ? JointType::kPrismatic
                : joint.type == urdf::Joint::CONTINUOUS ? JointType::kContinuous
                                                        : JointType::kRevolute;
    SetLimits(joint, made);
    if (joint.mimic) {
      made.is_mimic = true;
      made.multiplier = joint.mimic->multiplier;
      made.offset = joint.mimic->offset;
      leader_[model_.joints.size()] = joint.mimic->joint_name;
    }
    model_.joints.push_back(made);
    model_.bodies.emplace_back();
    heaviest_.push_back(-1.0);
    VisitLink(**child, static_cast<int>(model_.joints.size()), Pose::Identity());
  }

  void SetLimits(const urdf::Joint& joint, Joint& made) const {
    constexpr double kPlaceholder = 1000.0;  // N m, rad/s: more than any joint of a leg has
    made.lower = -std::numeric_limits<double>::infinity();
    made.upper = std::numeric_limits<double>::infinity();
    if (joint.limits) {
      if (joint.type != urdf::Joint::CONTINUOUS) {
        const double unit = joint.type == urdf::Joint::PRISMATIC ? scale_ : 1.0;
        made.lower = unit * joint.limits->lower;
        made.upper = unit * joint.limits->upper;
      }
      made.velocity_limit = joint.limits->velocity;
      made.effort_limit = joint.limits->effort;
    }
    made.effort_limit_is_placeholder = made.effort_limit <= 0.0 || made.effort_limit >= kPlaceholder;
    // If the author of the file did not know the effort, the speed is a placeholder too.
    made.velocity_limit_is_placeholder =
        made.effort_limit_is_placeholder || made.velocity_limit <= 0.0 || made.velocity_limit >= kPlaceholder;
    if (joint.dynamics) {
      made.damping = joint.dynamics->damping;
      made.friction = joint.dynamics->friction;
    }
  }

  /// Gives each joint a coordinate. A mimic joint, also in a chain, gets the coordinate of the leading joint.
  void AssignCoordinates() {
    std::map<std::string, std::size_t> index;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      index[model_.joints[j].name] = j;
      if (model_.joints[j].is_mimic) continue;
      model_.joints[j].dof = model_.num_dofs();
      model_.dof_names.push_back(model_.joints[j].name);
      model_.dof_joint.push_back(static_cast<int>(j));
    }
    const std::vector<Joint> written = model_.joints;
    for (const auto& [follower, first] : leader_) {
      Joint& joint = model_.joints[follower];
      std::size_t lead = index.at(first);
      for (; written[lead].is_mimic; lead = index.at(leader_.at(lead))) {
        joint.offset += joint.multiplier * written[lead].offset;
        joint.multiplier *= written[lead].multiplier;
      }
      joint.dof = written[lead].dof;
    }
  }

  struct MendedLink {
    std::string link;
    MendedInertia by;
    Matrix3 change;
  };

  const std::vector<Shape>&collision_, &visual_;
  const std::set<std::string>& incomplete_;
  const double scale_, total_mass_;
  std::vector<MendedLink> mended_;
  std::vector<LinkInertia> used_;
  const bool placeholder_inertias_;
  RobotModel model_;
  std::vector<double> heaviest_;
  std::map<std::size_t, std::string> leader_;
};

Failure RefusedModel(FailureCode code, std::string message, std::vector<Suggestion> suggestions = {},
                     std::optional<RobotPart> part = {}) {
  return {FailureKind::kBadInput, code, "LoadRobot", std::move(message), std::move(suggestions), {}, std::move(part)};
}

/// The failure of a strict reader if an inertia was replaced.
std::optional<Failure> RefusedInertia(const RobotModel& model) {
  for (const Finding& finding : model.findings) {
    if (finding.code != FailureCode::kImpossibleInertia && finding.code != FailureCode::kPlaceholderInertia) continue;
    return RefusedModel(finding.code, PartText(finding.part) + ": " + finding.message, {}, finding.part);
  }
  return std::nullopt;
}

/// Checks multiplier and offset of mimic joints. Each link of a chain may be plausible and the product not.
std::optional<Failure> CheckFollowers(const RobotModel& model) {
  constexpr double kLeast = 1e-6, kMost = 1e6;
  for (const Joint& joint : model.joints) {
    const double gear = std::abs(joint.multiplier);
    if (gear >= kLeast && gear <= kMost && std::abs(joint.offset) <= kMost) continue;
    return RefusedModel(
        FailureCode::kBadMimic,
        fmt::format("joint '{}' follows '{}' with multiplier {} and offset {}; accepted: magnitudes of {} to {} for "
                    "the multiplier and up to {} for the offset",
                    joint.name, model.dof_names[static_cast<std::size_t>(joint.dof)], joint.multiplier, joint.offset,
                    kLeast, kMost, kMost),
        {}, RobotPart{PartKind::kJoint, joint.name});
  }
  return std::nullopt;
}

/// Collects the messages of urdfdom, which would otherwise go to standard error.
class Listener : public console_bridge::OutputHandler {
 public:
  Listener() : previous_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~Listener() override { console_bridge::useOutputHandler(previous_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/, int /*line*/) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    said_ += (said_.empty() ? "" : "; ") + text;
  }
  const std::string& said() const { return said_; }

 private:
  console_bridge::OutputHandler* previous_;
  std::string said_;
};

urdf::ModelInterfaceSharedPtr ParseTree(const std::string& tree_text, std::string& reason) {
  static std::mutex one_at_a_time;  // the program has only one handler of messages
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  const Listener listener;
  urdf::ModelInterfaceSharedPtr urdf;
  try {
    urdf = urdf::parseURDF(tree_text);
    reason = listener.said();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (reason.empty()) reason = "urdfdom reported no reason";
  return urdf;
}

}  // namespace

Result<RobotModel> BuildModel(const UrdfParts& parts, const std::string& name, double scale, bool strict) {
  std::string reason;
  const urdf::ModelInterfaceSharedPtr urdf = ParseTree(parts.tree_text, reason);
  if (!urdf || !urdf->getRoot()) {
    return RefusedModel(FailureCode::kNotUrdf, fmt::format("the URDF of '{}' cannot be read: {}", name, reason));
  }
  RobotModel model = Builder(*urdf, parts, name, scale).Take();
  if (!(model.total_mass_kg >= kLightestRobot)) {
    return RefusedModel(FailureCode::kNoMass,
                        fmt::format("robot '{}': its {} links have a total mass of {} kg; {} kg or more is needed",
                                    name, model.frames.size(), model.total_mass_kg, kLightestRobot),
                        {"give its links an <inertial>"});
  }
  if (auto failure = strict ? RefusedInertia(model) : std::nullopt) return *failure;
  if (auto failure = CheckFollowers(model)) return *failure;
  const std::vector<std::string> idle = IdleJoints(model);
  if (idle.empty()) return model;
  if (strict) {
    return RefusedModel(
        FailureCode::kNoInertia,
        fmt::format("joint '{}' moves nothing: the links beyond it have no inertia about its axis", idle.front()),
        {"give a link beyond it an <inertial>, or make the joint fixed"}, RobotPart{PartKind::kJoint, idle.front()});
  }
  const std::vector<std::string> fixed = FixJoints(*urdf, idle);
  model = Builder(*urdf, parts, name, scale).Take();
  for (const std::string& joint : fixed) {
    model.findings.push_back(
        {FindingLevel::kWarning, FailureCode::kNoInertia, RobotPart{PartKind::kJoint, joint}, 0,
         "it moves nothing, because the links beyond it have no inertia about its axis; it is fixed"});
  }
  return model;
}

std::vector<LinkInertia> InertiasUsed(const UrdfParts& parts, double scale) {
  std::string reason;
  const urdf::ModelInterfaceSharedPtr urdf = ParseTree(parts.tree_text, reason);
  if (!urdf || !urdf->getRoot()) return {};
  return Builder(*urdf, parts, "", scale).TakeUsedInertias();
}

}  // namespace gaitwright
