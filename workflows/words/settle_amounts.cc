// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/settle_amounts.h"

#include <cmath>

namespace gaitwright::words {
namespace {

void Rename(const std::string& from, const std::string& to, Draft& draft) {
  draft.parameters[to] = draft.parameters[from];
  draft.said[to] = draft.said[from];
  draft.parameters.erase(from);
  draft.said.erase(from);
}

void SettleTurn(Draft& draft) {
  const auto direction = draft.parameters.find("direction");
  const bool round = direction != draft.parameters.end() && direction->second == TaskValue(std::string("backward"));
  if (round) {  // "向后——转"
    direction->second = std::string("left");
    draft.parameters.try_emplace("angle_deg", 180.0);
  }
  const auto angle = draft.parameters.find("angle_deg");
  const bool either = angle != draft.parameters.end() && std::fmod(std::get<double>(angle->second), 180.0) == 0.0;
  const bool unsided = !draft.side && !draft.parameters.contains("direction");
  if (unsided && either) draft.parameters["direction"] = std::string("left");
  if (!draft.parameters.contains("times")) return;
  constexpr double kWhole = 360.0;
  const double once = draft.said.contains("angle_deg") ? std::get<double>(draft.parameters.at("angle_deg")) : kWhole;
  const int times = std::get<int>(draft.parameters.at("times"));
  Rename("times", "angle_deg", draft);
  draft.parameters["angle_deg"] = once * times;
}

}  // namespace

double RoundedAmount(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

void SettleAmounts(Draft& draft) {
  if (draft.action == "turn") SettleTurn(draft);
  if (draft.action == "walk" && draft.parameters.contains("times") && !draft.parameters.contains("steps"))
    Rename("times", "steps", draft);
  if (draft.action != "squat" || !draft.parameters.contains("distance_m")) return;
  Rename("distance_m", "depth_m", draft);
  if (draft.last_key == "distance_m") draft.last_key = "depth_m";
}

}  // namespace gaitwright::words
