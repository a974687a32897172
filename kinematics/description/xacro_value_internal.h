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

/// Thrown for what cannot be evaluated or expanded. It has no place in a file; the expander adds that.
struct XacroProblem {
  FailureCode code = FailureCode::kInternal;
  std::string message;
  bool shows_expression = false;  ///< the message begins with the innermost expression
};

/// Bounds of one value: bytes of a text, items of a list or dictionary, lists and dictionaries in one another.
inline constexpr std::size_t kLongestXacroText = std::size_t{1} << 20, kMostXacroItems = 100000;
inline constexpr int kDeepestXacroValue = 32;

/// Counts the work of an expansion, so that a hostile file cannot hang the program or exhaust its memory or stack. Each
/// function throws XacroProblem `xacro_limit` beyond its bound.
class XacroBudget {
 public:
  /// Work of an evaluation; a unit is about one operation on a number or on 16 bytes of text.
  void Spend(std::size_t units);
  /// Elements of the sources that were visited, or copied into the result.
  void Visit();
  /// Bytes of the result.
  void Write(std::size_t bytes);

  /// Counts functions that call one another as long as it lives.
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

/// A value of an expression, with the kinds and the meaning that Python gives them. Copies of a list are one list: what
/// pop() takes from one is gone from all.
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

/// The items of a list or tuple. `depth` counts the lists and dictionaries in one another, this one included.
struct XacroList {
  std::vector<XacroValue> items;
  int depth = 1;
};

/// The entries of a dictionary in the order of their first appearance.
struct XacroDict {
  std::vector<std::pair<XacroValue, XacroValue>> entries;
  int depth = 1;

  /// The value under a key, or null.
  const XacroValue* Find(const XacroValue& key, XacroBudget& budget) const;
};

/// Values made of parts. Throws XacroProblem for what is beyond the bounds.
XacroValue XacroText(std::string text);
XacroValue XacroListOf(std::vector<XacroValue> items, XacroBudget& budget);
/// A key that appears twice has its last value.
XacroValue XacroDictOf(std::vector<std::pair<XacroValue, XacroValue>> entries, XacroBudget& budget);

/// "text", "list" and so on, for messages.
std::string XacroKind(const XacroValue& value);

/// Whether Python takes the value for true.
bool XacroTruth(const XacroValue& value);

/// The number of a number or truth value.
std::optional<double> XacroNumber(const XacroValue& value);

/// Whether two values are equal: 1 == 1.0 == True, and a text equals no number.
bool XacroEqual(const XacroValue& a, const XacroValue& b, XacroBudget& budget);

/// The value as Python's str() prints it: 1, 0.1, 1e-05, True, None, [1, 'a'], {'a': 1}. A number reads back exactly.
std::string XacroPrinted(const XacroValue& value, XacroBudget& budget);

/// The number of a text as Python's int() and float() read it, with spaces around; nothing for any other text.
std::optional<std::int64_t> XacroWholeOf(const std::string& text);
std::optional<double> XacroRealOf(const std::string& text);

/// What the text of a property or parameter stands for: 'text' in single quotes is that text, a number or truth value
/// is itself, and any other text stays as it is.
XacroValue XacroLiteral(const std::string& text);

}  // namespace gaitwright
