// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/student_answer.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "workflows/grade/student_python.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 6;

/// The value of an answer; refuses deep nesting before it is built.
Json AnswerOf(const std::string& line) {
  Json json;
  try {
    json = Json::parse(line, [](int depth, Json::parse_event_t, Json&) {
      if (depth > kDeepest) throw InvalidArgument("the answer has lists nested too deep");
      return true;
    });
  } catch (const Json::exception&) {
    throw InvalidArgument("the answer is not JSON");
  }
  if (!json.is_object() || !json.contains("answer")) throw InvalidArgument("the answer lacks the key 'answer'");
  return json["answer"];
}

/// A finite number. `where()` is called only for messages, because answers come in each control step.
template <typename Where>
double NumberIn(const Json& json, const Where& where) {
  if (json.is_string())
    throw InvalidArgument(
        fmt::format("the answer{} is {}; a finite number is needed", where(), ShownWords(json.get<std::string>())));
  if (!json.is_number()) throw InvalidArgument(fmt::format("the answer{} is not a number", where()));
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw InvalidArgument(fmt::format("the answer{} is not finite", where()));
  return value;
}

void AddRow(const Json& row, std::size_t number, QuestionValue& value) {
  if (!row.is_array() || row.size() != static_cast<std::size_t>(value.shape[1]))
    throw InvalidArgument(fmt::format("row {} of the answer has another length than the first one", number));
  for (std::size_t i = 0; i < row.size(); ++i)
    value.numbers.push_back(NumberIn(row[i], [&] { return fmt::format("[{}, {}]", number, i); }));
}

}  // namespace

QuestionValue ParseAnswer(const std::string& line) {
  const Json json = AnswerOf(line);
  QuestionValue value{"answer", {}, {}};
  if (!json.is_array()) {
    value.numbers = {NumberIn(json, [] { return ""; })};
    return value;
  }
  value.shape = {static_cast<int>(json.size())};
  if (json.empty() || !json[0].is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i)
      value.numbers.push_back(NumberIn(json[i], [&] { return fmt::format("[{}]", i); }));
    return value;
  }
  value.shape.push_back(static_cast<int>(json[0].size()));
  for (std::size_t row = 0; row < json.size(); ++row) AddRow(json[row], row, value);
  return value;
}

std::vector<AnsweredStep> ParseSteps(const std::string& line, std::size_t most) {
  const Json json = AnswerOf(line);
  if (!json.is_array()) throw InvalidArgument("the planner's answer is not a list of steps");
  if (json.size() > most)
    throw InvalidArgument(fmt::format("the planner gave {} steps; at most {} are accepted", json.size(), most));
  if (json.empty()) throw InvalidArgument("the planner gave no steps");
  std::vector<AnsweredStep> steps;
  for (const Json& step : json) {
    const auto place = [&](const char* what) {
      return [&, what] { return fmt::format(" of step {}, {}", steps.size() + 1, what); };
    };
    if (!step.is_array() || step.size() != 4 || !step[0].is_string())
      throw InvalidArgument(fmt::format("step {} is not (foot, x, y, yaw)", steps.size() + 1));
    steps.push_back({ShownWords(step[0].get<std::string>()), NumberIn(step[1], place("x")),
                     NumberIn(step[2], place("y")), NumberIn(step[3], place("yaw"))});
  }
  return steps;
}

std::vector<VectorX> ParseRows(const std::string& line, int count, int size) {
  const QuestionValue value = ParseAnswer(line);
  RequireShape(value, {count, size});
  std::vector<VectorX> rows;
  for (int row = 0; row < count; ++row)
    rows.emplace_back(Eigen::Map<const VectorX>(value.numbers.data() + static_cast<std::ptrdiff_t>(row) * size, size));
  return rows;
}

}  // namespace gaitwright
