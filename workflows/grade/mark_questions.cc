// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "kinematics/ik/leg_chain.h"
#include "kinematics/model/load_robot.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/grade/mark_part_internal.h"
#include "workflows/grade/questions.h"
#include "workflows/grade/student_answer.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostQuestionReasons = 3;

/// Judges the answers to a part's question.
class Examiner {
 public:
  Examiner(const RubricPart& part, std::uint64_t seed)
      : part_(part), question_(QuestionOf(part.question.reference)), seed_(part.question.seed.value_or(seed)) {
    context_.size = part.question.size;
    if (part.question.robot.empty()) return;
    const Result<RobotModel> model = LoadNamedRobot(part.question.robot);
    if (!model) throw InvalidArgument(model.failure().message);
    model_ = *model;
    context_.model = &*model_;
    context_.leg_joints = LegChain(*model_, 0).num_coordinates();
  }

  std::vector<QuestionValue> Case(int number) const {
    return DrawCase(question_, part_.question, context_, seed_, number);
  }

  std::vector<int> ShapeOf(const std::vector<QuestionValue>& inputs) const { return question_.shape(context_, inputs); }

  /// Judges the answer to a case.
  void Judge(int number, const std::vector<QuestionValue>& inputs, const QuestionValue& answer) {
    try {
      const double error = question_.error(context_, inputs, answer);
      largest_ = std::max(largest_, error);
      if (error <= part_.question.tolerance) {
        ++right_;
      } else {
        const std::string what = question_.off_by.empty() ? "" : " (" + question_.off_by + ")";
        Tell(number, fmt::format("the answer has an error of {:.3g}{}; at most {:.3g} is accepted", error, what,
                                 part_.question.tolerance));
      }
    } catch (const InvalidArgument& error) {
      Wrong(number, error.what());
    }
  }

  /// Counts a case without a valid answer.
  void Wrong(int number, const std::string& why) {
    largest_ = std::numeric_limits<double>::infinity();
    Tell(number, why);
  }

  PartMark Mark() const {
    std::vector<std::optional<double>> values;
    for (const Check& check : part_.checks)
      values.emplace_back(check.measure == "share_right" ? static_cast<double>(right_) / part_.question.cases
                                                         : largest_);
    PartMark mark = MarkOf(part_, values);
    if (right_ < part_.question.cases) {
      mark.reasons.push_back(fmt::format("{} of {} cases are correct", right_, part_.question.cases));
      mark.reasons.insert(mark.reasons.end(), reasons_.begin(), reasons_.end());
    }
    return mark;
  }

 private:
  void Tell(int number, const std::string& why) {
    if (reasons_.size() < kMostQuestionReasons) reasons_.push_back(fmt::format("case {}: {}", number, why));
  }

  const RubricPart& part_;
  const Question& question_;
  std::uint64_t seed_;
  std::optional<RobotModel> model_;
  QuestionContext context_;
  int right_ = 0;
  double largest_ = 0.0;
  std::vector<std::string> reasons_;
};

nlohmann::ordered_json JsonOf(const QuestionValue& value) {
  if (!value.word.empty()) return value.word;
  if (value.shape.empty()) return value.number();
  if (value.shape.size() == 1) return value.numbers;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const auto width = static_cast<std::ptrdiff_t>(value.shape[1]);
  for (auto at = value.numbers.begin(); at != value.numbers.end(); at += width)
    rows.push_back(std::vector<double>(at, at + width));
  return rows;
}

std::string RequestOf(const std::vector<QuestionValue>& inputs) {
  nlohmann::ordered_json call = nlohmann::ordered_json::array();
  for (const QuestionValue& input : inputs) call.push_back(JsonOf(input));
  return nlohmann::ordered_json{{"call", call}}.dump();
}

/// Sends one case to the code. @return the reason if the process ended.
std::optional<std::string> AskCase(StudentPython& code, int number, Examiner& examiner) {
  const std::vector<QuestionValue> inputs = examiner.Case(number);
  const Result<std::string> line = code.Ask(RequestOf(inputs), kLongestAnswer);
  if (!line && EndedIt(line.failure())) return ReasonOf(line.failure());
  if (!line) {
    examiner.Wrong(number, ReasonOf(line.failure()));
    return std::nullopt;
  }
  try {
    examiner.Judge(number, inputs, ParseAnswer(*line));
  } catch (const InvalidArgument& error) {
    examiner.Wrong(number, error.what());
  }
  return std::nullopt;
}

