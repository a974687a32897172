// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "kinematics/base/file.h"
#include "kinematics/base/text.h"

namespace gaitwright {
namespace {

/// Number of characters of a cell that a message shows.
constexpr std::size_t kShown = 40;

std::string Shown(const std::string& cell) { return cell.size() <= kShown ? cell : FirstBytes(cell, kShown) + "..."; }

/// Iterates over the lines of a text, without line ends.
class Lines {
 public:
  explicit Lines(const std::string& text) : text_(text) {}

  bool Next(std::string& line) {
    if (at_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line.assign(text_, at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at_ = end + 1;
    ++number_;
    return true;
  }
  int number() const { return number_; }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// Comma, semicolon or tab: the most frequent one outside quotes.
char DelimiterOf(const std::string& line) {
  int commas = 0, semicolons = 0, tabs = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    commas += c == ',' ? 1 : 0;
    semicolons += c == ';' ? 1 : 0;
    tabs += c == '\t' ? 1 : 0;
  }
  if (semicolons > commas && semicolons >= tabs) return ';';
  return tabs > commas ? '\t' : ',';
}

/// The text of a quoted cell; moves `at` from the opening quote to the character after the closing quote.
std::string Unquoted(const std::string& line, std::size_t& at, int number) {
  std::string cell;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      cell += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      cell += line[at++];
    } else {
      ++at;
      return cell;
    }
  }
  throw InvalidArgument(fmt::format("line {}: a quote (\") is not closed; a cell must end on its line", number));
}

/// Splits a line into cells. @throws InvalidArgument for an unclosed quote, text after a closing quote, and too many
/// cells.
void SplitCells(const std::string& line, char delimiter, int number, std::vector<std::string>& cells) {
  cells.clear();
  const auto blank = [&](std::size_t i) { return line[i] == ' ' || (line[i] == '\t' && delimiter != '\t'); };
  for (std::size_t at = 0; at <= line.size();) {
    if (cells.size() > static_cast<std::size_t>(kMostCsvColumns))
      throw InvalidArgument(fmt::format("line {}: more than {} columns", number, kMostCsvColumns));
    while (at < line.size() && blank(at)) ++at;
    if (at < line.size() && line[at] == '"') {
      cells.push_back(Unquoted(line, at, number));
      while (at < line.size() && blank(at)) ++at;
      if (at < line.size() && line[at] != delimiter)
        throw InvalidArgument(fmt::format("line {}, cell {}: text after a closing quote", number, cells.size()));
    } else {
      const std::size_t end = std::min(line.find(delimiter, at), line.size());
      cells.push_back(Trimmed(line.substr(at, end - at)));
      at = end;
    }
    ++at;
  }
}

std::optional<double> ValueOf(const std::string& cell) {
  const char* first = cell.data();
  const char* const last = cell.data() + cell.size();
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') ++first;
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc{} && end == last) return std::isfinite(value) ? std::optional(value) : std::nullopt;
  if (cell.size() > 5) return std::nullopt;
  const std::string lower = LowerCase(cell);
  if (lower == "true") return 1.0;
  if (lower == "false") return 0.0;
  return std::nullopt;
}

bool AllNumbers(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
    double value = 0.0;
    const auto parsed = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return parsed.ec == std::errc{} && parsed.ptr == cell.data() + cell.size();
  });
}

/// Reads a table line by line.
class CsvReader {
 public:
  CsvReader(const std::string& text, CsvTable& table, bool numbered = false)
      : lines_(text), table_(table), numbered_(numbered) {}

  /// Whether the first line that is not a comment has only numbers, and no comment before it names them.
  bool LacksNames() {
    if (!NextLine()) return false;
    delimiter_ = DelimiterOf(line_);
    SplitCells(line_, delimiter_, lines_.number(), cells_);
    if (cells_.size() > 1 && cells_.back().empty()) cells_.pop_back();
    std::vector<std::string> names;
    SplitCells(comment_, DelimiterOf(comment_), lines_.number(), names);
    return AllNumbers(cells_) && (comment_.empty() || names.size() != cells_.size() || AllNumbers(names));
  }

  void Read() {
    if (!NextLine()) throw InvalidArgument("is empty; its first line must name the columns");
    ReadNames();
    do {
      ReadRow();
    } while (NextLine());
    if (trailing_) {  // every line ends in a delimiter
      table_.columns.pop_back();
    }
    if (table_.lines.empty()) throw InvalidArgument("has no row of numbers below the column names");
  }

 private:
  /// Goes to the next line that is neither empty nor a comment; keeps the last comment before it.
  bool NextLine() {
    comment_.clear();
    while (lines_.Next(line_)) {
      const std::string trimmed = Trimmed(line_);
      if (trimmed.empty()) continue;
      if (trimmed[0] != '#') return true;
      comment_ = trimmed.substr(1);
    }
    line_.clear();
    return false;
  }

