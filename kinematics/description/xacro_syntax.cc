// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_syntax_internal.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLongestXacroExpression = 65536;  // [byte]
constexpr int kDeepestXacroExpression = 64;

XacroNode XacroNodeOf(XacroNodeKind kind, std::vector<XacroNode> children, std::vector<std::string> operators = {},
                      std::string text = "") {
  return {kind, std::move(text), {}, std::move(children), std::move(operators)};
}

XacroNode XacroConstantOf(XacroValue value) { return {XacroNodeKind::kConstant, "", std::move(value), {}, {}}; }

/// Reads an expression by recursive descent, with one function for each precedence of operators.
class XacroParser {
 public:
  explicit XacroParser(const std::string& text) : tokens_(XacroTokens(text)) {}

  XacroNode Whole() {
    XacroNode node = Expression();
    while (Is(",")) {  // a tuple without parentheses
      std::vector<XacroNode> items;
      items.push_back(std::move(node));
      while (Take(",")) {
        if (!IsEnd()) items.push_back(Expression());
      }
      node = XacroNodeOf(XacroNodeKind::kList, std::move(items));
    }
    if (!IsEnd()) Refuse();
    return node;
  }

 private:
  using Rank = XacroNode (XacroParser::*)();

  const XacroToken& Token() const { return tokens_[at_]; }
  bool IsEnd() const { return Token().kind == XacroToken::Kind::kEnd; }
  /// Whether the current token is this operator or word.
  bool Is(std::string_view text) const {
    return (Token().kind == XacroToken::Kind::kOperator || Token().kind == XacroToken::Kind::kName) &&
           Token().text == text;
  }
  bool Take(std::string_view text) {
    if (!Is(text)) return false;
    ++at_;
    return true;
  }
  void Need(std::string_view text) {
    if (!Take(text)) Refuse(fmt::format("; '{}' is needed", text));
  }

  [[noreturn]] void Refuse(const std::string& more = "") const {
    if (IsEnd()) throw XacroProblem{FailureCode::kXacroSyntax, "the expression ends too early" + more};
    throw XacroProblem{FailureCode::kXacroSyntax, fmt::format("unexpected {}'{}' at character {}{}",
                                                              Token().kind == XacroToken::Kind::kText ? "text " : "",
                                                              Shortened(Token().text), Token().at + 1, more)};
  }

