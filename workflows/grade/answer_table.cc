// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/answer_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/file.h"
#include "kinematics/base/nearest_name.h"

namespace gaitwright {
namespace {

int ColumnOf(const CsvTable& inputs, const std::string& name) {
  const int column = inputs.Find(name);
  if (column >= 0) return column;
  throw InvalidArgument(
      fmt::format("{} has no column '{}'{}", inputs.source, name, NearestOrAll(name, inputs.columns)));
}

/// Number of the columns name_0, name_1, ...
int SizeOfInput(const CsvTable& inputs, const std::string& name) {
  int count = 0;
  while (inputs.Find(fmt::format("{}_{}", name, count)) >= 0) ++count;
  return count;
}

std::string Row(double number, const std::vector<double>& answer, std::size_t width) {
  std::string row = fmt::format("{:.0f}", number);
  for (std::size_t i = 0; i < width; ++i) row += fmt::format(",{}", i < answer.size() ? answer[i] : 0.0);
  return row + "\n";
}

}  // namespace

double AnswerCase::Number(const std::string& name) const { return inputs_.At(row_, ColumnOf(inputs_, name)); }

VectorX AnswerCase::Vector(const std::string& name) const {
  VectorX vector(std::max(1, SizeOfInput(inputs_, name)));  // Number() refuses a missing one
  for (int i = 0; i < vector.size(); ++i) vector[i] = Number(fmt::format("{}_{}", name, i));
  return vector;
}

MatrixX AnswerCase::Matrix(const std::string& name) const {
  int rows = 0;
  while (inputs_.Find(fmt::format("{}_{}_0", name, rows)) >= 0) ++rows;
  MatrixX matrix(std::max(1, rows), std::max(1, SizeOfInput(inputs_, name + "_0")));
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.cols(); ++j) matrix(i, j) = Number(fmt::format("{}_{}_{}", name, i, j));
  }
  return matrix;
}

std::string AnswersCsv(const CsvTable& inputs, const AnswerFunction& answer) {
  const int cases = ColumnOf(inputs, "case");
  std::vector<std::vector<double>> answers;
  std::size_t width = 0;
  for (int row = 0; row < inputs.rows(); ++row) {
    answers.push_back(answer(AnswerCase(inputs, row)));
    width = std::max(width, answers.back().size());
    for (const double value : answers.back()) {
      if (!std::isfinite(value))
        throw InvalidArgument(fmt::format("the answer to case {:.0f} of {} is {}; it must be finite",
                                          inputs.At(row, cases), inputs.source, value));
    }
  }
  std::string csv = "case";
  for (std::size_t i = 0; i < width; ++i) csv += fmt::format(",answer_{}", i);
  csv += "\n";
  for (int row = 0; row < inputs.rows(); ++row)
    csv += Row(inputs.At(row, cases), answers[static_cast<std::size_t>(row)], width);
  return csv;
}

Result<std::vector<std::string>> WriteAnswers(const std::string& inputs_folder, const std::string& answers_folder,
                                              const std::vector<AnsweredPart>& parts) {
  std::vector<OutputFile> files;
  for (const AnsweredPart& part : parts) {
    const Result<CsvTable> inputs = ReadCsvTable(fmt::format("{}/{}_inputs.csv", inputs_folder, part.name));
    if (!inputs) return inputs.failure();
    try {
      files.push_back({fmt::format("{}/{}.csv", answers_folder, part.name), AnswersCsv(*inputs, part.answer)});
    } catch (const InvalidArgument& error) {
      return Failure{FailureKind::kBadInput, FailureCode::kAnswers, "WriteAnswers", error.what(), {}};
    }
  }
  return WriteFilesTogether(files);
}

}  // namespace gaitwright
