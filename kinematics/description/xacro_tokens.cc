// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_syntax_internal.h"

namespace gaitwright {
namespace {

bool IsXacroDigit(char c) { return c >= '0' && c <= '9'; }
bool IsXacroLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Splits an expression into tokens.
class XacroTokenizer {
 public:
  explicit XacroTokenizer(const std::string& text) : text_(text) {}

  std::vector<XacroToken> Tokens() {
    std::vector<XacroToken> tokens;
    for (SkipBlanks(); at_ < text_.size(); SkipBlanks()) tokens.push_back(Next());
    tokens.push_back({XacroToken::Kind::kEnd, "", {}, at_});
    return tokens;
  }

 private:
  char Peek(std::size_t lookahead = 0) const { return at_ + lookahead < text_.size() ? text_[at_ + lookahead] : '\0'; }

  void SkipBlanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  XacroToken Next() {
    const char c = Peek();
    if (IsXacroDigit(c) || (c == '.' && IsXacroDigit(Peek(1)))) return Number();
    if (IsXacroLetter(c)) return Name();
    if (c == '\'' || c == '"') return Text(c);
    return Operator();
  }

  XacroToken Name() {
    const std::size_t from = at_;
    while (IsXacroLetter(Peek()) || IsXacroDigit(Peek())) ++at_;
    return {XacroToken::Kind::kName, text_.substr(from, at_ - from), {}, from};
  }

  XacroToken Number() {
    const std::size_t from = at_;
    if (Peek() == '0' && (Peek(1) == 'x' || Peek(1) == 'X')) return HexNumber();
    bool real = false;
    for (;; ++at_) {
      const bool sign = (Peek() == '-' || Peek() == '+') && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
      const bool exponent =
          (Peek() == 'e' || Peek() == 'E') && (IsXacroDigit(Peek(1)) || Peek(1) == '-' || Peek(1) == '+');
      const bool point = Peek() == '.';
      if (point || exponent) real = true;
      if (!IsXacroDigit(Peek()) && Peek() != '_' && !point && !exponent && !(sign && at_ > from)) break;
    }
    const std::string written = text_.substr(from, at_ - from);
    std::string digits = written;
    std::erase(digits, '_');
    if (IsXacroLetter(Peek())) RefuseNumber(written + Peek(), from);
    XacroToken token{XacroToken::Kind::kNumber, written, {}, from};
    if (const auto whole = XacroWholeOf(digits); whole && !real) {
      token.value = {*whole};
    } else if (const auto number = XacroRealOf(digits)) {
      token.value = {*number};
    } else {
      RefuseNumber(written, from);
    }
    return token;
  }

  XacroToken HexNumber() {
    const std::size_t from = at_;
    std::int64_t number = 0;
    if (Peek(2) == '-') RefuseNumber(text_.substr(from, 3), from);
    const auto end = std::from_chars(text_.data() + at_ + 2, text_.data() + text_.size(), number, 16);
    at_ = static_cast<std::size_t>(end.ptr - text_.data());
    if (end.ec != std::errc{} || IsXacroLetter(Peek())) RefuseNumber(text_.substr(from, at_ - from + 1), from);
    return {XacroToken::Kind::kNumber, text_.substr(from, at_ - from), {number}, from};
  }

  XacroToken Text(char quote) {
    XacroToken token{XacroToken::Kind::kText, "", {}, at_};
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
        const char escaped = text_[++at_];
        constexpr std::string_view kEscapes = "nt\\'\"", kMeant = "\n\t\\'\"";
        const std::size_t known = kEscapes.find(escaped);
        if (known == std::string_view::npos) token.text += '\\';
        token.text += known == std::string_view::npos ? escaped : kMeant[known];
      } else {
        token.text += text_[at_];
      }
    }
    if (at_ >= text_.size())
      throw XacroProblem{FailureCode::kXacroSyntax,
                         fmt::format("the text that begins at character {} has no closing {}", token.at + 1, quote)};
    ++at_;
    return token;
  }

  XacroToken Operator() {
    for (const std::string_view known : {"&&", "||", "<<", ">>", ":="}) {
      if (std::string_view(text_).substr(at_, 2) != known) continue;
      throw XacroProblem{FailureCode::kXacroSyntax,
                         fmt::format("'{}' at character {} is not an operator{}", known, at_ + 1,
                                     known == "&&"   ? "; write 'and'"
                                     : known == "||" ? "; write 'or'"
                                                     : "")};
    }
    for (const std::string_view known : {"**", "//", "==", "!=", "<=", ">=", "+", "-", "*", "/", "%", "<",
                                         ">",  "(",  ")",  "[",  "]",  "{",  "}", ",", ":", ".", "="}) {
      if (std::string_view(text_).substr(at_, known.size()) != known) continue;
      at_ += known.size();
      return {XacroToken::Kind::kOperator, std::string(known), {}, at_ - known.size()};
    }
    std::size_t end = at_ + 1;  // end of a character of several bytes
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    throw XacroProblem{FailureCode::kXacroSyntax,
                       fmt::format("'{}' at character {} is not understood{}", text_.substr(at_, end - at_), at_ + 1,
                                   text_[at_] == '!'   ? "; write 'not'"
                                   : text_[at_] == '^' ? "; a power is '**'"
                                                       : "")};
  }

  [[noreturn]] static void RefuseNumber(const std::string& written, std::size_t at) {
    throw XacroProblem{FailureCode::kXacroSyntax,
                       fmt::format("'{}' at character {} is not a number", Shortened(written), at + 1)};
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<XacroToken> XacroTokens(const std::string& expression) { return XacroTokenizer(expression).Tokens(); }

}  // namespace gaitwright