/// Column of a number of a value: "com_m_0", "points_m_2_1", or the name alone.
std::string ColumnOf(const QuestionValue& value, std::size_t number) {
  if (value.shape.empty()) return value.name;
  if (value.shape.size() == 1) return fmt::format("{}_{}", value.name, number);
  const auto width = static_cast<std::size_t>(value.shape[1]);
  return fmt::format("{}_{}_{}", value.name, number / width, number % width);
}

/// The rows of a table by case. @throws InvalidArgument for a missing column, an unknown case and a duplicate case.
std::map<int, int> RowsByCase(const CsvTable& table, int cases) {
  const int column = table.Find("case");
  if (column < 0) throw InvalidArgument(fmt::format("'{}' has no column 'case'", table.source));
  if (table.Find("answer_0") < 0) throw InvalidArgument(fmt::format("'{}' has no column 'answer_0'", table.source));
  std::map<int, int> rows;
  for (int row = 0; row < table.rows(); ++row) {
    const double number = table.At(row, column);
    if (number != std::floor(number) || number < 0.0 || number >= cases)
      throw InvalidArgument(fmt::format("{} is {}; accepted: 0 to {}", table.Place(row, column), number, cases - 1));
    if (!rows.emplace(static_cast<int>(number), row).second)
      throw InvalidArgument(fmt::format("case {} is in '{}' twice", number, table.source));
  }
  return rows;
}

/// The answer in a row, with as many numbers as the shape has. @throws InvalidArgument for missing columns.
QuestionValue AnswerOf(const CsvTable& table, int row, const std::vector<int>& shape) {
  QuestionValue answer{"answer", shape, {}};
  for (int i = 0; i < CountOf(shape); ++i) {
    const int column = table.Find(fmt::format("answer_{}", i));
    if (column < 0)
      throw InvalidArgument(fmt::format("there is no column 'answer_{}'; {} are needed", i, ShapeWords(shape)));
    answer.numbers.push_back(table.At(row, column));
  }
  return answer;
}

}  // namespace

PartMark MarkFunction(const HandedIn& in) {
  Result<StudentPython> code = StartCode(in);
  if (!code) return NothingFor(in.part, ReasonOf(code.failure()));
  Examiner examiner(in.part, in.setup.seed);
  for (int number = 0; number < in.part.question.cases; ++number) {
    if (const auto ended = AskCase(*code, number, examiner)) return NothingFor(in.part, *ended);
  }
  return examiner.Mark();
}

PartMark MarkAnswers(const HandedIn& in) {
  const Result<CsvTable> table = ParseCsvTable(in.text, in.part.file);
  if (!table) return NothingFor(in.part, ShownWords(table.failure().message));
  Examiner examiner(in.part, in.setup.seed);
  const std::map<int, int> rows = RowsByCase(*table, in.part.question.cases);
  for (int number = 0; number < in.part.question.cases; ++number) {
    const auto row = rows.find(number);
    if (row == rows.end()) {
      examiner.Wrong(number, "there is no answer");
      continue;
    }
    const std::vector<QuestionValue> inputs = examiner.Case(number);
    examiner.Judge(number, inputs, AnswerOf(*table, row->second, examiner.ShapeOf(inputs)));
  }
  return examiner.Mark();
}

std::string InputsCsv(const RubricPart& part, std::uint64_t seed) {
  const Examiner examiner(part, seed);
  std::string csv;
  for (int number = 0; number < part.question.cases; ++number) {
    const std::vector<QuestionValue> inputs = examiner.Case(number);
    std::vector<std::string> names = {"case"}, cells = {std::to_string(number)};
    for (const QuestionValue& input : inputs) {
      for (std::size_t i = 0; i < input.numbers.size(); ++i) {
        names.push_back(ColumnOf(input, i));
        cells.push_back(fmt::format("{}", input.numbers[i]));
      }
    }
    if (number == 0) csv = fmt::format("{}\n", fmt::join(names, ","));
    csv += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return csv;
}

}  // namespace gaitwright
