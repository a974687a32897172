// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 6: first the candidates that the geometry allows, then the cheapest of them in physics.
//   trot trot.yaml
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/file.h"
#include "workflows/walk/walk.h"

namespace {

using namespace gaitwright;

constexpr double kTopSpeed = 0.9;  // [m/s]
constexpr double kLeastClearance = 0.035, kMostSpeedUse = 0.85;
constexpr double kLongestStance = 0.33;  // [m], length of a stance at the top speed: 0.8 leg lengths
constexpr double kShortestSwing = 0.2;   // [s]

/// Cycle times and duty factors with stances short enough for the leg and swings slow enough for the joints.
std::vector<OptionTexts> Candidates() {
  std::vector<OptionTexts> candidates;
  for (const double cycle_s : {0.4, 0.45, 0.5, 0.55}) {
    for (const double duty : {0.55, 0.6}) {
      if (duty * cycle_s * kTopSpeed > kLongestStance || (1.0 - duty) * cycle_s < kShortestSwing) continue;
      candidates.push_back({{"gait.cycle_s", fmt::format("{}", cycle_s)},
                            {"gait.duty_factor", fmt::format("{}", duty)},
                            {"swing.height_m", "0.08"}});
    }
  }
  return candidates;
}

/// Plans a trot and plays it in physics.
Result<PlayedWalk> Tried(const RobotModel& model, const OptionTexts& options, double speed_m_s) {
  WalkRequest request;
  request.gait = "trot";
  request.command.speed_m_s = speed_m_s;
  request.command.distance_m = 1.5;
  OptionFields fields = request.Fields();
  for (const auto& [key, text] : options) SetOption(fields, key, text);
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  if (!planned) return planned.failure();
  const PlayRequest as_usual;
  return PlayWalk(model, planned->motion.plan, as_usual);
}

/// Cost of transport at the top speed; infinite if a limit is violated.
double Cost(const RobotModel& model, const OptionTexts& options) {
  const Result<PlayedWalk> played = Tried(model, options, kTopSpeed);
  if (!played || !played->report.pass) return HUGE_VAL;
  const auto value = [&](const char* key) { return played->report.At(key).value.value_or(HUGE_VAL); };
  const bool kept = value("clearance_min_m") >= kLeastClearance && value("joint_speed_use_max") <= kMostSpeedUse;
  return kept ? value("cost_of_transport") : HUGE_VAL;
}

}  // namespace

int main(int argc, char** argv) {
  const Result<RobotModel> model = ChooseRobot("a1", "");
  if (!model) return 1;
  OptionTexts best;
  double least = HUGE_VAL;
  for (const OptionTexts& options : Candidates()) {
    const double cost = Cost(*model, options);
    fmt::print("cycle {} s, duty factor {}: {:.3f}\n", options[0].second, options[1].second, cost);
    if (cost < least) best = options;
    least = std::min(least, cost);
  }

  std::string yaml;
  for (const auto& [key, text] : best) yaml += fmt::format("{}: {}\n", key, text);
  const Result<std::string> written = WriteFileAtomically(argc > 1 ? argv[1] : "trot.yaml", yaml);
  if (!written) fmt::print(stderr, "trot: {}\n", written.failure().message);
  return written ? 0 : 1;
}
