// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "workflows/grade/questions.h"

namespace gaitwright {

/// Questions about the ZMP and support polygons, the DCM, preview control, swings and legs.
std::vector<Question> BalanceQuestions();
std::vector<Question> DivergentQuestions();
std::vector<Question> PreviewQuestions();
std::vector<Question> SwingQuestions();
std::vector<Question> LegQuestions();

/// Largest difference of two lists of equal length.
double LargestDifference(const std::vector<double>& a, const std::vector<double>& b);

/// A question with a single correct answer, whose shape may contain kSize; the error is the largest difference.
Question Compared(
    Question question, const std::vector<int>& shape,
    const std::function<std::vector<double>(const QuestionContext&, const std::vector<QuestionValue>&)>& answer);

}  // namespace gaitwright
