// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/ik/leg_chain.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

constexpr double kFromLimits = 0.05;  // least distance of a drawn joint from its limits, as a share of its range
constexpr int kFree = 6;              // number of joints with which a leg can set position and orientation of its foot

LegChain ChainOf(const QuestionContext& context, const Values& in) {
  return {*context.model, static_cast<int>(in[0].number())};
}

/// Draws a leg; the input gets its number and name.
LegChain DrawLeg(const QuestionContext& context, SplitMix& random, Values& in) {
  const int legs = static_cast<int>(context.model->legs.size());
  in[0].numbers = {std::min(std::floor(random.Uniform() * legs), legs - 1.0)};
  LegChain chain = ChainOf(context, in);
  in[0].word = chain.foot_name;
  return chain;
}

/// Draws joint positions within their limits.
VectorX DrawJoints(const LegChain& chain, SplitMix& random) {
  VectorX joints(chain.num_coordinates());
  for (int i = 0; i < joints.size(); ++i) {
    const double low = std::max(chain.lower[i], -M_PI), high = std::min(chain.upper[i], M_PI);
    joints[i] = low + (high - low) * (kFromLimits + (1.0 - 2.0 * kFromLimits) * random.Uniform());
  }
  return joints;
}

void Copy(const VectorX& joints, QuestionValue& value) {
  value.shape = {static_cast<int>(joints.size())};
  value.numbers.assign(joints.data(), joints.data() + joints.size());
}

void AskForward(const QuestionContext& context, SplitMix& random, Values& in) {
  const LegChain chain = DrawLeg(context, random, in);
  Copy(DrawJoints(chain, random), in[1]);
}

std::vector<double> ForwardAnswer(const QuestionContext& context, const Values& in) {
  const LegChain chain = ChainOf(context, in);
  const Vector3 p = chain.FootPose(Eigen::Map<const VectorX>(in[1].numbers.data(), in[1].shape[0])).translation();
  return {p.x(), p.y(), p.z()};
}

/// Sets a foot pose within reach; without rotation for legs that cannot set every orientation.
void AskInverse(const QuestionContext& context, SplitMix& random, Values& in) {
  const LegChain chain = DrawLeg(context, random, in);
  const Pose pose = chain.FootPose(DrawJoints(chain, random));
  const Vector3 p = pose.translation();
  in[1].numbers = {p.x(), p.y(), p.z()};
  if (chain.num_coordinates() < kFree) {
    in.pop_back();
    return;
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      in[2].numbers[static_cast<std::size_t>(3 * row + column)] = pose.linear()(row, column);
  }
}

double LargestLimitViolation(const LegChain& chain, const VectorX& joints) {
  double violation = 0.0;
  for (int i = 0; i < joints.size(); ++i)
    violation = std::max({violation, joints[i] - chain.upper[i], chain.lower[i] - joints[i]});
  return violation;
}

/// Error of the foot pose for the answered joints; every solution of the leg is accepted.
double InverseError(const QuestionContext& context, const Values& in, const QuestionValue& answer) {
  const LegChain chain = ChainOf(context, in);
  RequireShape(answer, {chain.num_coordinates()});
  const VectorX joints = Eigen::Map<const VectorX>(answer.numbers.data(), chain.num_coordinates());
  if (joints.cwiseAbs().maxCoeff() > 100.0) throw InvalidArgument("the answer has a joint beyond 100 rad");
  const Pose pose = chain.FootPose(joints);
  double error = (pose.translation() - in[1].Vec3()).norm();
  if (in.size() > 2) {
    const Matrix3 wanted = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(in[2].numbers.data());
    error += Eigen::AngleAxisd(Matrix3(wanted.transpose() * pose.linear())).angle();
  }
  return std::max(error, LargestLimitViolation(chain, joints));
}

}  // namespace

std::vector<Question> LegQuestions() {
  const QuestionInput leg{"leg", {}, {0.0, 0.0}};
  Question forward{"leg_fk",
                   "position of a leg's foot in the base frame",
                   {leg, {"joints_rad", {kLegJoints}, {0.0, 0.0}}},
                   "3 numbers"};
  forward.needs_robot = true;
  forward.settle = AskForward;
  Question inverse{"leg_ik",
                   "joints that bring a foot there, within their limits",
                   {leg, {"foot_m", {3}, {0.0, 0.0}}, {"rotation", {3, 3}, {0.0, 0.0}}},
                   "as many numbers as joints"};
  inverse.needs_robot = true;
  inverse.settle = AskInverse;
  inverse.shape = [](const QuestionContext& context, const Values& in) {
    return std::vector<int>{ChainOf(context, in).num_coordinates()};
  };
  inverse.error = InverseError;
  inverse.off_by = "error of the foot's pose in metres and radians; beyond a joint's limit, the excess";
  return {Compared(forward, {3}, ForwardAnswer), inverse};
}

}  // namespace gaitwright
