// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_file.h"

#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

/// Collects the keys of the outermost object and the text of `format`; stops when the kind is known.
class Keys : public nlohmann::json_sax<nlohmann::ordered_json> {
 public:
  std::string format;
  bool metrics = false, verdict = false, n = false, survived = false, survival = false, joint_names = false;

  bool null() override { return Value(); }
  bool boolean(bool /*value*/) override { return Value(); }
  bool number_integer(number_integer_t /*value*/) override { return Value(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return Value(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return Value(); }
  bool binary(binary_t& /*value*/) override { return Value(); }
  bool string(string_t& value) override {
    if (depth_ == 1 && key_ == "format") {
      format = value;
      return false;
    }
    return Value();
  }
  bool start_object(std::size_t /*size*/) override {
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool start_array(std::size_t /*size*/) override {
    ++depth_;
    return true;
  }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool key(string_t& name) override {
    joint_names = name == "joint_names" && (depth_ == 1 || (depth_ == 2 && key_ == "trajectory"));
    if (depth_ == 1) {
      key_ = name;
      metrics = metrics || name == "metrics";
      verdict = verdict || name == "verdict";
      n = n || name == "n";
      survived = survived || name == "survived";
      survival = survival || name == "survival";
    }
    return !joint_names;
  }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::ordered_json::exception& /*why*/) override {
    return false;
  }

 private:
  static bool Value() { return true; }

  int depth_ = 0;
  std::string key_;
};

/// Whether a line of a YAML text begins with this key.
bool BeginsALine(const std::string& text, const std::string& key) {
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t before = text.find_last_not_of(" \t", at == 0 ? std::string::npos : at - 1);
    if (at == 0 || before == std::string::npos || text[before] == '\n') return true;
  }
  return false;
}

}  // namespace

MotionFileKind KindOfText(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || text[first] != '{')
    return BeginsALine(text, "joint_names:") ? MotionFileKind::kTrajectory : MotionFileKind::kTable;
  Keys keys;
  nlohmann::ordered_json::sax_parse(text, &keys);
  if (keys.format == "gaitwright-motion-plan") return MotionFileKind::kPlan;
  if (keys.format == "gaitwright-playback-log") return MotionFileKind::kLog;
  if (keys.joint_names) return MotionFileKind::kTrajectory;
  if (keys.n && keys.survived && keys.survival) return MotionFileKind::kTrials;
  return keys.format.empty() && keys.metrics && keys.verdict ? MotionFileKind::kReport : MotionFileKind::kJson;
}

const char* NameOf(MotionFileKind kind) {
  switch (kind) {
    case MotionFileKind::kPlan:
      return "a plan";
    case MotionFileKind::kLog:
      return "a log";
    case MotionFileKind::kReport:
      return "a report";
    case MotionFileKind::kTrials:
      return "a result of trials";
    case MotionFileKind::kJson:
      return "JSON of another kind";
    case MotionFileKind::kTrajectory:
      return "a joint trajectory";
    case MotionFileKind::kTable:
      break;
  }
  return "no JSON";
}

}  // namespace gaitwright
