// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Size limits of a table.
inline constexpr int kMostCsvRows = 1'000'000, kMostCsvColumns = 1'000, kMostCsvCells = 20'000'000;

/// A table of finite numbers with named columns.
struct CsvTable {
  std::string source;                ///< the file, for messages
  std::vector<std::string> columns;  ///< unique names, none empty
  std::vector<double> values;        ///< row-major
  std::vector<int> lines;            ///< line number of each row in its file, from 1

  int rows() const { return static_cast<int>(lines.size()); }
  int num_columns() const { return static_cast<int>(columns.size()); }
  /// The value in a row and column, both from 0.
  double At(int row, int column) const {
    return values[static_cast<std::size_t>(row) * columns.size() + static_cast<std::size_t>(column)];
  }

  /// Index of the column with this name, or -1.
  int Find(const std::string& name) const;
  /// All values of a column.
  std::vector<double> Column(int column) const;
  /// The position of a cell for messages: "line 12, column 3 'q_hip_rad'".
  std::string Place(int row, int column) const;
};

/// Reads a table from the text of a CSV file.
///
/// The first line that is not a comment names the columns; the other lines have one number per column. The delimiter
/// is the most frequent one of the first line: comma, semicolon or tab. Cells may have spaces around them and may be in
/// double quotes, with `""` for a quote; lines may end in CR LF; empty lines and lines that begin with # are ignored.
/// If the first line that is not a comment has only numbers, the comment right before it names the columns, as written
/// by NumPy. A delimiter at the end of every line is ignored. Numbers are decimal with a point, whatever the machine's
/// language; `true` and `false` are 1 and 0. Failure kBadInput `csv`, which names the source, line and column, for: no
/// names, an empty or duplicate name, a row of another length, a cell that is not a finite number, an unclosed quote,
/// no rows, and more than kMostCsvRows, kMostCsvColumns or kMostCsvCells.
Result<CsvTable> ParseCsvTable(const std::string& text, const std::string& source);

/// Whether the first line of numbers in a text has no line of names before it.
bool LacksColumnNames(const std::string& text);

/// Reads such a table: its columns are named by their numbers, from 1. Failures as of ParseCsvTable.
Result<CsvTable> ParseNumberTable(const std::string& text, const std::string& source);

/// Reads a table from a file in UTF-8, with or without a byte-order mark; failures as of ParseCsvTable.
Result<CsvTable> ReadCsvTable(const std::string& path);

}  // namespace gaitwright
