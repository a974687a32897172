// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {
namespace {

/// A number that is not negative. Of several numbers, which are the coefficients of a polynomial, only the first is
/// used.
double MjcfLoss(MjcfContext& context, const MjcfAttributes& attributes, const std::string& key) {
  constexpr std::size_t kMostCoefficients = 8;
  const std::vector<double> numbers = attributes.Numbers(key, 1, kMostCoefficients);
  if (numbers.empty()) return 0.0;
  if (numbers.front() < 0.0)
    RefuseMjcf(FailureCode::kMjcfJoint,
               fmt::format("{}: its {} is {}; zero or more is accepted", attributes.owner(), key, numbers.front()));
  if (numbers.size() > 1) context.Note(attributes.owner(), fmt::format("only the first number of '{}' is used", key));
  return numbers.front();
}

void ReadMjcfRange(MjcfContext& context, const MjcfAttributes& attributes, MjcfJoint& joint) {
  const bool autolimits = context.compiler.autolimits;
  const double unit = joint.type == MjcfJointType::kSlide ? 1.0 : context.compiler.Radians(1.0);
  if (attributes.IsLimited("limited", "range", autolimits)) {
    const std::vector<double> ends = attributes.Numbers("range", 2, 2);
    if (joint.is_scalar())
      joint.range = {unit * ends[0], unit * ends[1]};
    else
      context.Note(attributes.owner(), "the range of a ball joint is ignored; the joint has no limits");
  } else if (attributes.Has("range") && !autolimits && !attributes.Has("limited")) {
    context.Note(attributes.owner(),
                 "its range is ignored: <compiler> has autolimits=\"false\", and the joint has no 'limited'");
  }
  if (!attributes.IsLimited("actuatorfrclimited", "actuatorfrcrange", autolimits)) return;
  joint.force_limit = MjcfEitherSide(context, attributes, "actuatorfrcrange");
}

/// Adds notes for springs and other data that the robot model cannot contain.
void NoteMjcfSprings(MjcfContext& context, const MjcfAttributes& attributes) {
  if (const double stiffness = MjcfLoss(context, attributes, "stiffness"); stiffness > 0.0)
    context.Note(attributes.owner(), fmt::format("its spring of stiffness {} is ignored", stiffness));
  if (const auto spring = attributes.Numbers("springdamper", 2, 2); !spring.empty() && spring[0] > 0.0)
    context.Note(attributes.owner(), "'springdamper' is ignored, with its spring and damping");
}

}  // namespace

double MjcfEitherSide(MjcfContext& context, const MjcfAttributes& attributes, const std::string& key) {
  const std::vector<double> ends = attributes.Numbers(key, 2, 2);
  const double smaller = std::min(std::abs(ends[0]), std::abs(ends[1]));
  const double bound = smaller > 0.0 ? smaller : std::max(std::abs(ends[0]), std::abs(ends[1]));
  if (ends[0] != -ends[1])
    context.Note(attributes.owner(), fmt::format("'{}' is '{}', whose two sides differ in size; {} is used for both",
                                                 key, attributes.Text(key), bound));
  return bound;
}

MjcfJoint ReadMjcfJoint(MjcfContext& context, const MjcfPart& part) {
  const bool is_free = std::string_view(part.element->Name()) == "freejoint";
  const MjcfAttributes attributes = context.defaults.Of(*part.element, is_free ? "" : "joint", part.childclass);
  MjcfJoint joint;
  joint.owner = attributes.owner();
  joint.name = attributes.Name("name");
  const std::string type = is_free ? "free" : attributes.Choice("type", {"free", "ball", "slide", "hinge"}, "hinge");
  joint.type = type == "free"    ? MjcfJointType::kFree
               : type == "ball"  ? MjcfJointType::kBall
               : type == "slide" ? MjcfJointType::kSlide
                                 : MjcfJointType::kHinge;
  if (joint.type == MjcfJointType::kFree) return joint;
  joint.pos = part.X_BF * attributes.Three("pos", Vector3::Zero());
  const Vector3 axis = attributes.Three("axis", Vector3::UnitZ());
  if (axis.norm() < 1e-9 && joint.is_scalar())
    RefuseMjcf(FailureCode::kZeroAxis, fmt::format("{}: its axis is zero", attributes.owner()));
  if (joint.is_scalar()) joint.axis = part.X_BF.linear() * axis.normalized();
  if (joint.type == MjcfJointType::kSlide) joint.ref = attributes.Number("ref", 0.0);
  if (joint.type == MjcfJointType::kHinge) joint.ref = context.compiler.Radians(attributes.Number("ref", 0.0));
  ReadMjcfRange(context, attributes, joint);
  joint.damping = MjcfLoss(context, attributes, "damping");
  joint.friction = MjcfLoss(context, attributes, "frictionloss");
  joint.armature = MjcfLoss(context, attributes, "armature");
  NoteMjcfSprings(context, attributes);
  return joint;
}

}  // namespace gaitwright
