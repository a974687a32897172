// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "kinematics/base/nearest_name.h"
#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kMostMjcfBodies = 1000, kMostMjcfJoints = 2000;

const std::set<std::string> kMjcfPassedOver = {"site", "camera", "light"};
const std::set<std::string> kMjcfRefused = {"replicate", "attach", "composite", "flexcomp"};

/// Visits the bodies of a model, depth first.
class MjcfTreeReader {
 public:
  explicit MjcfTreeReader(MjcfContext& context) : context_(context) {}

  MjcfTree Read() {
    for (const XMLElement* section : context_.document.Sections("worldbody"))
      ReadContents({section, Pose::Identity(), ""}, -1);
    return std::move(tree_);
  }

 private:
  /// Reads the elements in a body, in one of its frames or in the world.
  void ReadContents(const MjcfPart& around, int body) {
    for (const XMLElement* child : context_.document.Children(*around.element)) {
      const std::string tag = child->Name();
      if (const char* name = child->Attribute("name"); tag == "site" && name != nullptr)
        tree_.body_of_site[name] = body;
      if (tag == "body") {
        ReadBody({child, around.X_BF, around.childclass}, body);
      } else if (tag == "frame") {
        ReadFrame(*child, around, body);
      } else if (kMjcfRefused.contains(tag)) {
        Refuse(*child, tag, body);
      } else if (body < 0) {
        if (tag == "joint" || tag == "freejoint" || tag == "inertial")
          RefuseMjcf(FailureCode::kMjcfElement,
                     context_.document.Owner(*child) + ": the world cannot have a joint or an inertia");
      } else {
        ReadPart({child, around.X_BF, around.childclass}, tag, body);
      }
    }
  }

  void ReadFrame(const XMLElement& frame, const MjcfPart& around, int body) {
    const MjcfAttributes attributes = context_.defaults.Of(frame, "frame");
    ReadContents({&frame, around.X_BF * MjcfPose(attributes, context_.compiler),
                  context_.defaults.ChildClass(frame, around.childclass)},
                 body);
  }

  void ReadBody(const MjcfPart& part, int parent) {
    const MjcfAttributes attributes = context_.defaults.Of(*part.element, "body");
    if (tree_.bodies.size() >= kMostMjcfBodies)
      RefuseMjcf(FailureCode::kLargeMjcf, fmt::format("{0}: the model has over {1} bodies; at most {1} are read",
                                                      attributes.owner(), kMostMjcfBodies));
    MjcfBody body;
    body.owner = attributes.owner();
    body.name = attributes.Name("name");
    body.parent = parent;
    body.is_mocap = attributes.Flag("mocap", false);
    body.X_PB = part.X_BF * MjcfPose(attributes, context_.compiler);
    const int index = static_cast<int>(tree_.bodies.size());
    if (body.name == "world" || (!body.name.empty() && !tree_.body_named.emplace(body.name, index).second))
      RefuseMjcf(FailureCode::kDoubleName, fmt::format("{}: two bodies have this name", body.owner));
    if (attributes.Number("gravcomp", 0.0) != 0.0)
      context_.Note(body.owner, "'gravcomp' is ignored: gravity acts fully on the body");
    tree_.bodies.push_back(std::move(body));
    ReadContents({part.element, Pose::Identity(), context_.defaults.ChildClass(*part.element, part.childclass)}, index);
  }

  void ReadPart(const MjcfPart& part, const std::string& tag, int body) {
    MjcfBody& of = tree_.bodies[static_cast<std::size_t>(body)];
    if (tag == "geom") {
      of.geoms.push_back(part);
    } else if (tag == "inertial") {
      if (of.inertial)
        RefuseMjcf(FailureCode::kMjcfElement, fmt::format("{}: it has two <inertial>; one is accepted", of.owner));
      of.inertial = part;
    } else if (tag == "joint" || tag == "freejoint") {
      AddJoint(ReadMjcfJoint(context_, part), body);
    } else if (!kMjcfPassedOver.contains(tag)) {
      context_.Note(context_.document.Owner(*part.element), "an unsupported element is left out");
    }
  }

  void AddJoint(MjcfJoint joint, int body) {
    MjcfBody& of = tree_.bodies[static_cast<std::size_t>(body)];
    if (joint.type == MjcfJointType::kFree && of.parent >= 0)
      RefuseMjcf(FailureCode::kMjcfJoint,
                 fmt::format("{}: body '{}' has a free joint; only a body directly in the world may have one",
                             joint.owner, ShownMjcf(of.name)));
    if (tree_.joints.size() >= kMostMjcfJoints)
      RefuseMjcf(FailureCode::kLargeMjcf,
                 fmt::format("{0}: the model has over {1} joints; at most {1} are read", joint.owner, kMostMjcfJoints));
    const int index = static_cast<int>(tree_.joints.size());
    if (!joint.name.empty() && !tree_.joint_named.emplace(joint.name, index).second)
      RefuseMjcf(FailureCode::kDoubleName, fmt::format("{}: two joints have this name", joint.owner));
    of.joints.push_back(index);
    tree_.body_of.push_back(body);
    tree_.joints.push_back(std::move(joint));
  }

