// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "workflows/repair/clip_table_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json ClipJson(const ClipOutcome& c) {
  return {{"clip", c.clip},
          {"verdict", ClipVerdictName(c.verdict)},
          {"duration_s", c.duration_s},
          {"broken_share", c.broken_share},
          {"broken", c.broken},
          {"violations", c.violations},
          {"joint_rms_rad", c.joint_rms_rad},
          {"joint_largest_rad", c.joint_largest_rad},
          {"base_rms_m", c.base_rms_m},
          {"slowed_s", c.slowed_s},
          {"left_out_s", c.left_out_s},
          {"reason", c.reason},
          {"plan", c.plan}};
}

/// @throws std::runtime_error for another name.
ClipVerdict VerdictOfName(const std::string& name) {
  for (const ClipVerdict verdict : {ClipVerdict::kRefused, ClipVerdict::kFail, ClipVerdict::kPass}) {
    if (name == ClipVerdictName(verdict)) return verdict;
  }
  throw std::runtime_error("a line of the journal has an unknown verdict");
}

std::string QuotedCell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::ptrdiff_t CountOf(const std::vector<ClipOutcome>& clips, ClipVerdict verdict) {
  return std::count_if(clips.begin(), clips.end(), [&](const ClipOutcome& c) { return c.verdict == verdict; });
}

}  // namespace

const char* ClipVerdictName(ClipVerdict verdict) {
  switch (verdict) {
    case ClipVerdict::kRefused:
      return "refused";
    case ClipVerdict::kFail:
      return "fail";
    case ClipVerdict::kPass:
      return "pass";
  }
  return "";
}

std::string LineOf(const ClipOutcome& outcome) {
  return ClipJson(outcome).dump(-1, ' ', false, Json::error_handler_t::replace);
}

ClipOutcome ClipOfLine(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    ClipOutcome c;
    json.at("clip").get_to(c.clip);
    c.verdict = VerdictOfName(json.at("verdict").get<std::string>());
    json.at("duration_s").get_to(c.duration_s);
    json.at("broken_share").get_to(c.broken_share);
    json.at("broken").get_to(c.broken);
    json.at("violations").get_to(c.violations);
    json.at("joint_rms_rad").get_to(c.joint_rms_rad);
    json.at("joint_largest_rad").get_to(c.joint_largest_rad);
    json.at("base_rms_m").get_to(c.base_rms_m);
    json.at("slowed_s").get_to(c.slowed_s);
    json.at("left_out_s").get_to(c.left_out_s);
    json.at("reason").get_to(c.reason);
    json.at("plan").get_to(c.plan);
    return c;
  } catch (const Json::exception&) {
    throw std::runtime_error("a line of the journal is not the outcome of a clip");
  }
}

std::string ClipsText(const std::vector<ClipOutcome>& clips) {
  std::size_t width = 4;
  for (const ClipOutcome& c : clips) width = std::max(width, c.clip.size());
  std::string text =
      fmt::format("{:<{}}  {:<7}  {:>7}  {:>6}  {:>8}  {:>10}  {:>9}  {}\n", "clip", width, "verdict", "broken",
                  "slowed", "left out", "joints RMS", "base RMS", "check that the file fails longest; reason");
  for (const ClipOutcome& c : clips) {
    text += fmt::format("{:<{}}  {:<7}  {:>5.1f} %  {:>4.1f} s  {:>6.1f} s  {:>6.3f} rad  {:>6.1f} mm  {}{}{}\n",
                        c.clip, width, ClipVerdictName(c.verdict), 100.0 * c.broken_share, c.slowed_s, c.left_out_s,
                        c.joint_rms_rad, 1e3 * c.base_rms_m, c.broken, c.broken.empty() || c.reason.empty() ? "" : "; ",
                        c.reason);
  }
  return text + fmt::format("{} of {} pass, {} fail, {} refused\n", CountOf(clips, ClipVerdict::kPass), clips.size(),
                            CountOf(clips, ClipVerdict::kFail), CountOf(clips, ClipVerdict::kRefused));
}

std::string ClipsCsv(const std::vector<ClipOutcome>& clips) {
  std::string text =
      "clip,verdict,duration_s,broken_share,broken,violations,joint_rms_rad,joint_largest_rad,base_rms_m,slowed_s,"
      "left_out_s,reason,plan\n";
  for (const ClipOutcome& c : clips) {
    text += fmt::format("{},{},{:.6g},{:.6g},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n", QuotedCell(c.clip),
                        ClipVerdictName(c.verdict), c.duration_s, c.broken_share, c.broken, c.violations,
                        c.joint_rms_rad, c.joint_largest_rad, c.base_rms_m, c.slowed_s, c.left_out_s,
                        QuotedCell(c.reason), QuotedCell(c.plan));
  }
  return text;
}

std::string ClipsJson(const RobotModel& model, const std::vector<ClipOutcome>& clips, const std::string& table_path) {
  Json list = Json::array();
  for (const ClipOutcome& c : clips) list.push_back(ClipJson(c));
  const bool all = CountOf(clips, ClipVerdict::kPass) == static_cast<std::ptrdiff_t>(clips.size());
  const Json json = {{"robot", model.name},
                     {"verdict", all ? "pass" : "fail"},
                     {"passed", CountOf(clips, ClipVerdict::kPass)},
                     {"clips", list},
                     {"files", {{"table", table_path}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gaitwright
