// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/docstrings.h"

#include <cctype>
#include <regex>
#include <sstream>

namespace gaitwright::architecture {
namespace {

struct Scope {
  enum class Kind { kNames, kClass, kInside } kind = Kind::kNames;
  bool shown = true;       ///< declarations in it are visible from outside
  bool ends = true;        ///< its closing brace ends the statement that opened it
  std::string class_name;  ///< of a class
  int last_line = -2;      ///< last line of the last statement in it
  bool last_documented = false;
};

/// Reads a header character by character; tracks comments, brackets and the starts of statements.
class Reader {
 public:
  explicit Reader(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines_.push_back(line);
  }

  std::vector<std::string> Run() {
    scopes_.push_back({});
    for (line_ = 0; line_ < static_cast<int>(lines_.size()); ++line_) {
      const std::string code = CodeOf(lines_[static_cast<std::size_t>(line_)]);
      if (code.empty() || code[0] == '#') continue;
      if (IsAccess(code)) continue;
      for (const char c : code) Take(c);
      if (!statement_.empty()) statement_ += ' ';
    }
    return found_;
  }

 private:
  static std::string Trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
  }

  /// A line without its comment and without quoted text.
  static std::string CodeOf(const std::string& line) {
    static const std::regex quoted(R"("(\\.|[^"\\])*"|'(\\.|[^'\\])')");
    const std::string bare = std::regex_replace(line, quoted, "0");
    return Trimmed(bare.substr(0, bare.find("//")));
  }

  bool IsAccess(const std::string& code) {
    if (code != "public:" && code != "private:" && code != "protected:") return false;
    scopes_.back().shown = code == "public:";
    return true;
  }

  void Take(char c) {
    Scope& scope = scopes_.back();
    if (scope.kind == Scope::Kind::kInside) {
      if (c == '{') scopes_.push_back({Scope::Kind::kInside, false, false, "", -2, false});
      if (c == '}') Close();
      return;
    }
    if (statement_.empty() && (c == ' ' || c == ';')) return;
    if (c == '(') ++round_;
    if (c == ')') --round_;
    if (c == '}' && round_ == 0) return Close();
    if (statement_.empty()) Begin();
    if (round_ == 0 && c == ';') return End();
    if (round_ == 0 && c == '{') return Open();
    statement_ += c;
  }

  void Begin() {
    const Scope& scope = scopes_.back();
    const std::string above = line_ > 0 ? Trimmed(lines_[static_cast<std::size_t>(line_) - 1]) : "";
    first_line_ = line_;
    documented_ = above.rfind("///", 0) == 0 || (scope.last_line == line_ - 1 && scope.last_documented);
  }

  void End() {
    if (scopes_.back().kind != Scope::Kind::kInside) CheckFunction();
    scopes_.back().last_line = line_;
    scopes_.back().last_documented = documented_;
    statement_.clear();
  }

  void Open() {
    static const std::regex names(R"(^(inline )?namespace\b(.*))"),
        type(R"(^(template ?<.*> ?)?(struct|class|enum)\b(.*))");
    std::smatch match;
    if (std::regex_match(statement_, match, names)) {
      const bool named = !Trimmed(match[2]).empty();
      scopes_.push_back({named ? Scope::Kind::kNames : Scope::Kind::kInside, true, true, "", -2, false});
      statement_.clear();
    } else if (std::regex_match(statement_, match, type) && statement_.find('(') == std::string::npos) {
      const bool is_enum = match[2] == "enum", nested = scopes_.back().kind == Scope::Kind::kClass;
      if (!documented_ && scopes_.back().shown && !(is_enum && nested)) Note(Trimmed(statement_));
      scopes_.push_back({is_enum ? Scope::Kind::kInside : Scope::Kind::kClass,
                         scopes_.back().shown && match[2] == "struct", true, NameOf(match[3]), -2, false});
      statement_.clear();
    } else {
      const bool value = statement_.find('=') != std::string::npos && statement_.find('(') == std::string::npos;
      if (!value) CheckFunction();
      scopes_.push_back({Scope::Kind::kInside, false, !value, "", -2, false});
    }
  }

  void Close() {
    const bool ends = scopes_.back().ends;
    if (scopes_.size() > 1) scopes_.pop_back();
    Scope& scope = scopes_.back();
    if (scope.kind == Scope::Kind::kInside || !ends) return;
    scope.last_line = line_;
    scope.last_documented = documented_;
    statement_.clear();
  }

  static std::string NameOf(const std::string& after_keyword) {
    static const std::regex word(R"([A-Za-z_]\w*)");
    std::string name;
    std::string rest = after_keyword.substr(0, after_keyword.find(':'));
    for (std::sregex_iterator it(rest.begin(), rest.end(), word), end; it != end; ++it) {
      if (it->str() != "final") name = it->str();
    }
    return name;
  }

  void CheckFunction() {
    static const std::regex left_out(
        R"(\boverride\b|= ?default|= ?delete|\boperator\b|~|^(using|friend|static_assert|typedef)\b)");
    const Scope& scope = scopes_.back();
    const auto bracket = statement_.find('(');
    const auto equals = statement_.find('=');
    if (documented_ || !scope.shown || bracket == std::string::npos || equals < bracket) return;
    if (std::regex_search(statement_, left_out)) return;
    const std::string name = NameOf(statement_.substr(0, bracket));
    const bool accessor =
        name.empty() || std::islower(static_cast<unsigned char>(name[0])) != 0 || name.find('_') != std::string::npos;
    if (accessor || name == scope.class_name || name == "Fields") return;
    Note((scope.class_name.empty() ? "" : scope.class_name + "::") + name);
  }

  void Note(const std::string& what) { found_.push_back(std::to_string(first_line_ + 1) + ": " + what); }

  std::vector<std::string> lines_, found_;
  std::vector<Scope> scopes_;
  std::string statement_;
  int line_ = 0, first_line_ = 0, round_ = 0;
  bool documented_ = false;
};

}  // namespace

std::vector<std::string> WithoutDocstring(const std::string& header_text) { return Reader(header_text).Run(); }

}  // namespace gaitwright::architecture
