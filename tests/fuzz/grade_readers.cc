// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/grade_readers.h"

#include <cmath>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/text.h"
#include "tests/fuzz/inputs.h"
#include "workflows/grade/mark_part.h"
#include "workflows/grade/questions.h"
#include "workflows/grade/student_answer.h"

namespace gaitwright::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr char kAnswersPart[] =
    "title: t\nparts:\n- {name: dcm, kind: answers, file: answers.csv, points: 4, reference: dcm, cases: 3}\n";

void CheckPartLaws(const RubricPart& part) {
  double sum = 0.0;
  for (const Check& check : part.checks) {
    sum += check.points;
    for (const double value : {check.full_at, check.none_at.value_or(-1e300), 0.0, 1.0, 1e300, -1e300}) {
      const double points = check.PointsOf(value);
      Require(points >= 0.0 && points <= check.points, "a check gives at most its points");
    }
    Require(check.PointsOf(check.full_at) == check.points, "the value for full points gets full points");
  }
  Require(part.points > 0.0 && std::abs(sum - part.points) < 1e-5, "the checks add up to the part");
  Require(part.limits.time_s > 0.0 && part.limits.memory_mb > 0 && part.limits.file_mb > 0, "limits are positive");
  Require(part.file.find('/') == std::string::npos && !part.file.starts_with("."), "a file is in the student's folder");
  Require(PlaysMotions(part.kind) || part.question.cases > 0, "there are cases");
}

Verdict ReadARubric(const std::string& input) {
  const Result<Rubric> rubric = ReadRubric(input, "input");
  if (!rubric) return Verdict::kRefused;
  Require(!rubric->parts.empty() && rubric->points() > 0.0, "a rubric has parts");
  for (const RubricPart& part : rubric->parts) CheckPartLaws(part);
  return Verdict::kAccepted;
}

/// A mark does not exceed the available points, and gives a reason if it is lower.
Verdict MarkAnswersOf(const std::string& input) {
  static const Rubric rubric = ReadRubric(kAnswersPart, "rubric").value();
  const fs::path file = InFile(input, ".csv");
  RubricPart part = rubric.parts.front();
  part.file = file.filename().string();
  const PartMark mark = MarkPart(part, {"student", file.parent_path().string()}, {});
  Require(mark.points >= 0.0 && mark.points <= mark.of, "a mark is at most the points of its part");
  Require((mark.points == mark.of) == mark.reasons.empty(), "lost points have a reason");
  for (const std::string& reason : mark.reasons) Require(IsPlainText(reason), "reasons are plain text");
  return mark.checks.front().value ? Verdict::kAccepted : Verdict::kRefused;
}

/// Answers as numbers, as steps and as rows: every accepted answer is finite and has the required shape.
Verdict ReadCodeAnswer(const std::string& input) {
  Verdict verdict = Verdict::kRefused;
  try {
    const QuestionValue value = ParseAnswer(input);
    Require(CountOf(value.shape) == static_cast<int>(value.numbers.size()), "an answer has its shape");
    for (const double number : value.numbers) Require(std::isfinite(number), "answers are finite");
    verdict = Verdict::kAccepted;
  } catch (const InvalidArgument&) {
  }
  try {
    for (const AnsweredStep& step : ParseSteps(input, 10)) {
      Require(std::isfinite(step.x_m) && std::isfinite(step.y_m) && std::isfinite(step.yaw_rad), "steps are finite");
      Require(IsPlainText(step.foot), "names of feet are plain text");
    }
    verdict = Verdict::kAccepted;
  } catch (const InvalidArgument&) {
  }
  try {
    for (const VectorX& row : ParseRows(input, 2, 3)) Require(row.size() == 3 && row.allFinite(), "rows are finite");
  } catch (const InvalidArgument&) {
  }
  return verdict;
}

std::vector<std::string> MadeAnswers() {
  const Rubric rubric = ReadRubric(kAnswersPart, "rubric").value();
  return {"case,answer_0,answer_1\n0,1,2\n1,0.5,-3e-2\n2,0,0\n", InputsCsv(rubric.parts.front(), 7)};
}

std::vector<std::string> MadeCodeAnswers() {
  return {R"({"answer": 1.5})", R"({"answer": [1, 2, 3]})", R"({"answer": [[1, 2, 3], [4, 5, 6]]})",
          R"({"answer": [["l_ankle", 0.1, 0.05, 0.0], ["r_ankle", 0.2, -0.05, 0.1]]})", R"({"answer": "nan"})"};
}

}  // namespace

std::vector<Reader> GradeReaders() {
  std::vector<std::string> words = {"title",   "parts",    "name",       "kind",        "points", "checks",  "measure",
                                    "full_at", "none_at",  "limits",     "time_s",      "robot",  "terrain", "command",
                                    "runs",    "function", "controller", "share_right", "a1",     ".nan",    "1e400",
                                    "[0, 1]",  "-1",       "&a",         "*a"};
  return {{"rubric", ReadARubric, words, {}},
          {"answers", MarkAnswersOf, {"case", "answer_0", ",", "\n", "nan", "1e400", "-1", "\"", "#"}, {}, MadeAnswers},
          {"code_answer",
           ReadCodeAnswer,
           {"{\"answer\": ", "[", "]", ",", "null", "1e400", "\"nan\"", "true", "}"},
           {},
           MadeCodeAnswers}};
}

}  // namespace gaitwright::fuzz
