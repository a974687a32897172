// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/grade/questions.h"

namespace gaitwright {

/// The longest line of an answer from a submission's code [byte].
inline constexpr std::size_t kLongestAnswer = std::size_t{1} << 20;

/// The numbers of an answer `{"answer": ...}`: a number, a list, or a list of lists of equal length.
/// @throws InvalidArgument, with a message for the student, for anything else: words, NaN, deeper lists, rows of
/// different lengths.
QuestionValue ParseAnswer(const std::string& line);

/// A footstep of a submission: the foot's name and three numbers.
struct AnsweredStep {
  std::string foot;
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

/// The steps of an answer. @throws InvalidArgument as ParseAnswer does, and for more than `most` steps.
std::vector<AnsweredStep> ParseSteps(const std::string& line, std::size_t most);

/// The rows of an answer that is a list of `count` lists of `size` numbers each. @throws InvalidArgument as ParseAnswer
/// does.
std::vector<VectorX> ParseRows(const std::string& line, int count, int size);

}  // namespace gaitwright