  /// Counts the depth of nested expressions.
  struct Deeper {
    explicit Deeper(int& depth) : level(depth) {
      if (level >= kDeepestXacroExpression) {
        throw XacroProblem{FailureCode::kXacroLimit,
                           fmt::format("more than {} nested expressions", kDeepestXacroExpression)};
      }
      ++level;
    }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --level; }
    int& level;
  };

  XacroNode Expression() {
    const Deeper deeper(depth_);
    XacroNode value = Or();
    if (!Take("if")) return value;
    XacroNode condition = Or();
    Need("else");
    XacroNode other = Expression();
    std::vector<XacroNode> parts;
    parts.push_back(std::move(condition));
    parts.push_back(std::move(value));
    parts.push_back(std::move(other));
    return XacroNodeOf(XacroNodeKind::kChoice, std::move(parts));
  }

  /// Operands of the next precedence, joined by these operators.
  XacroNode Joined(XacroNodeKind kind, std::initializer_list<std::string_view> joints, Rank next) {
    std::vector<XacroNode> operands;
    operands.push_back((this->*next)());
    std::vector<std::string> operators;
    const auto is_joint = [&] {
      return std::any_of(joints.begin(), joints.end(), [&](std::string_view joint) { return Is(joint); });
    };
    while (is_joint()) {
      operators.push_back(Token().text);
      ++at_;
      operands.push_back((this->*next)());
    }
    return operators.empty() ? std::move(operands.front())
                             : XacroNodeOf(kind, std::move(operands), std::move(operators));
  }

  XacroNode Or() { return Joined(XacroNodeKind::kOr, {"or"}, &XacroParser::And); }
  XacroNode And() { return Joined(XacroNodeKind::kAnd, {"and"}, &XacroParser::Not); }

  XacroNode Unary(Rank operand) {
    const Deeper deeper(depth_);
    const std::string sign = Token().text;
    ++at_;
    std::vector<XacroNode> child;
    child.push_back((this->*operand)());
    return XacroNodeOf(XacroNodeKind::kUnary, std::move(child), {sign});
  }

  XacroNode Not() { return Is("not") ? Unary(&XacroParser::Not) : Comparison(); }

  /// Takes the operator of a comparison, which has one or two words; "" if there is none.
  std::string TakeComparison() {
    for (const std::string_view known : {"<", ">", "<=", ">=", "==", "!=", "in"}) {
      if (Take(known)) return std::string(known);
    }
    if (Take("is")) return Take("not") ? "is not" : "is";
    if (!Take("not")) return "";
    Need("in");
    return "not in";
  }

  XacroNode Comparison() {
    std::vector<XacroNode> operands;
    operands.push_back(Sum());
    std::vector<std::string> operators;
    for (std::string joint = TakeComparison(); !joint.empty(); joint = TakeComparison()) {
      operators.push_back(joint);
      operands.push_back(Sum());
    }
    if (operators.empty()) return std::move(operands.front());
    return XacroNodeOf(XacroNodeKind::kCompare, std::move(operands), std::move(operators));
  }

  XacroNode Sum() { return Joined(XacroNodeKind::kChain, {"+", "-"}, &XacroParser::Product); }
  XacroNode Product() { return Joined(XacroNodeKind::kChain, {"*", "/", "//", "%"}, &XacroParser::Signed); }
  XacroNode Signed() { return Is("-") || Is("+") ? Unary(&XacroParser::Signed) : Power(); }

  XacroNode Power() {
    XacroNode base = Primary();
    if (!Take("**")) return base;
    const Deeper deeper(depth_);
    std::vector<XacroNode> parts;
    parts.push_back(std::move(base));
    parts.push_back(Signed());
    return XacroNodeOf(XacroNodeKind::kPower, std::move(parts));
  }

  /// An atom with its members, indices and calls.
  XacroNode Primary() {
    constexpr int kMostSuffixes = 32;
    XacroNode node = Atom();
    for (int i = 0; Is(".") || Is("[") || Is("("); ++i) {
      if (i == kMostSuffixes)
        throw XacroProblem{FailureCode::kXacroLimit,
                           fmt::format("more than {} members and indices in a row", kMostSuffixes)};
      std::vector<XacroNode> parts;
      parts.push_back(std::move(node));
      if (Take(".")) {
        if (Token().kind != XacroToken::Kind::kName) Refuse("; the name of a member is needed");
        node = XacroNodeOf(XacroNodeKind::kMember, std::move(parts), {}, Token().text);
        ++at_;
      } else {
        node = Take("[") ? Subscript(std::move(parts)) : Call(std::move(parts));
      }
    }
    return node;
  }

  XacroNode Subscript(std::vector<XacroNode> parts) {
    const bool from_start = Is(":");
    parts.push_back(from_start ? XacroConstantOf({}) : Expression());
    if (!Take(":")) {
      Need("]");
      return XacroNodeOf(XacroNodeKind::kIndex, std::move(parts));
    }
    parts.push_back(Is("]") ? XacroConstantOf({}) : Expression());
    Need("]");
    return XacroNodeOf(XacroNodeKind::kSlice, std::move(parts));
  }

  XacroNode Call(std::vector<XacroNode> parts) {
    std::vector<std::string> keywords;
    Need("(");
    while (!Is(")")) {
      std::string keyword;
      if (Token().kind == XacroToken::Kind::kName && tokens_[at_ + 1].text == "=" &&
          tokens_[at_ + 1].kind == XacroToken::Kind::kOperator) {
        keyword = Token().text;
        at_ += 2;
      }
      bool comprehension = false;
      parts.push_back(ItemOrComprehension(comprehension));
      keywords.push_back(keyword);
      if (!Take(",")) break;
    }
    Need(")");
    return XacroNodeOf(XacroNodeKind::kCall, std::move(parts), std::move(keywords));
  }

  /// An expression, or `EXPRESSION for NAME in LIST [if CONDITION]`; the latter sets `comprehension`.
  XacroNode ItemOrComprehension(bool& comprehension) {
    XacroNode item = Expression();
    if (!Take("for")) return item;
    comprehension = true;
    if (Token().kind != XacroToken::Kind::kName) Refuse("; the name of a variable is needed");
    const std::string variable = Token().text;
    ++at_;
    Need("in");
    std::vector<XacroNode> parts;
    parts.push_back(std::move(item));
    parts.push_back(Or());
    parts.push_back(Take("if") ? Or() : XacroConstantOf({true}));
    return XacroNodeOf(XacroNodeKind::kComprehension, std::move(parts), {}, variable);
  }

  /// Takes the items up to a closing bracket and the bracket. A single comprehension is the list itself.
  XacroNode Items(std::string_view close, bool one_is_itself) {
    std::vector<XacroNode> items;
    bool comma = false, comprehension = false;  // with a comma, a comprehension is an item of a list
    while (!Is(close)) {
      items.push_back(ItemOrComprehension(comprehension));
      comma = Take(",");
      if (!comma) break;
    }
    Need(close);
    const bool single = items.size() == 1 && !comma;
    if (single && (one_is_itself || comprehension)) return std::move(items[0]);
    return XacroNodeOf(XacroNodeKind::kList, std::move(items));
  }

  XacroNode Dict() {
    std::vector<XacroNode> parts;
    while (!Is("}")) {
      parts.push_back(Expression());
      Need(":");
      parts.push_back(Expression());
      if (!Take(",")) break;
    }
    Need("}");
    return XacroNodeOf(XacroNodeKind::kDict, std::move(parts));
  }

  XacroNode Atom() {
    const XacroToken token = Token();
    if (token.kind == XacroToken::Kind::kNumber) {
      ++at_;
      return XacroConstantOf(token.value);
    }
    if (token.kind == XacroToken::Kind::kText) {
      std::string text;
      for (; Token().kind == XacroToken::Kind::kText; ++at_) text += Token().text;
      return XacroConstantOf(XacroText(text));
    }
    if (token.kind == XacroToken::Kind::kName) return Word(token);
    if (Take("(")) return Items(")", true);
    if (Take("[")) return Items("]", false);
    if (Take("{")) return Dict();
    Refuse();
  }

  XacroNode Word(const XacroToken& token) {
    for (const std::string_view word : {"if", "else", "and", "or", "not", "in", "is", "for"}) {
      if (token.text == word) Refuse();
    }
    if (token.text == "lambda") Refuse("; functions cannot be defined");
    ++at_;
    if (token.text == "True") return XacroConstantOf({true});
    if (token.text == "False") return XacroConstantOf({false});
    if (token.text == "None") return XacroConstantOf({});
    return XacroNodeOf(XacroNodeKind::kName, {}, {}, token.text);
  }

  std::vector<XacroToken> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

XacroNode ParseXacroExpression(const std::string& expression) {
  if (expression.size() > kLongestXacroExpression) {
    throw XacroProblem{FailureCode::kXacroLimit, fmt::format("an expression has {} bytes; at most {} are read",
                                                             expression.size(), kLongestXacroExpression)};
  }
  return XacroParser(expression).Whole();
}

}  // namespace gaitwright