  /// Refuses elements that generate others. Such elements outside the robot are left out with a note.
  void Refuse(const XMLElement& element, const std::string& tag, int body) {
    const std::string owner = context_.document.Owner(element);
    if (body < 0 && tag == "replicate" && !HasBody(element)) {
      context_.Note(owner, "it is not part of the robot; it is left out");
      return;
    }
    RefuseMjcf(FailureCode::kMjcfElement,
               fmt::format(
                   "{}: <{}> is not supported; save the model with MuJoCo, which replaces it by the generated elements",
                   owner, tag));
  }

  bool HasBody(const XMLElement& element) const {
    const std::vector<const XMLElement*> children = context_.document.Children(element);
    return std::any_of(children.begin(), children.end(), [&](const XMLElement* child) {
      const std::string tag = child->Name();
      return tag == "body" || kMjcfRefused.contains(tag) || (tag == "frame" && HasBody(*child));
    });
  }

  MjcfContext& context_;
  MjcfTree tree_;
};

/// Gives a name to items without one: `stem`, or `stem` with a number.
template <class Named>
void NameMjcf(std::vector<Named>& all, std::size_t i, const std::string& stem, std::map<std::string, int>& taken) {
  if (!all[i].name.empty()) return;
  std::string name = stem;
  for (int n = 2; !taken.emplace(name, static_cast<int>(i)).second; ++n) name = fmt::format("{}_{}", stem, n);
  all[i].name = name;
}

/// Chooses the tree with the most bodies; if several have the same number, the first one.
void ChooseMjcfRobot(MjcfContext& context, MjcfTree& tree) {
  std::vector<int> root(tree.bodies.size()), size(tree.bodies.size(), 0);
  for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
    const int parent = tree.bodies[b].parent;
    root[b] = parent < 0 ? static_cast<int>(b) : root[static_cast<std::size_t>(parent)];
    ++size[static_cast<std::size_t>(root[b])];
  }
  if (tree.bodies.empty())
    RefuseMjcf(FailureCode::kMjcfBodies, fmt::format("{}: the model has no body: its <worldbody> contains no robot",
                                                     context.document.Owner(context.document.root())));
  tree.root = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  for (std::size_t b = 0; b < tree.bodies.size(); ++b) {
    tree.in_robot.push_back(root[b] == tree.root);
    if (tree.bodies[b].parent < 0 && root[b] != tree.root)
      context.Note(
          tree.bodies[b].owner,
          fmt::format(
              "it is not part of the robot, whose first body is '{}'; it is left out with its children and actuators",
              tree.bodies[static_cast<std::size_t>(tree.root)].name));
  }
}

/// Adds notes about joints between the robot's first body and the world: the first body always floats freely.
void NoteMjcfBase(MjcfContext& context, const MjcfTree& tree) {
  const MjcfBody& base = tree.bodies[static_cast<std::size_t>(tree.root)];
  bool is_free = false;
  for (const int j : base.joints) {
    const MjcfJoint& joint = tree.joints[static_cast<std::size_t>(j)];
    is_free = is_free || joint.type == MjcfJointType::kFree;
    if (joint.type != MjcfJointType::kFree)
      context.Note(joint.owner,
                   "it joins the robot's first body to the world; it is left out, because the base floats freely");
  }
  if (is_free && base.joints.size() > 1)
    RefuseMjcf(FailureCode::kMjcfJoint,
               fmt::format("{}: it has a free joint as well as other joints; remove the other joints", base.owner));
  if (base.joints.empty())
    context.Note(base.owner, "it has no free joint, so MuJoCo fixes it to the world; here it is a floating base");
}

}  // namespace

std::size_t MjcfJoint::num_positions() const {
  return type == MjcfJointType::kFree ? 7U : type == MjcfJointType::kBall ? 4U : 1U;
}

bool MjcfTree::IsRobotJoint(int joint) const {
  return in_robot[static_cast<std::size_t>(body_of[static_cast<std::size_t>(joint)])];
}

bool MjcfTree::Moves(int joint) const {
  return IsRobotJoint(joint) && body_of[static_cast<std::size_t>(joint)] != root;
}

MjcfTree ReadMjcfTree(MjcfContext& context) {
  MjcfTree tree = MjcfTreeReader(context).Read();
  for (std::size_t b = 0; b < tree.bodies.size(); ++b)
    NameMjcf(tree.bodies, b, fmt::format("body_{}", b + 1), tree.body_named);
  for (std::size_t j = 0; j < tree.joints.size(); ++j)
    NameMjcf(tree.joints, j, tree.bodies[static_cast<std::size_t>(tree.body_of[j])].name + "_joint", tree.joint_named);
  ChooseMjcfRobot(context, tree);
  NoteMjcfBase(context, tree);
  return tree;
}

}  // namespace gaitwright
