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

/// Gravity used in questions [m/s^2].
inline constexpr double kQuestionGravity = 9.81;

/// A value of a question or an answer: a number (no shape), a vector, or a row-major matrix.
struct QuestionValue {
  std::string name;
  std::vector<int> shape;
  std::vector<double> numbers;
  std::string word = {};  ///< word passed to Python instead of its number; "" for none

  /// A row of a matrix that is two or three wide, or the whole vector.
  Vector2 Vec2(int row = 0) const;
  Vector3 Vec3(int row = 0) const;
  double number() const { return numbers.front(); }
};

/// Symbolic sizes of shapes: the question's size, and the number of leg joints.
inline constexpr int kSize = -1, kLegJoints = -2;

/// Context of a question in addition to its inputs.
struct QuestionContext {
  int size = 0;
  const RobotModel* model = nullptr;  ///< for questions that need a robot
  int leg_joints = 0;                 ///< joints of its first leg
};

/// An input of a question: its shape, in which kSize is the question's size, and its default range.
struct QuestionInput {
  std::string name;
  std::vector<int> shape;
  NumberRange range;
};

/// A quantity that a student's function computes, and the reference: the program's own code, which is never accessible
/// to the student's code.
struct Question {
  std::string name, asks;  ///< `asks`: a short description
  std::vector<QuestionInput> inputs;
  std::string answer;  ///< shape in words
  bool needs_robot = false;
  /// Makes drawn numbers valid inputs: sorts times, makes points convex. May be empty.
  std::function<void(const QuestionContext&, SplitMix&, std::vector<QuestionValue>&)> settle = {};
  /// The shape of an answer in a table; with a variable number of corners, the largest possible number.
  std::function<std::vector<int>(const QuestionContext&, const std::vector<QuestionValue>&)> shape = {};
  /// Error of an answer. @throws InvalidArgument for a wrong shape; it names the required shape.
  std::function<double(const QuestionContext&, const std::vector<QuestionValue>&, const QuestionValue& answer)> error =
      {};
  std::string off_by = {};  ///< meaning of the error, if it is more than a difference
};

/// Number of values in a shape.
int CountOf(const std::vector<int>& shape);

/// All questions.
const std::vector<Question>& Questions();
/// Names of all questions.
std::vector<std::string> QuestionNames();
/// The question with this name. @throws InvalidArgument for an unknown name; it names the nearest.
const Question& QuestionOf(const std::string& name);

/// The inputs of a case: a pure function of the arguments. Ranges of `setup` replace the default ones.
std::vector<QuestionValue> DrawCase(const Question& question, const QuestionSetup& setup,
                                    const QuestionContext& context, std::uint64_t seed, int number);

/// @throws InvalidArgument unless the answer has this shape, such as "3 numbers" or "6 x 2 numbers".
void RequireShape(const QuestionValue& answer, const std::vector<int>& shape);

/// A shape in words: "a number", "3 numbers", "6 x 2 numbers".
std::string ShapeWords(const std::vector<int>& shape);

}  // namespace gaitwright
