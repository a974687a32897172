// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/task_rules.h"

namespace gaitwright {

/// A language model behind an endpoint with the interface of OpenAI's chat completions.
struct LanguageModel {
  std::string url;    ///< the base, such as "http://localhost:8000/v1"; "/chat/completions" is added if missing
  std::string model;  ///< name of the model at the endpoint
  std::string key;    ///< sent as a bearer token; "" sends none
  double longest_s = 60.0;
};

/// The key for language models from the environment: GAITWRIGHT_API_KEY, otherwise OPENAI_API_KEY, otherwise "".
std::string ApiKeyFromEnvironment();

/// Turns an instruction into tasks.
class Interpreter {
 public:
  virtual ~Interpreter() = default;

  /// Its name in messages, such as "grammar".
  virtual std::string name() const = 0;

  /// @param scope  the abilities of the robot and the known places.
  /// @param notes  receives the reasons why received answers are not accepted.
  /// @return a plan that is valid for the robot (ReasonNotPlanned), or the failure. Failure `interpreter_url`: the URL
  /// of the interpreter is wrong.
  virtual Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                                     std::vector<std::string>& notes) const = 0;
};

/// The built-in grammar of English and Chinese (understand.h).
class Grammar : public Interpreter {
 public:
  std::string name() const override { return "grammar"; }
  Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                             std::vector<std::string>& notes) const override;
};

/// A language model. An answer that is not valid for the robot is refused, and the request is sent once more with the
/// error.
class ModelInterpreter : public Interpreter {
 public:
  explicit ModelInterpreter(LanguageModel model) : model_(std::move(model)) {}

  std::string name() const override { return "language model"; }
  Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope& scope,
                             std::vector<std::string>& notes) const override;

 private:
  LanguageModel model_;
};

/// The interpretation of an instruction, and its source.
struct Interpretation {
  TaskPlan plan;
  std::string by;                  ///< name of the interpreter, "grammar" or "language model"
  std::vector<std::string> notes;  ///< why answers of previous interpreters were not accepted
};

/// The system prompt of a language model: the abilities of this robot, the places, and the schema of the answer.
std::string InterpreterPrompt(const TaskScope& scope);

/// The task plan in a language model's answer, as plain or fenced JSON. Failures as of TaskPlanFromJson and
/// ReasonNotPlanned: every returned plan is valid for this robot.
Result<TaskPlan> PlanInAnswer(const std::string& answer, const std::string& instruction, const TaskScope& scope);

/// Translates an instruction to a task plan with the first interpreter that understands it. Failure: that of the last
/// interpreter, with the notes as suggestions, or `interpreter_url` of any interpreter.
/// @throws InvalidArgument without an interpreter.
Result<Interpretation> InterpretBy(const std::vector<const Interpreter*>& interpreters, const std::string& instruction,
                                   const TaskScope& scope);

/// Translates with the language model, if one is given, and then with the built-in grammar. Failure: the grammar's
/// refusal.
Result<Interpretation> Interpret(const std::string& instruction, const TaskScope& scope,
                                 const std::optional<LanguageModel>& model);

}  // namespace gaitwright
