// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"
#include "workflows/exchange/csv_table.h"

namespace gaitwright {

/// A case of a part that asks for answers, as `gaitwright grade --write-inputs` writes it (docs/grading.md): a row of
/// the table of inputs, which must outlive this object. All accessors throw InvalidArgument if the table has no such
/// input.
class AnswerCase {
 public:
  AnswerCase(const CsvTable& inputs, int row) : inputs_(inputs), row_(row) {}

  /// A number input: the column of its name.
  double Number(const std::string& name) const;
  /// A list input: the columns name_0, name_1, ...
  VectorX Vector(const std::string& name) const;
  /// A matrix input: name_0_0, name_0_1, ..., row by row.
  MatrixX Matrix(const std::string& name) const;

 private:
  const CsvTable& inputs_;
  int row_;
};

/// Answer to a case; matrices row by row.
using AnswerFunction = std::function<std::vector<double>(const AnswerCase&)>;

/// The table of answers to all cases: `case`, answer_0, answer_1, ... Shorter answers are padded with zeros, which are
/// not marked. @throws InvalidArgument without a column `case`.
std::string AnswersCsv(const CsvTable& inputs, const AnswerFunction& answer);

/// The name of a part of a rubric, and the function that answers it.
struct AnsweredPart {
  std::string name;
  AnswerFunction answer;
};

/// Answers parts: reads NAME_inputs.csv in one folder and writes NAME.csv in another, for all parts or none.
/// @return the paths written. Failure for a file that cannot be read or written, a missing input, and an answer that is
/// not finite; it names the part and the case.
Result<std::vector<std::string>> WriteAnswers(const std::string& inputs_folder, const std::string& answers_folder,
                                              const std::vector<AnsweredPart>& parts);

}  // namespace gaitwright
