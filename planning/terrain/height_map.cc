// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/height_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "kinematics/base/file.h"
#include "kinematics/base/text.h"
#include "planning/terrain/read_png.h"
#include "planning/terrain/sense.h"

namespace gaitwright {
namespace {

constexpr std::size_t kLargestTable = std::size_t{128} << 20;  // [byte]

Failure RefusedHeights(const std::string& path, const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kTerrainFile, "ReadHeightMap", fmt::format("'{}' {}", path, why), {}};
}

/// Numbers by row from the top, and the file line of each row.
struct Table {
  std::vector<std::vector<double>> rows;
  std::vector<int> lines;
};

/// The numbers of a line. @throws InvalidArgument that names the cell without a valid number.
std::vector<double> ParseRow(const std::string& line, int number) {
  std::vector<double> row;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    const std::string cell = Trimmed(line.substr(at, comma - at));
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) {
      throw InvalidArgument(
          fmt::format("line {}, cell {}: '{}' is not a finite number", number, row.size() + 1, Shortened(cell)));
    }
    row.push_back(value);
    if (row.size() > static_cast<std::size_t>(kMostNodes))
      throw InvalidArgument(fmt::format("line {}: more than {} cells", number, kMostNodes));
    at = comma + 1;
  }
  return row;
}

/// @throws InvalidArgument if the text is not a table of numbers.
Table ParseCsv(const std::string& text) {
  Table table;
  std::istringstream stream(text);
  std::string line;
  std::size_t cells = 0;
  for (int number = 1; std::getline(stream, line); ++number) {
    line = Trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    table.rows.push_back(ParseRow(line, number));
    table.lines.push_back(number);
    if (table.rows.back().size() != table.rows.front().size()) {
      throw InvalidArgument(fmt::format("line {} has {} cells; the first row, line {}, has {}", number,
                                        table.rows.back().size(), table.lines.front(), table.rows.front().size()));
    }
    cells += table.rows.back().size();
    if (cells > static_cast<std::size_t>(kMostNodes))
      throw InvalidArgument(fmt::format("line {}: more than {} cells", number, kMostNodes));
  }
  return table;
}

Table ToTable(const GreyImage& image) {
  Table table;
  for (int row = 0; row < image.rows; ++row) {
    const auto first = image.values.begin() + static_cast<std::ptrdiff_t>(row) * image.columns;
    table.rows.emplace_back(first, first + image.columns);
    for (double& value : table.rows.back()) value /= image.full;
    table.lines.push_back(row + 1);
  }
  return table;
}

/// @throws InvalidArgument that names the first cell with an implausible height.
void CheckHeights(const Table& table, double scale_m, const char* line) {
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const std::vector<double>& row = table.rows[r];
    for (std::size_t c = 0; c < row.size(); ++c) {
      const double height = scale_m * row[c];
      const auto refuse = [&](const std::string& why) {
        throw InvalidArgument(
            fmt::format("{} {}, cell {}: the height is {:.6g} m, {}; heights are cell values times scale_m, in metres",
                        line, table.lines[r], c + 1, height, why));
      };
      if (std::abs(height) > kHighest) refuse(fmt::format("accepted: {} to {} m", -kHighest, kHighest));
      const double before = c > 0 ? row[c - 1] : row[c], above = r > 0 ? table.rows[r - 1][c] : row[c];
      const double step = std::abs(scale_m) * std::max(std::abs(row[c] - before), std::abs(row[c] - above));
      if (step > kSteepestStep)
        refuse(fmt::format("a step of {:.6g} m from the cell before; at most {} m is accepted", step, kSteepestStep));
    }
  }
}

HeightField ToField(const Table& table, const HeightMapOptions& options) {
  HeightField field;
  field.resolution_m = options.resolution_m;
  field.columns = static_cast<int>(table.rows[0].size());
  field.rows = static_cast<int>(table.rows.size());
  field.friction = options.friction;
  field.origin_W =
      Vector2(options.x_m, options.y_m) - 0.5 * options.resolution_m * Vector2(field.columns - 1, field.rows - 1);
  for (std::size_t row = table.rows.size(); row-- > 0;) {  // the first row has the largest y
    for (const double value : table.rows[row]) field.height_m.push_back(options.z_m + options.scale_m * value);
  }
  return field;
}

/// @throws InvalidArgument that names the missing option.
void CheckGiven(const HeightMapOptions& options, const std::string& name) {
  if (options.resolution_m == 0.0) {
    throw InvalidArgument(fmt::format(
        "needs resolution_m, the distance between neighbouring points; write '{}:resolution_m=0.02,...'", name));
  }
  if (options.scale_m == 0.0) {
    throw InvalidArgument(
        fmt::format("needs scale_m, the height of white; write '{}:resolution_m=...,scale_m=0.3'", name));
  }
}

}  // namespace

OptionFields HeightMapOptions::Fields() {
  return {{"resolution_m", &resolution_m, "m", 0.001, 1.0, "Distance between neighbouring points; required."},
          {"scale_m", &scale_m, "m", -kHighest, kHighest,
           "Height of one unit of a CSV file (usually 1), or of white in a PNG file."},
          {"x_m", &x_m, "m", -kFarthest, kFarthest, "Position of the map's centre along x."},
          {"y_m", &y_m, "m", -kFarthest, kFarthest, "Position of the map's centre along y."},
          {"z_m", &z_m, "m", -kHighest, kHighest, "Offset added to all heights."},
          {"friction", &friction, "1", 0.01, 5.0, "Friction coefficient of the ground."}};
}

Result<HeightField> ReadHeightMap(const std::string& path, const HeightMapOptions& options) {
  const std::string name = std::filesystem::path(path).filename().string();
  const bool csv = path.size() > 4 && (path.ends_with(".csv") || path.ends_with(".CSV"));
  HeightMapOptions given = options;
  if (csv && given.scale_m == 0.0) given.scale_m = 1.0;
  try {
    CheckGiven(given, name);
    CheckOptions(given.Fields());
    Table table;
    if (csv) {
      const Result<std::string> text = ReadFile(path, kLargestTable);
      if (!text) return text.failure();
      table = ParseCsv(*text);
    } else {
      const Result<GreyImage> image = ReadGreyPng(path);
      if (!image) return image.failure();
      table = ToTable(*image);
    }
    if (table.rows.size() < 2 || table.rows[0].size() < 2) {
      return RefusedHeights(path, fmt::format("has {} rows of {} cells; at least two by two are needed",
                                              table.rows.size(), table.rows.empty() ? 0 : table.rows[0].size()));
    }
    CheckHeights(table, given.scale_m, csv ? "line" : "row");
    HeightField field = ToField(table, given);
    field.name = name;
    return field;
  } catch (const InvalidArgument& error) {
    return RefusedHeights(path, error.what());
  }
}

}  // namespace gaitwright
