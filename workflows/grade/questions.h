// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/random.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "workflows/grade/rubric.h"

namespace gaitwright {

/// Gravity that questions are asked with [m/s^2].
inline constexpr double kQuestionGravity = 9.81;

/// A value of a question or an answer: a number (no shape), a vector, or a matrix row by row.
struct QuestionValue {
  std::string name;
  std::vector<int> shape;
  std::vector<double> numbers;
  std::string word = {};  ///< what is said to Python in place of a number that stands for it; "" for none

  /// A row of a matrix that is two or three wide, or the whole vector.
  Vector2 Vec2(int row = 0) const;
  Vector3 Vec3(int row = 0) const;
  double number() const { return numbers.front(); }
};

/// Sizes of shapes that are not in themselves numbers: as many as the question has, and as a leg has joints.
inline constexpr int kSize = -1, kLegJoints = -2;

/// What a question is asked about beside its inputs.
struct QuestionContext {
  int size = 0;
  const RobotModel* model = nullptr;  ///< of questions that need a robot
  int leg_joints = 0;                 ///< of its first leg
};

/// An input of a question: its shape, where kSize stands for the question's own size, and its usual range.
struct QuestionInput {
  std::string name;
  std::vector<int> shape;
  NumberRange range;
};

/// Something that a student's function works out, and what its answer is held against: the program's own code. Nothing
/// of that is ever where the student's code runs.
struct Question {
  std::string name, asks;  ///< what, in a few words
  std::vector<QuestionInput> inputs;
  std::string answer;  ///< its shape in words
  bool needs_robot = false;
  /// Makes drawn numbers ones that may be asked: sorts times, makes points convex. May be empty.
  std::function<void(const QuestionContext&, SplitMix&, std::vector<QuestionValue>&)> settle = {};
  /// The shape of an answer in a table; where the number of corners is open it has as many as there may be.
  std::function<std::vector<int>(const QuestionContext&, const std::vector<QuestionValue>&)> shape = {};
  /// How far an answer is off. @throws InvalidArgument for one of another shape, saying which is needed.
  std::function<double(const QuestionContext&, const std::vector<QuestionValue>&, const QuestionValue& answer)> error =
      {};
  std::string off_by = {};  ///< what the error is, where it is more than a difference
};

/// How many numbers a shape has.
int CountOf(const std::vector<int>& shape);

/// All that there are.
const std::vector<Question>& Questions();
/// Their names.
std::vector<std::string> QuestionNames();
/// The question of that name. @throws InvalidArgument naming the nearest.
const Question& QuestionOf(const std::string& name);

/// The inputs of a case: a pure function of all these. Ranges of `setup` take the place of the usual ones.
std::vector<QuestionValue> DrawCase(const Question& question, const QuestionSetup& setup,
                                    const QuestionContext& context, std::uint64_t seed, int number);

/// @throws InvalidArgument unless the answer has that shape; of "3 numbers" or "6 x 2 numbers".
void RequireShape(const QuestionValue& answer, const std::vector<int>& shape);

/// A shape in words: "a number", "3 numbers", "6 x 2 numbers".
std::string ShapeWords(const std::vector<int>& shape);

}  // namespace gaitwright
