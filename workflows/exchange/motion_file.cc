// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_file.h"

#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

/// Sees the keys of the outermost object and the text of `format`; stops reading when it knows.
class Keys : public nlohmann::json_sax<nlohmann::json> {
 public:
  std::string format;
  bool metrics = false, verdict = false;

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
    if (depth_ == 1) {
      key_ = name;
      metrics = metrics || name == "metrics";
      verdict = verdict || name == "verdict";
    }
    return true;
  }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*why*/) override {
    return false;
  }

 private:
  static bool Value() { return true; }

  int depth_ = 0;
  std::string key_;
};

}  // namespace

MotionFileKind KindOfText(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || text[first] != '{') return MotionFileKind::kTable;
  Keys keys;
  nlohmann::json::sax_parse(text, &keys);
  if (keys.format == "gaitwright-motion-plan") return MotionFileKind::kPlan;
  if (keys.format == "gaitwright-playback-log") return MotionFileKind::kLog;
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
    case MotionFileKind::kJson:
      return "JSON of another kind";
    case MotionFileKind::kTable:
      break;
  }
  return "no JSON";
}

}  // namespace gaitwright
