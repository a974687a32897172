// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/rigid_body_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

constexpr char kAxes[] = "xyz";

std::string Numbers(const Vector3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

std::string Inertial(double mass_kg, const Matrix3& I) {
  return fmt::format(
      "<inertial><mass value=\"{}\"/><inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>"
      "</inertial>",
      mass_kg, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2));
}

std::string Axis(int axis) { return Numbers(Vector3::Unit(axis)); }

/// A chain of joints from the trunk to a foot.
class Chain {
 public:
  explicit Chain(std::string foot) : foot_(std::move(foot)) {}

  void Slide(int axis, const Vector3& origin, double lower, double upper) {
    Add("prismatic", fmt::format("{}_{}", foot_, kAxes[axis]), axis, origin, lower, upper);
  }
  void Turn(int axis) {
    constexpr double kAnywhere = 6.3;  // [rad], more than a full turn
    Add("revolute", fmt::format("{}_turn_{}", foot_, kAxes[axis]), axis, Vector3::Zero(), -kAnywhere, kAnywhere);
  }
  /// URDF text of the chain's links and joints; the last link is the foot.
  std::string Text() const {
    // Effects of such a light link are negligible; its inertia is that of a ball with a radius of 0.1 m.
    std::string text;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const bool last = i + 1 == joints_.size();
      const std::string link = last ? foot_ : joints_[i].name + "_link";
      const std::string parent = i == 0 ? "trunk" : joints_[i - 1].name + "_link";
      text += last ? fmt::format("  <link name=\"{}\">{}</link>\n", link,
                                 Inertial(kSlideFoot, 0.01 * kSlideFoot * Matrix3::Identity()))
                   : fmt::format("  <link name=\"{}\"/>\n", link);
      text += joints_[i].Text(parent, link);
    }
    return text;
  }

 private:
  struct Part {
    std::string type, name, origin, axis;
    double lower, upper;

    /// The effective effort limits are in the yaml; speeds have no limit.
    std::string Text(const std::string& parent, const std::string& child) const {
      return fmt::format(
          "  <joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/><origin xyz=\"{}\"/>"
          "<axis xyz=\"{}\"/><limit lower=\"{}\" upper=\"{}\" effort=\"0\" velocity=\"0\"/></joint>\n",
          name, type, parent, child, origin, axis, lower, upper);
    }
  };
  void Add(const char* type, const std::string& name, int axis, const Vector3& origin, double lower, double upper) {
    joints_.push_back({type, name, Numbers(origin), Axis(axis), lower, upper});
  }

  std::string foot_;
  std::vector<Part> joints_;
};

bool IsSole(const RigidFoot& foot) {
  const std::size_t points = foot.contacts_F.size();
  for (const Vector3& p : foot.contacts_F) {
    if (points == 1 ? p.isZero() : p.z() == 0.0) continue;
    throw InvalidArgument("rigid body's robot: a foot's points of contact are not in the plane of its frame");
  }
  if (points == 2) throw InvalidArgument("rigid body's robot: a foot has two contact points; one or three are needed");
  return points > 2;
}

Chain ChainOf(const RigidFoot& foot, const std::string& name) {
  const auto [low_B, high_B] = BoxOf(foot.workspace_B);
  const Vector3& at_B = foot.p_CF_nominal_B;
  const Vector3 lower = low_B - at_B, upper = high_B - at_B;
  Chain chain(name);
  chain.Slide(0, {at_B.x(), at_B.y(), 0.0}, lower.x(), upper.x());
  chain.Slide(1, Vector3::Zero(), lower.y(), upper.y());
  chain.Slide(2, {0.0, 0.0, at_B.z()}, lower.z(), upper.z());
  if (IsSole(foot)) {
    for (const int axis : {2, 1, 0}) chain.Turn(axis);
  }
  return chain;
}

std::string FootYaml(const RigidFoot& foot, const std::string& name) {
  if (!IsSole(foot)) return fmt::format("  - {{link: {}, type: point}}\n", name);
  std::string corners;
  for (const Vector3& p : foot.contacts_F)
    corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", p.x(), p.y());
  return fmt::format("  - {{link: {}, type: sole, sole_m: [{}]}}\n", name, corners);
}