  void ReadNames() {
    delimiter_ = DelimiterOf(line_);
    SplitCells(line_, delimiter_, lines_.number(), cells_);
    std::vector<std::string> names = cells_;
    if (numbered_) {
      header_is_comment_ = true;  // the first line is a row
      for (std::size_t i = 0; i < names.size(); ++i) names[i] = std::to_string(i + 1);
      if (names.size() > 1 && cells_.back().empty()) names.pop_back();
      names_line_ = lines_.number();
      TakeNames(names);
      return;
    }
    header_is_comment_ = AllNumbers(cells_);
    if (header_is_comment_) {
      SplitCells(comment_, DelimiterOf(comment_), lines_.number(), names);
      if (comment_.empty() || names.size() != cells_.size() || AllNumbers(names)) {
        throw InvalidArgument(
            fmt::format("line {} contains only numbers; the first line must name the columns", lines_.number()));
      }
    }
    names_line_ = lines_.number();
    trailing_ = !header_is_comment_ && names.size() > 1 && names.back().empty();
    TakeNames(names);
  }

  void TakeNames(const std::vector<std::string>& names) {
    std::map<std::string, std::size_t> seen;
    const std::size_t named = names.size() - (trailing_ ? 1 : 0);
    if (named > static_cast<std::size_t>(kMostCsvColumns))
      throw InvalidArgument(fmt::format("line {}: more than {} columns", names_line_, kMostCsvColumns));
    for (std::size_t i = 0; i < named; ++i) {
      if (names[i].empty()) throw InvalidArgument(fmt::format("line {}: column {} has no name", names_line_, i + 1));
      const auto [before, fresh] = seen.emplace(names[i], i + 1);
      if (!fresh) {
        throw InvalidArgument(fmt::format("line {}: columns {} and {} are both named '{}'", names_line_, before->second,
                                          i + 1, Shown(names[i])));
      }
    }
    table_.columns = names;
  }

  void ReadRow() {
    if (first_ && !header_is_comment_) {
      first_ = false;
      return;
    }
    first_ = false;
    const int number = lines_.number();
    SplitCells(line_, delimiter_, number, cells_);
    const std::size_t named = table_.columns.size() - (trailing_ ? 1 : 0);
    if (cells_.size() == named + 1 && cells_.back().empty()) cells_.pop_back();
    if (cells_.size() != named) {
      throw InvalidArgument(
          fmt::format("line {} has {} cells, but line {} names {} columns", number, cells_.size(), names_line_, named));
    }
    for (std::size_t i = 0; i < named; ++i) {
      const std::optional<double> value = ValueOf(cells_[i]);
      if (!value) Refuse(i, number);
      table_.values.push_back(*value);
    }
    table_.lines.push_back(number);
    if (table_.lines.size() > static_cast<std::size_t>(kMostCsvRows))
      throw InvalidArgument(fmt::format("line {}: more than {} rows", number, kMostCsvRows));
    if (table_.values.size() > static_cast<std::size_t>(kMostCsvCells))
      throw InvalidArgument(fmt::format("line {}: more than {} cells", number, kMostCsvCells));
  }

  [[noreturn]] void Refuse(std::size_t column, int number) const {
    const std::string& cell = cells_[column];
    const std::string why =
        cell.empty() ? "is empty; each cell must hold a number"
                     : fmt::format("contains '{}', which is not a finite number{}", Shown(cell),
                                   cell.find(',') == std::string::npos ? "" : "; write decimals with a point");
    throw InvalidArgument(
        fmt::format("line {}, column {} '{}' {}", number, column + 1, Shown(table_.columns[column]), why));
  }

  Lines lines_;
  CsvTable& table_;
  std::string line_, comment_;
  std::vector<std::string> cells_;
  char delimiter_ = ',';
  int names_line_ = 0;
  bool trailing_ = false, header_is_comment_ = false, first_ = true;
  const bool numbered_;
};

}  // namespace

int CsvTable::Find(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

std::vector<double> CsvTable::Column(int column) const {
  std::vector<double> all(lines.size());
  for (int row = 0; row < rows(); ++row) all[static_cast<std::size_t>(row)] = At(row, column);
  return all;
}

std::string CsvTable::Place(int row, int column) const {
  return fmt::format("line {}, column {} '{}'", lines[static_cast<std::size_t>(row)], column + 1,
                     Shown(columns[static_cast<std::size_t>(column)]));
}

Result<CsvTable> ParseCsvTable(const std::string& text, const std::string& source) {
  CsvTable table;
  table.source = source;
  try {
    CsvReader(text, table).Read();
  } catch (const InvalidArgument& error) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kCsv, "ReadCsvTable", fmt::format("'{}': {}", source, error.what()), {}};
  }
  return table;
}

bool LacksColumnNames(const std::string& text) {
  CsvTable ignored;
  try {
    return CsvReader(text, ignored).LacksNames();
  } catch (const InvalidArgument&) {
    return false;  // the reader reports what is wrong
  }
}

Result<CsvTable> ParseNumberTable(const std::string& text, const std::string& source) {
  CsvTable table;
  table.source = source;
  try {
    CsvReader(text, table, true).Read();
  } catch (const InvalidArgument& error) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kCsv, "ReadCsvTable", fmt::format("'{}': {}", source, error.what()), {}};
  }
  return table;
}

Result<CsvTable> ReadCsvTable(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return ParseCsvTable(*text, path);
}

}  // namespace gaitwright
