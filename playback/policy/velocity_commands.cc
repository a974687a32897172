// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "playback/policy/velocity_commands_internal.h"

namespace gaitwright {
namespace {

constexpr double kLongestCommands = 3600.0, kFastest = 100.0;
constexpr std::size_t kMostCommands = 100000;

struct CommandColumn {
  const char* key;
  double TimedCommand::*number;
};

constexpr CommandColumn kCommandColumns[] = {{"time_s", &TimedCommand::time_s},
                                             {"speed_m_s", &TimedCommand::speed_m_s},
                                             {"lateral_speed_m_s", &TimedCommand::lateral_speed_m_s},
                                             {"yaw_rate_rad_s", &TimedCommand::yaw_rate_rad_s}};

const CommandColumn& ColumnOf(const std::string& key) {
  std::vector<std::string> keys;
  for (const CommandColumn& column : kCommandColumns) {
    if (key == column.key) return column;
    keys.emplace_back(column.key);
  }
  throw InvalidArgument(fmt::format("unknown column '{}'{}", key, NearestOrAll(key, keys)));
}

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(Trimmed(cell));
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

double CellNumber(const std::string& cell, const std::string& key) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const double most = key == "time_s" ? kLongestCommands : kFastest;
  if (error != std::errc() || end != cell.data() + cell.size() || !(std::abs(number) <= most))
    throw InvalidArgument(
        fmt::format("{} is '{}'; accepted: numbers from {} to {}", key, Shortened(cell), -most, most));
  return number;
}

std::vector<TimedCommand> CsvRows(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> keys;
  std::vector<TimedCommand> rows;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (Trimmed(line).empty()) continue;
    try {
      const std::vector<std::string> cells = Cells(Trimmed(line));
      if (keys.empty()) {
        for (const std::string& key : cells) {
          if (std::find(keys.begin(), keys.end(), ColumnOf(key).key) != keys.end())
            throw InvalidArgument(fmt::format("column '{}' is given twice", key));
          keys.push_back(key);
        }
        continue;
      }
      if (cells.size() != keys.size())
        throw InvalidArgument(fmt::format("there are {} cells; the header has {}", cells.size(), keys.size()));
      rows.emplace_back();
      for (std::size_t i = 0; i < keys.size(); ++i)
        rows.back().*ColumnOf(keys[i]).number = CellNumber(cells[i], keys[i]);
      if (rows.size() > kMostCommands) throw InvalidArgument(fmt::format("there are more than {} rows", kMostCommands));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("line {}: {}", number, error.what()));
    }
  }
  if (std::find(keys.begin(), keys.end(), "time_s") == keys.end())
    throw InvalidArgument("line 1: there is no column 'time_s'");
  return rows;
}

std::vector<TimedCommand> YamlRows(const std::string& text) {
  const DataShape shape = CommandsFileShape();
  std::vector<TimedCommand> rows;
  for (const YAML::Node& node : ListOf(LoadYaml(text), "the list of commands")) {
    const YamlMap map(node, "a command", shape.of.front());
    TimedCommand command;
    for (const CommandColumn& column : kCommandColumns) command.*column.number = map.InRange(column.key).value_or(0.0);
    rows.push_back(command);
    if (rows.size() > kMostCommands) RefuseYaml(node, fmt::format("there are more than {} commands", kMostCommands));
  }
  return rows;
}

void CheckTimes(const std::vector<TimedCommand>& rows) {
  if (rows.empty()) throw InvalidArgument("contains no commands");
  if (rows.front().time_s != 0.0)
    throw InvalidArgument(fmt::format("the first command is at {} s; it must be at 0 s", rows.front().time_s));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!(rows[i].time_s > rows[i - 1].time_s))
      throw InvalidArgument(fmt::format("a command at {} s comes after one at {} s; times must increase",
                                        rows[i].time_s, rows[i - 1].time_s));
  }
}

}  // namespace

const TimedCommand& VelocityCommands::At(double time_s) const {
  constexpr double kRounding = 1e-9;
  const auto next = std::upper_bound(rows.begin(), rows.end(), time_s + kRounding,
                                     [](double time, const TimedCommand& row) { return time < row.time_s; });
  return next == rows.begin() ? rows.front() : *(next - 1);
}

DataShape CommandsFileShape() {
  using namespace shapes;
  const DataShape speed = Number(-kFastest, kFastest);
  return List(
      Object({{"time_s", Number(0.0, kLongestCommands), "Time from which the command holds; the first is 0 [s]."},
              Optional("speed_m_s", speed, "Forward speed; default 0 [m/s]."),
              Optional("lateral_speed_m_s", speed, "Lateral speed, positive to the left; default 0 [m/s]."),
              Optional("yaw_rate_rad_s", speed, "Yaw rate, positive to the left; default 0 [rad/s].")}),
      1, kMostCommands);
}

Result<VelocityCommands> ReadCommands(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kCommand,
                   "ReadCommands",
                   fmt::format("'{}': {}", source, message),
                   {"docs/policies.md describes the file of commands"}};
  };
  try {
    VelocityCommands commands;
    commands.rows = LowerCase(source).ends_with(".csv") ? CsvRows(text) : YamlRows(text);
    CheckTimes(commands.rows);
    return commands;
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

}  // namespace gaitwright
