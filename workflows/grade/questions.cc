// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/hash.h"
#include "kinematics/base/nearest_name.h"
#include "kinematics/base/random.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

std::vector<int> Sized(std::vector<int> shape, const QuestionContext& context) {
  for (int& size : shape) size = size == kSize ? context.size : size == kLegJoints ? context.leg_joints : size;
  return shape;
}

}  // namespace

int CountOf(const std::vector<int>& shape) {
  int count = 1;
  for (const int size : shape) count *= size;
  return count;
}

Vector2 QuestionValue::Vec2(int row) const {
  const std::size_t at = static_cast<std::size_t>(row) * 2;
  return {numbers[at], numbers[at + 1]};
}

Vector3 QuestionValue::Vec3(int row) const {
  const std::size_t at = static_cast<std::size_t>(row) * 3;
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

const std::vector<Question>& Questions() {
  static const std::vector<Question> all = [] {
    std::vector<Question> joined;
    for (auto part : {BalanceQuestions(), DivergentQuestions(), PreviewQuestions(), SwingQuestions(), LegQuestions()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

std::vector<std::string> QuestionNames() {
  std::vector<std::string> names;
  for (const Question& question : Questions()) names.push_back(question.name);
  return names;
}

const Question& QuestionOf(const std::string& name) {
  for (const Question& question : Questions()) {
    if (question.name == name) return question;
  }
  throw InvalidArgument(fmt::format("there is no reference '{}'{}", name, NearestOrAll(name, QuestionNames())));
}

std::vector<QuestionValue> DrawCase(const Question& question, const QuestionSetup& setup,
                                    const QuestionContext& context, std::uint64_t seed, int number) {
  SplitMix random(Fnv1a(fmt::format("{}/{}/{}", question.name, seed, number)));
  std::vector<QuestionValue> values;
  for (const QuestionInput& input : question.inputs) {
    const auto own = std::find_if(setup.inputs.begin(), setup.inputs.end(),
                                  [&](const auto& range) { return range.first == input.name; });
    const NumberRange range = own == setup.inputs.end() ? input.range : own->second;
    QuestionValue value{input.name, Sized(input.shape, context), {}};
    for (int i = CountOf(value.shape); i > 0; --i)
      value.numbers.push_back(range.low + random.Uniform() * (range.high - range.low));
    values.push_back(std::move(value));
  }
  if (question.settle) question.settle(context, random, values);
  return values;
}

std::string ShapeWords(const std::vector<int>& shape) {
  return shape.empty() ? "a number" : fmt::format("{} numbers", fmt::join(shape, " x "));
}

void RequireShape(const QuestionValue& answer, const std::vector<int>& shape) {
  if (answer.shape != shape)
    throw InvalidArgument(fmt::format("the answer is {}; {} {} needed", ShapeWords(answer.shape), ShapeWords(shape),
                                      shape.empty() ? "is" : "are"));
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (!std::isfinite(difference)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, difference);
  }
  return largest;
}

Question Compared(
    Question question, const std::vector<int>& shape,
    const std::function<std::vector<double>(const QuestionContext&, const std::vector<QuestionValue>&)>& answer) {
  question.shape = [shape](const QuestionContext& context, const std::vector<QuestionValue>&) {
    return Sized(shape, context);
  };
  question.error = [shape, answer](const QuestionContext& context, const std::vector<QuestionValue>& inputs,
                                   const QuestionValue& given) {
    RequireShape(given, Sized(shape, context));
    return LargestDifference(answer(context, inputs), given.numbers);
  };
  return question;
}

}  // namespace gaitwright
