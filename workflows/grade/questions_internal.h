// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "workflows/grade/questions.h"

namespace gaitwright {

/// Questions about the ZMP and supports, the DCM, preview control, swings, legs.
std::vector<Question> BalanceQuestions();
std::vector<Question> DivergentQuestions();
std::vector<Question> PreviewQuestions();
std::vector<Question> SwingQuestions();
std::vector<Question> LegQuestions();

/// Of two lists that are as long as each other.
double LargestDifference(const std::vector<double>& a, const std::vector<double>& b);

/// A question with one answer, of a shape that may have kSize in it; the error is the largest difference.
Question Compared(
    Question question, const std::vector<int>& shape,
    const std::function<std::vector<double>(const QuestionContext&, const std::vector<QuestionValue>&)>& answer);

}  // namespace gaitwright
