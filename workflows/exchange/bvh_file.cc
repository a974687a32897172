// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "kinematics/base/result.h"
#include "kinematics/base/text.h"
#include "workflows/exchange/bvh_file_internal.h"
#include "workflows/exchange/csv_table.h"

namespace gaitwright {
namespace {

constexpr std::array<const char*, 6> kChannelNames = {"Xposition", "Yposition", "Zposition",
                                                      "Xrotation", "Yrotation", "Zrotation"};

/// Words of a text with the numbers of their lines.
class BvhWords {
 public:
  explicit BvhWords(std::string_view text) : text_(text) {}

  /// The next word; "" at the end.
  std::string_view Next() {
    while (at_ < text_.size() && IsSpace(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
    const std::size_t from = at_;
    while (at_ < text_.size() && !IsSpace(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }

  /// The rest of the line, without spaces at its ends: names may have spaces inside.
  std::string RestOfLine() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    at_ = end;
    while (!rest.empty() && IsSpace(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && IsSpace(rest.back())) rest.remove_suffix(1);
    return std::string(rest);
  }

  void Expect(std::string_view word) {
    const std::string_view found = Next();
    if (LowerCase(std::string(found)) != LowerCase(std::string(word)))
      Refuse(fmt::format("'{}' is expected", word), found);
  }

  double Number() {
    const std::string_view word = Next();
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      Refuse("a finite number is expected", word);
    return value;
  }

  int Whole(int lowest, int highest) {
    const double value = Number();
    if (!(value >= lowest && value <= highest) || value != std::floor(value))
      Fail(fmt::format("{:.12g} is given; a whole number from {} to {} is needed", value, lowest, highest));
    return static_cast<int>(value);
  }

  [[noreturn]] void Refuse(const std::string& expected, std::string_view found) const {
    constexpr std::size_t kShown = 40;
    Fail(found.empty() ? expected + ", but the file ends"
                       : fmt::format("{}, found '{}'", expected, found.substr(0, kShown)));
  }
  [[noreturn]] void Fail(const std::string& why) const {
    throw InvalidArgument(fmt::format("line {}: {}", line_, why));
  }
  int line() const { return line_; }

 private:
  static bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

class BvhParser {
 public:
  explicit BvhParser(const std::string& text) : words_(text) {}

  BvhFile Run() {
    words_.Expect("HIERARCHY");
    words_.Expect("ROOT");
    BeginJoint(-1);
    ReadJoints();
    ReadMotion();
    return std::move(file_);
  }

 private:
  static constexpr int kMostJoints = 1000;

  void BeginJoint(int parent) {
    BvhJoint joint;
    joint.name = words_.RestOfLine();
    joint.parent = parent;
    if (joint.name.empty()) words_.Fail("the joint has no name");
    if (file_.joints.size() == kMostJoints) words_.Fail(fmt::format("it has more than {} joints", kMostJoints));
    for (const BvhJoint& other : file_.joints) {
      if (other.name == joint.name) words_.Fail(fmt::format("the joint '{}' is given twice", joint.name));
    }
    words_.Expect("{");
    words_.Expect("OFFSET");
    for (double& part : joint.offset) part = words_.Number();
    joint.first_channel = file_.columns;
    file_.joints.push_back(std::move(joint));
  }

  void ReadChannels(BvhJoint& joint) {
    if (!joint.channels.empty()) words_.Fail(fmt::format("the joint '{}' has channels twice", joint.name));
    const int count = words_.Whole(0, 6);
    for (int i = 0; i < count; ++i) {
      const std::string word = LowerCase(std::string(words_.Next()));
      const auto found = std::find_if(kChannelNames.begin(), kChannelNames.end(),
                                      [&](const char* name) { return LowerCase(name) == word; });
      if (found == kChannelNames.end()) words_.Refuse("a channel such as 'Xrotation' is expected", word);
      const int channel = static_cast<int>(found - kChannelNames.begin());
      if (std::find(joint.channels.begin(), joint.channels.end(), channel) != joint.channels.end())
        words_.Fail(fmt::format("the channel '{}' of joint '{}' is given twice", *found, joint.name));
      joint.channels.push_back(channel);
    }
    joint.first_channel = file_.columns;
    file_.columns += count;
  }

  /// Reads up to the end of the root.
  void ReadJoints() {
    for (int at = 0; at >= 0;) {
      const std::string word = LowerCase(std::string(words_.Next()));
      if (word == "channels") {
        ReadChannels(file_.joints[static_cast<std::size_t>(at)]);
      } else if (word == "joint") {
        BeginJoint(at);
        at = static_cast<int>(file_.joints.size()) - 1;
      } else if (word == "end") {
        words_.Expect("Site");
        words_.Expect("{");
        words_.Expect("OFFSET");
        for (int i = 0; i < 3; ++i) words_.Number();
        words_.Expect("}");
      } else if (word == "}") {
        at = file_.joints[static_cast<std::size_t>(at)].parent;
      } else {
        words_.Refuse("'CHANNELS', 'JOINT', 'End Site' or '}' is expected", word);
      }
    }
  }

  void ReadMotion() {
    words_.Expect("MOTION");
    words_.Expect("Frames:");
    const int frames = words_.Whole(1, kMostCsvRows);
    words_.Expect("Frame");
    words_.Expect("Time:");
    file_.step_s = words_.Number();
    if (!(file_.step_s >= 1e-4 && file_.step_s <= 1.0))
      words_.Fail(fmt::format("the frame time is {:.6g} s; accepted: 0.0001 to 1", file_.step_s));
    if (file_.columns == 0) words_.Fail("the skeleton has no channels");
    for (int frame = 0; frame < frames; ++frame) ReadFrame(frame, frames);
    if (const std::string_view more = words_.Next(); !more.empty())
      words_.Refuse(fmt::format("the end after {} frames is expected", frames), more);
  }

  /// A frame is a line, so that a missing value is found where it is.
  void ReadFrame(int frame, int frames) {
    int line = 0;
    for (int column = 0; column < file_.columns; ++column) {
      const double value = words_.Number();
      if (column > 0 && words_.line() != line) {
        words_.Fail(fmt::format("frame {} of {} has {} values; its skeleton has {} channels", frame + 1, frames, column,
                                file_.columns));
      }
      line = words_.line();
      file_.values.push_back(value);
    }
  }

  BvhWords words_;
  BvhFile file_;
};

}  // namespace

Vector3 BvhFile::PositionOf(int joint, int frame) const {
  const BvhJoint& one = joints[static_cast<std::size_t>(joint)];
  Vector3 position = one.offset;
  for (std::size_t i = 0; i < one.channels.size(); ++i) {
    if (one.channels[i] < 3)
      position[one.channels[i]] = values[static_cast<std::size_t>(frame * columns + one.first_channel) + i];
  }
  return position;
}

Matrix3 BvhFile::RotationOf(int joint, int frame, double radians) const {
  const BvhJoint& one = joints[static_cast<std::size_t>(joint)];
  Matrix3 rotation = Matrix3::Identity();
  for (std::size_t i = 0; i < one.channels.size(); ++i) {
    if (one.channels[i] < 3) continue;
    const double angle = radians * values[static_cast<std::size_t>(frame * columns + one.first_channel) + i];
    rotation = rotation * Eigen::AngleAxisd(angle, Vector3::Unit(one.channels[i] - 3)).toRotationMatrix();
  }
  return rotation;
}

BvhFile ParseBvh(const std::string& text) { return BvhParser(text).Run(); }

}  // namespace gaitwright
