// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// Thrown for a part that cannot be evaluated or expanded. The expander adds the place in the file.
struct XacroProblem {
  FailureCode code = FailureCode::kInternal;
  std::string message;
  bool shows_expression = false;  ///< the message begins with the innermost expression
};

/// Limits of one value: bytes of a text, items of a list or dictionary, depth of nested lists and dictionaries.
inline constexpr std::size_t kLongestXacroText = std::size_t{1} << 20, kMostXacroItems = 100000;
inline constexpr int kDeepestXacroValue = 32;

/// Counts the work of an expansion, so that a malicious file cannot block the program or exhaust its memory or stack.
/// Each function throws XacroProblem `xacro_limit` beyond its limit.
class XacroBudget {
 public:
  /// Counts work of an evaluation; a unit is about one operation on a number or on 16 bytes of text.
  void Spend(std::size_t units);
  /// Counts an element that is visited in the sources or copied to the result.
  void Visit();
  /// Counts bytes of the result.
  void Write(std::size_t bytes);

  /// Counts the depth of nested calls; each object is one level.
  class Level {
   public:
    explicit Level(XacroBudget& budget);
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    ~Level() { --budget_.level_; }

   private:
    XacroBudget& budget_;
  };

 private:
  std::size_t units_ = 0, elements_ = 0, bytes_ = 0;
  int level_ = 0;
};

struct XacroList;
struct XacroDict;

/// A value of an expression, with the kinds and semantics of Python. Copies of a list share its items: pop() on one
/// copy changes all copies.
struct XacroValue {
  using Held = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::shared_ptr<XacroList>,
                            std::shared_ptr<const XacroDict>>;

  Held held;

  const std::string* text() const { return std::get_if<std::string>(&held); }
  const std::int64_t* whole() const { return std::get_if<std::int64_t>(&held); }
  const XacroList* list() const;
  const XacroDict* dict() const;
  bool is_none() const { return std::holds_alternative<std::monostate>(held); }
  bool is_truth() const { return std::holds_alternative<bool>(held); }
  bool is_real() const { return std::holds_alternative<double>(held); }
};

/// The items of a list or tuple. `depth` is the depth of nested lists and dictionaries, including this one.
struct XacroList {
  std::vector<XacroValue> items;
  int depth = 1;
};

/// The entries of a dictionary in the order of their first appearance.
struct XacroDict {
  std::vector<std::pair<XacroValue, XacroValue>> entries;
  int depth = 1;

  /// The value of a key, or null.
  const XacroValue* Find(const XacroValue& key, XacroBudget& budget) const;
};

/// Builds values from parts. Throws XacroProblem if they exceed the limits.
XacroValue XacroText(std::string text);
XacroValue XacroListOf(std::vector<XacroValue> items, XacroBudget& budget);
/// If a key appears twice, the last value is used.
XacroValue XacroDictOf(std::vector<std::pair<XacroValue, XacroValue>>&& entries, XacroBudget& budget);

/// "text", "list" and so on, for messages.
std::string XacroKind(const XacroValue& value);

/// Whether the value is true in Python.
bool XacroTruth(const XacroValue& value);

/// The value of a number or truth value as a number.
std::optional<double> XacroNumber(const XacroValue& value);

/// Whether two values are equal: 1 == 1.0 == True, and a text equals no number.
bool XacroEqual(const XacroValue& a, const XacroValue& b, XacroBudget& budget);

/// The value as printed by Python's str(): 1, 0.1, 1e-05, True, None, [1, 'a'], {'a': 1}. Numbers read back exactly.
std::string XacroPrinted(const XacroValue& value, XacroBudget& budget);

/// The number of a text as read by Python's int() and float(), which accept spaces around it; nothing for other texts.
std::optional<std::int64_t> XacroWholeOf(const std::string& text);
std::optional<double> XacroRealOf(const std::string& text);

/// The value of the text of a property or parameter: 'text' in single quotes is this text, a number or truth value is
/// its value, and any other text is unchanged.
XacroValue XacroLiteral(const std::string& text);

}  // namespace gaitwright
