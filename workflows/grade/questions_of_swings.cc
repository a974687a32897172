// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

constexpr int kSamples = 101;  // samples of a swing over a step
// Rules for a swing over a step: distance from its ends within which it may be lower [m], height that it may have above
// its clearance [m], and, as shares of its length, the longest motion in the first and last interval and in any
// interval.
constexpr double kNearEnds = 0.05, kNoHigher = 0.1, kAtRest = 1e-3, kNoJump = 0.05, kTouches = 1e-6;

std::vector<double> JerkAnswer(const QuestionContext&, const Values& in) {
  const Motion1 motion = SmoothStep(in[0].number());
  return {motion.value, motion.rate, motion.acceleration};
}

std::vector<double> SwingAnswer(const QuestionContext&, const Values& in) {
  SwingCurve curve;
  curve.X_WF_start.translation() = in[0].Vec3();
  curve.X_WF_end.translation() = in[1].Vec3();
  curve.lift_m = in[2].number();
  curve.end_s = in[3].number();
  const FrameMotion motion = Evaluate(curve, in[4].number());
  std::vector<double> numbers;
  for (const Vector3& row : {Vector3(motion.X_WF.translation()), motion.v_WF, motion.a_WF})
    numbers.insert(numbers.end(), {row.x(), row.y(), row.z()});
  return numbers;
}

/// Scales the drawn time to the duration of the swing.
void WithinDuration(const QuestionContext&, SplitMix&, Values& in) { in[4].numbers[0] *= in[3].number(); }

/// Puts an edge between the ends, which have different heights, and makes times uniform.
void MakeStep(const QuestionContext&, SplitMix& random, Values& in) {
  const Vector3 start = in[0].Vec3();
  const double length_m = 0.25 + 0.15 * random.Uniform();
  in[1].numbers = {start.x() + length_m, start.y() + 0.04 * (random.Uniform() - 0.5),
                   start.z() + 0.2 * (random.Uniform() - 0.5)};
  in[2].numbers = {start.x() + 0.08 + (length_m - 0.16) * random.Uniform()};
  for (int i = 0; i < kSamples; ++i) in[5].numbers[static_cast<std::size_t>(i)] = in[4].number() * i / (kSamples - 1.0);
}

/// Distance by which a point of a swing over a step is too low or too high.
double PlaceError(const Values& in, const Vector3& p) {
  const Vector3 start = in[0].Vec3(), end = in[1].Vec3();
  const double ground_m = p.x() < in[2].number() ? start.z() : end.z(), clearance_m = in[3].number();
  const bool near_end = p.x() < start.x() + kNearEnds || p.x() > end.x() - kNearEnds;
  const double least_m = ground_m + (near_end ? -kTouches : clearance_m);
  const double most_m = std::max(start.z(), end.z()) + clearance_m + kNoHigher;
  return std::max({0.0, least_m - p.z(), p.z() - most_m});
}

double StepError(const QuestionContext&, const Values& in, const QuestionValue& answer) {
  RequireShape(answer, {kSamples, 3});
  const Vector3 start = in[0].Vec3(), end = in[1].Vec3();
  const double length_m = (end - start).norm() + kNoHigher;
  double error = std::max((answer.Vec3(0) - start).norm(), (answer.Vec3(kSamples - 1) - end).norm());
  for (int i = 0; i < kSamples; ++i) {
    error = std::max(error, PlaceError(in, answer.Vec3(i)));
    if (i == 0) continue;
    const bool at_end = i == 1 || i == kSamples - 1;
    const double moved_m = (answer.Vec3(i) - answer.Vec3(i - 1)).norm();
    error = std::max(error, moved_m - (at_end ? kAtRest : kNoJump) * length_m);
  }
  return error;
}

}  // namespace

std::vector<Question> SwingQuestions() {
  Question swing{"swing",
                 "position, velocity and acceleration of a swing at a time",
                 {{"start_m", {3}, {-0.2, 0.2}},
                  {"end_m", {3}, {-0.2, 0.2}},
                  {"lift_m", {}, {0.03, 0.12}},
                  {"duration_s", {}, {0.2, 0.8}},
                  {"time_s", {}, {0.0, 1.0}}},
                 "3 x 3"};
  swing.settle = WithinDuration;
  Question over{"swing_over_step",
                "positions of your own swing over an edge of the ground",
                {{"start_m", {3}, {-0.2, 0.2}},
                 {"end_m", {3}, {0.0, 0.0}},
                 {"edge_x_m", {}, {0.0, 0.0}},
                 {"clearance_m", {}, {0.01, 0.03}},
                 {"duration_s", {}, {0.3, 0.8}},
                 {"times_s", {kSamples}, {0.0, 0.0}}},
                "101 x 3"};
  over.settle = MakeStep;
  over.shape = [](const QuestionContext&, const Values&) { return std::vector<int>{kSamples, 3}; };
  over.error = StepError;
  over.off_by = "largest violation in metres of the rules: ends, clearance, ceiling, smoothness";
  return {
      Compared(
          {"minimum_jerk", "the minimum-jerk step: value, rate, acceleration", {{"u", {}, {0.0, 1.0}}}, "3 numbers"},
          {3}, JerkAnswer),
      Compared(swing, {3, 3}, SwingAnswer), over};
}

}  // namespace gaitwright
