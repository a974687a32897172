// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "workflows/grade/questions.h"

namespace gaitwright {

/// An answer of a shape.
inline QuestionValue Answer(std::vector<int> shape, std::vector<double> numbers) {
  return {"answer", std::move(shape), std::move(numbers)};
}

/// A case of a question, drawn from the default ranges.
inline std::vector<QuestionValue> Drawn(const std::string& name, const QuestionContext& context, int number = 0) {
  return DrawCase(QuestionOf(name), {}, context, 7, number);
}

/// The error of an answer.
inline double ErrorOf(const std::string& name, const QuestionContext& context, const std::vector<QuestionValue>& in,
                      const QuestionValue& answer) {
  return QuestionOf(name).error(context, in, answer);
}

}  // namespace gaitwright
