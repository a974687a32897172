// SPDX-License-Identifier: BSD-3-Clause
// Kajita et al., ICRA 2003, doi:10.1109/ROBOT.2003.1241826: preview control of the ZMP of a cart on a table.
#include <algorithm>
#include <cmath>

#include "optimisation/centroidal/preview_control.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

constexpr int kSamplesEach = 10;  // samples of the reference per unit of the question's size
constexpr std::size_t kFirstGains = 4;

const std::vector<QuestionInput> kSetup = {{"com_height_m", {}, {0.3, 1.0}},
                                           {"step_s", {}, {0.005, 0.02}},
                                           {"preview_s", {}, {0.8, 1.6}},
                                           {"error_weight", {}, {1.0, 1.0}},
                                           {"jerk_weight", {}, {1e-6, 1e-6}}};

PreviewSetup SetupOf(const Values& in, std::size_t first) {
  return {in[first].number(), in[first + 1].number(), in[first + 2].number(), in[first + 3].number(),
          in[first + 4].number()};
}

/// Rounds the step to whole milliseconds and the preview to whole steps, so that students need not round.
void RoundTimes(Values& in, std::size_t first) {
  double& step_s = in[first + 1].numbers.front();
  double& preview_s = in[first + 2].numbers.front();
  step_s = std::max(1.0, std::round(step_s * 1000.0)) / 1000.0;
  preview_s = std::max(1.0, std::round(preview_s / step_s)) * step_s;
}

std::vector<double> GainsOf(const Values& in) {
  const PreviewGains gains = ComputePreviewGains(SetupOf(in, 0));
  std::vector<double> numbers = {gains.integral, gains.state.x(), gains.state.y(), gains.state.z()};
  numbers.insert(numbers.end(), gains.preview.begin(), gains.preview.end());
  return numbers;
}

/// Largest relative error of the gains, because they differ in magnitude; preview gains relative to the largest one.
double GainsError(const QuestionContext&, const Values& in, const QuestionValue& answer) {
  const std::vector<double> right = GainsOf(in);
  RequireShape(answer, {static_cast<int>(right.size())});
  double largest_preview = 0.0, error = 0.0;
  for (std::size_t i = kFirstGains; i < right.size(); ++i)
    largest_preview = std::max(largest_preview, std::abs(right[i]));
  for (std::size_t i = 0; i < right.size(); ++i) {
    const double scale = i < kFirstGains ? std::abs(right[i]) : largest_preview;
    error = std::max(error, std::abs(right[i] - answer.numbers[i]) / scale);
  }
  return error;
}

/// A ZMP reference that is constant at first and then jumps from step to step, from numbers drawn for each sample.
void MakeReference(const QuestionContext& context, Values& in) {
  RoundTimes(in, 2);
  std::vector<double>& reference = in[0].numbers;
  for (int i = 0; i < context.size; ++i) {
    const auto first = reference.begin() + static_cast<std::ptrdiff_t>(i) * kSamplesEach;
    std::fill_n(first, kSamplesEach, *first);
  }
  in[1].numbers.front() = reference.front();
}

std::vector<double> FollowAnswer(const QuestionContext&, const Values& in) {
  return FollowZmp(SetupOf(in, 2), in[0].numbers, in[1].number()).com_m;
}

}  // namespace

std::vector<Question> PreviewQuestions() {
  Question gains{"preview_gains", "the gains of the preview controller", kSetup, "4 + preview numbers: K_i, K_x, f"};
  gains.settle = [](const QuestionContext&, SplitMix&, Values& in) { RoundTimes(in, 0); };
  gains.shape = [](const QuestionContext&, const Values& in) {
    return std::vector<int>{static_cast<int>(GainsOf(in).size())};
  };
  gains.error = GainsError;
  gains.off_by = "largest relative error of a gain";
  Question follow{"follow_zmp",
                  "the centre of mass of a roll-out, at each sample of the reference",
                  {{"reference_m", {kSize, kSamplesEach}, {-0.1, 0.1}}, {"com_m", {}, {0.0, 0.0}}},
                  "numbers"};
  follow.inputs.insert(follow.inputs.end(), kSetup.begin(), kSetup.end());
  follow.settle = [](const QuestionContext& context, SplitMix&, Values& in) {
    MakeReference(context, in);
    in[0].shape = {context.size * kSamplesEach};
  };
  follow.shape = [](const QuestionContext&, const Values& in) { return in[0].shape; };
  follow.error = [](const QuestionContext& context, const Values& in, const QuestionValue& answer) {
    RequireShape(answer, in[0].shape);
    return LargestDifference(FollowAnswer(context, in), answer.numbers);
  };
  return {gains, follow};
}

}  // namespace gaitwright
