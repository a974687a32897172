// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "kinematics/base/nearest_name.h"
#include "optimisation/numerics/halton.h"

namespace gaitwright {
namespace {

std::vector<std::string> Split(const std::string& text, char at) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, at);) words.push_back(word);
  if (text.empty() || text.back() == at) words.emplace_back();
  return words;
}

double ReadNumber(const std::string& axis, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw InvalidArgument(fmt::format("'{}': '{}' is not a finite number", axis, text));
  return value;
}

const char* FormsOf(StudyLayout layout) {
  if (layout == StudyLayout::kGrid) return "KEY=FROM:TO:COUNT or KEY=a,b,c";
  return layout == StudyLayout::kSamples ? "KEY=FROM:TO or KEY=a,b,c" : "KEY=FROM:TO";
}

[[noreturn]] void RefuseForm(const std::string& text, StudyLayout layout) {
  const char* beside = layout == StudyLayout::kGrid ? "; ranges without a count are for --samples" : "";
  throw InvalidArgument(fmt::format("'{}' is not an axis; accepted: {}{}", text, FormsOf(layout), beside));
}

OptionField& FindField(OptionFields& fields, const std::string& text, const std::string& key) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == key; });
  if (field != fields.end()) return *field;
  std::vector<std::string> keys;
  for (const OptionField& f : fields) keys.push_back(f.key);
  throw InvalidArgument(fmt::format("'{}': there is no option '{}'{}", text, key,
                                    NearestOrAll(key, keys, "--list-options=all prints all option keys")));
}

/// The value as the option writes it. @throws InvalidArgument that names the axis if the option does not accept the
/// value.
std::string Accepted(OptionField& field, const std::string& text, const std::string& value) {
  OptionFields one = {field};
  try {
    SetOption(one, field.key, value);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("'{}': {}", text, error.what()));
  }
  return OptionText(field);
}

/// Reads FROM:TO or FROM:TO:COUNT.
void ReadRange(StudyAxis& axis, OptionField& field, const std::string& text, const std::vector<std::string>& words) {
  if (!axis.numbers) {
    throw InvalidArgument(
        fmt::format("'{}': option '{}' is not a number and has no range; give single values as {}=a,b,c (for a sweep)",
                    text, axis.key, axis.key));
  }
  axis.low = ReadNumber(text, words[0]);
  axis.high = ReadNumber(text, words[1]);
  if (!(axis.low < axis.high)) {
    throw InvalidArgument(
        fmt::format("'{}': {} to {} is not a range; the first must be below the second", text, words[0], words[1]));
  }
  Accepted(field, text, words[0]);
  Accepted(field, text, words[1]);
  if (words.size() < 3) return;
  const double count = ReadNumber(text, words[2]);
  if (count != std::floor(count) || count < 2.0 || count > 10000.0)
    throw InvalidArgument(
        fmt::format("'{}': the count is {}; whole numbers from 2 to 10000 are accepted", text, words[2]));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double value = axis.low + (axis.high - axis.low) * i / (count - 1.0);
    axis.values.push_back(Accepted(field, text, fmt::format("{:.12g}", value)));
  }
}

void ReadList(StudyAxis& axis, OptionField& field, const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::string value = Accepted(field, text, word);
    if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end())
      throw InvalidArgument(fmt::format("'{}': the value {} is given twice", text, value));
    axis.values.push_back(value);
    if (!axis.numbers) continue;
    const double number = ReadNumber(text, value);
    axis.low = axis.values.size() == 1 ? number : std::min(axis.low, number);
    axis.high = axis.values.size() == 1 ? number : std::max(axis.high, number);
  }
}

}  // namespace

OptionFields CommandFields(WalkRequest& walk) {
  WalkCommand& c = walk.command;
  return {{"speed", &c.speed_m_s, "m/s", 0.0, 100.0,
           "Forward speed; 0 uses the robot's default speed if no other command is given."},
          {"lateral_speed", &c.lateral_speed_m_s, "m/s", -100.0, 100.0, "Lateral speed; positive is to the left."},
          {"yaw_rate", &c.yaw_rate_rad_s, "rad/s", -100.0, 100.0, "Yaw rate; positive is to the left."},
          {"step_length", &c.step_length_m, "m", -100.0, 100.0,
           "Forward advance in each footfall, for a walk of counted steps."}};
}

OptionFields StudyFields(WalkRequest& walk, PlayRequest& play) {
  return Joined({CommandFields(walk), walk.Fields(), play.Fields()});
}