/// Name of the link of a problem's foot.
std::string FootLink(std::size_t foot) { return fmt::format("foot_{}", foot); }

/// The largest friction coefficient of all stances of a foot.
double FrictionOf(const RigidBodyProblem& problem, int foot) {
  double friction = 0.0;
  for (const RigidStance& stance : problem.stances) {
    if (stance.foot == foot) friction = std::max(friction, stance.friction);
  }
  return friction;
}

}  // namespace

std::pair<Vector3, Vector3> BoxOf(const std::vector<WorkspaceSide>& workspace_B) {
  Vector3 low = Vector3::Constant(-kInfinity), high = -low;
  for (const WorkspaceSide& side : workspace_B) {
    Eigen::Index axis = 0;
    const double length = side.normal.norm(), along = side.normal.cwiseAbs().maxCoeff(&axis);
    if (!(along > (1.0 - 1e-12) * length))
      throw InvalidArgument("rigid body's robot: a foot's workspace is not a box along the body's axes");
    double& limit = side.normal[axis] > 0.0 ? high[axis] : low[axis];
    const double at = side.offset / side.normal[axis];
    limit = side.normal[axis] > 0.0 ? std::min(limit, at) : std::max(limit, at);
  }
  if (!low.allFinite() || !high.allFinite())
    throw InvalidArgument("rigid body's robot: a foot's workspace is unbounded");
  return {low, high};
}

std::vector<int> ProblemFeetOf(const RobotModel& robot, const RigidBodyProblem& problem) {
  if (robot.feet.size() != problem.feet.size())
    throw InvalidArgument(fmt::format("rigid body's robot: '{}' has {} feet, but the problem has {}", robot.name,
                                      robot.feet.size(), problem.feet.size()));
  std::vector<int> feet(robot.feet.size(), -1);
  for (std::size_t f = 0; f < problem.feet.size(); ++f) {
    const auto foot =
        std::find_if(robot.feet.begin(), robot.feet.end(), [&](const Foot& of) { return of.link == FootLink(f); });
    if (foot == robot.feet.end())
      throw InvalidArgument(fmt::format("rigid body's robot: '{}' has no foot '{}'", robot.name, FootLink(f)));
    feet[static_cast<std::size_t>(foot - robot.feet.begin())] = static_cast<int>(f);
  }
  return feet;
}

RigidBodyTexts RigidBodyTextsOf(const RigidBodyProblem& problem, const std::string& name) {
  const double trunk_kg = problem.mass_kg - kSlideFoot * static_cast<double>(problem.feet.size());
  RigidBodyTexts texts;
  texts.urdf = fmt::format("<robot name=\"{}\">\n  <link name=\"trunk\">{}</link>\n", name,
                           Inertial(trunk_kg, problem.inertia_B));
  texts.yaml = fmt::format("name: {}\nnominal_speed_m_s: 1.0\nfeet:\n", name);
  std::string limits, standing;
  for (std::size_t f = 0; f < problem.feet.size(); ++f) {
    const RigidFoot& foot = problem.feet[f];
    const std::string link = FootLink(f);
    texts.urdf += ChainOf(foot, link).Text();
    texts.yaml += FootYaml(foot, link);
    const double friction = FrictionOf(problem, static_cast<int>(f));
    const double most_n =
        foot.force_max_n * static_cast<double>(foot.contacts_F.size()) * std::sqrt(1.0 + friction * friction);
    for (int axis = 0; axis < 3; ++axis) {
      limits += fmt::format("  {}_{}: {{effort_n: {}}}\n", link, kAxes[axis], most_n);
      standing += fmt::format("  {}_{}: 0\n", link, kAxes[axis]);
    }
  }
  texts.urdf += "</robot>\n";
  texts.yaml += "limits:\n" + limits + "standing:\n" + standing;
  return texts;
}

Result<RobotModel> RigidBodyRobot(const RigidBodyProblem& problem, const std::string& name) {
  const RigidBodyTexts texts = RigidBodyTextsOf(problem, name);
  return LoadRobotFromText(texts.urdf, texts.yaml, name);
}

}  // namespace gaitwright
