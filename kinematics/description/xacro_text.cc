// SPDX-License-Identifier: BSD-3-Clause
// Texts with `${expression}` and `$(substitution)`.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "kinematics/base/text.h"
#include "kinematics/description/xacro_evaluate_internal.h"

namespace gaitwright {
namespace {

/// Position after the bracket that closes the bracket at `open`; npos if there is none. Skips nested brackets of the
/// same kind and, if `quotes`, texts in quotes.
std::size_t BehindXacroBracket(const std::string& text, std::size_t open, bool quotes) {
  const char opening = text[open], closing = opening == '{' ? '}' : ')';
  int level = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (quotes && (text[at] == '\'' || text[at] == '"')) {
      at = text.find(text[at], at + 1);
      if (at == std::string::npos) return at;
    } else if (text[at] == opening) {
      ++level;
    } else if (text[at] == closing && --level == 0) {
      return at + 1;
    }
  }
  return std::string::npos;
}

/// The end of an expression or substitution that begins at `at`. If quotes do not match, the next bracket ends it, so
/// that the message shows only the expression.
std::size_t XacroPieceEnd(const std::string& text, std::size_t at) {
  const bool quotes = text[at + 1] == '{' || std::string_view(text).substr(at).starts_with("$(eval");
  std::size_t end = quotes ? BehindXacroBracket(text, at + 1, true) : std::string::npos;
  if (end == std::string::npos) end = BehindXacroBracket(text, at + 1, false);
  if (end == std::string::npos) {
    throw XacroProblem{
        FailureCode::kXacroSyntax,
        fmt::format("'{}' has no closing '{}'; write a literal '${}' as '$${}'", Shortened(text.substr(at)),
                    text[at + 1] == '{' ? '}' : ')', text[at + 1], text[at + 1])};
  }
  return end;
}

std::vector<std::string> XacroWordsOf(const std::string& text) {
  std::vector<std::string> words;
  constexpr const char* kBlanks = " \t\r\n";
  for (std::size_t from = text.find_first_not_of(kBlanks); from != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, from), text.size());
    words.push_back(text.substr(from, end - from));
    from = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::string PrintedXacroText(const std::string& text, XacroContext& context) {
  return text.find('$') == std::string::npos ? text : XacroPrinted(EvaluateXacroText(text, context), context.budget);
}

XacroValue XacroSubstitutionPiece(const std::string& inside, XacroContext& context) {
  const std::string text = PrintedXacroText(inside, context);
  std::vector<std::string> words = XacroWordsOf(text);
  if (words.empty()) throw XacroProblem{FailureCode::kUnknownSubstitution, "'$()' is empty"};
  const std::string command = words[0];
  if (command == "eval") return context.EvalSubstitution(Trimmed(text.substr(text.find("eval") + 4)));
  words.erase(words.begin());
  return {context.Substitution(command, words)};
}

/// Start of the next piece, which is one or more '$' followed by a bracket; npos if there is none.
std::size_t NextXacroPiece(const std::string& text, std::size_t from) {
  for (std::size_t at = text.find('$', from); at != std::string::npos; at = text.find('$', at + 1)) {
    const std::size_t behind = text.find_first_not_of('$', at);
    if (behind == std::string::npos) return behind;
    if (text[behind] == '{' || text[behind] == '(') return at;
    at = behind - 1;
  }
  return std::string::npos;
}

}  // namespace

XacroValue EvaluateXacroText(const std::string& text, XacroContext& context) {
  const XacroBudget::Level level(context.budget);
  context.budget.Spend(1 + text.size() / 16);
  std::string joined;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t piece = std::min(NextXacroPiece(text, at), text.size());
    joined.append(text, at, piece - at);
    at = piece;
    if (piece == text.size()) break;
    if (text[piece + 1] == '$') {  // an escape: drop one '$' and copy the bracket as text
      const std::size_t bracket = text.find_first_not_of('$', piece);
      joined.append(text, piece + 1, bracket - piece);
      at = bracket + 1;
      continue;
    }
    at = XacroPieceEnd(text, piece);
    const std::string inside = text.substr(piece + 2, at - piece - 3);
    XacroValue value = text[piece + 1] == '{' ? EvaluateXacro(PrintedXacroText(inside, context), context)
                                              : XacroSubstitutionPiece(inside, context);
    if (piece == 0 && at == text.size()) return value;
    joined += XacroPrinted(value, context.budget);
    if (joined.size() > kLongestXacroText) break;
  }
  return XacroText(std::move(joined));
}

}  // namespace gaitwright