bool IsOfCommand(const std::string& key) {
  WalkRequest walk;
  const OptionFields command = CommandFields(walk);
  return std::any_of(command.begin(), command.end(), [&](const auto& field) { return field.key == key; });
}

bool ShapesThePlan(const std::string& key) {
  PlayRequest play;
  const OptionFields of_playback = play.Fields();
  return std::none_of(of_playback.begin(), of_playback.end(), [&](const auto& field) { return field.key == key; });
}

StudyAxis ParseAxis(const std::string& text, StudyLayout layout) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) RefuseForm(text, layout);
  WalkRequest walk;
  PlayRequest play;
  OptionFields fields = StudyFields(walk, play);
  OptionField& field = FindField(fields, text, text.substr(0, equals));
  StudyAxis axis{.key = field.key, .unit = field.unit, .values = {}};
  axis.whole = std::holds_alternative<int*>(field.target);
  axis.numbers = axis.whole || std::holds_alternative<double*>(field.target);
  const std::string values = text.substr(equals + 1);
  const std::vector<std::string> words = Split(values, ':');
  if (words.size() == (layout == StudyLayout::kGrid ? 3U : 2U)) {
    ReadRange(axis, field, text, words);
  } else if (words.size() == 1 && layout != StudyLayout::kTuning) {
    ReadList(axis, field, text, Split(values, ','));
  } else {
    RefuseForm(text, layout);
  }
  return axis;
}

std::vector<StudyAxis> ParseAxes(const std::vector<std::string>& texts, StudyLayout layout) {
  if (texts.empty()) throw InvalidArgument(fmt::format("a study needs an axis: --over {}", FormsOf(layout)));
  std::vector<StudyAxis> axes;
  for (const std::string& text : texts) {
    StudyAxis axis = ParseAxis(text, layout);
    for (const StudyAxis& other : axes) {
      if (other.key == axis.key) throw InvalidArgument(fmt::format("'{}': {} is varied twice", text, axis.key));
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

double NumberOfValue(const std::string& value) { return ReadNumber("axis", value); }

std::vector<std::string> KeysOf(const std::vector<StudyAxis>& axes) {
  std::vector<std::string> keys;
  for (const StudyAxis& axis : axes) keys.push_back(axis.key);
  return keys;
}

std::vector<StudyPoint> GridPoints(const std::vector<StudyAxis>& axes) {
  std::vector<StudyPoint> points = {{}};
  for (const StudyAxis& axis : axes) {
    if (points.size() * axis.values.size() > kMostStudyPoints)
      throw InvalidArgument(fmt::format("the grid has over {} points; vary fewer options or values", kMostStudyPoints));
    std::vector<StudyPoint> longer;
    for (const StudyPoint& point : points) {
      for (const std::string& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::string ValueAt(const StudyAxis& axis, double share) {
  if (!axis.is_range()) {
    const auto count = static_cast<double>(axis.values.size());
    return axis.values[static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1.0))];
  }
  const double value = axis.low + share * (axis.high - axis.low);
  if (axis.whole) return fmt::format("{:.0f}", std::clamp(std::round(value), axis.low, axis.high));
  const double rounded = std::clamp(NumberOfValue(fmt::format("{:.6g}", value)), axis.low, axis.high);
  return fmt::format("{}", rounded);
}

std::vector<StudyPoint> SampledPoints(const std::vector<StudyAxis>& axes, std::size_t count, std::uint64_t seed) {
  if (count > kMostStudyPoints) {
    throw InvalidArgument(fmt::format("the number of samples is {}; at most {} are accepted", count, kMostStudyPoints));
  }
  std::vector<StudyPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const VectorX shares = HaltonPoint(i, static_cast<int>(axes.size()), seed);
    StudyPoint& point = points.emplace_back();
    for (std::size_t k = 0; k < axes.size(); ++k)
      point.push_back(ValueAt(axes[k], shares[static_cast<Eigen::Index>(k)]));
  }
  return points;
}

void ApplyPoint(const std::vector<StudyAxis>& axes, const StudyPoint& point, WalkRequest& walk, PlayRequest& play) {
  OptionFields fields = StudyFields(walk, play);
  for (std::size_t k = 0; k < axes.size(); ++k) SetOption(fields, axes[k].key, point[k]);
}

std::string PointText(const std::vector<StudyAxis>& axes, const StudyPoint& point) {
  std::string text;
  for (std::size_t k = 0; k < axes.size(); ++k)
    text += fmt::format("{}{}={}", k == 0 ? "" : ", ", axes[k].key, point[k]);
  return text;
}

}  // namespace gaitwright
