// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/idle_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace gaitwright {
namespace {

/// Options that have an effect only for some values of another option.
struct Rule {
  std::string keys;     ///< their prefix
  std::string through;  ///< prefix of the other option
  bool acts;            ///< whether they have an effect with its present value
  std::string why, hint;
};

std::vector<Rule> RulesFor(const PlayRequest& request) {
  const std::string& state = request.sensing.state;
  const WorldOptions& world = request.play.world;
  const bool is_true = state == StateSourceNames().front(), is_estimated = state == StateSourceNames().back();
  std::vector<Rule> rules = {
      {"sensors.", "state", !is_true, "because the controller uses the true state and no sensors",
       "give --state estimated or measured"},
      {"stabilised.sensed_damping", "state", !is_true, "with the true state", "give --state estimated or measured"},
      {"stabilised.", "controller", request.controller != "joint-pd" && request.policy == nullptr,
       fmt::format("on the controller '{}'", request.controller),
       request.policy == nullptr ? "give --controller stabilised" : "play a plan"},
      {"recovering.", "controller", request.controller == "recovering",
       fmt::format("on the controller '{}'", request.controller), "give --controller recovering"},
      {"play.ground_slope_direction_deg", "play.ground_slope_deg", world.ground_slope_deg != 0.0,
       "without 'ground_slope_deg'", "give 'ground_slope_deg' too"},
      {"play.bump_", "play.ground_bumps_m", world.ground_bumps_m != 0.0, "without 'ground_bumps_m'",
       "give 'ground_bumps_m' too"}};
  for (const char* of_feed_forward : {"gains.loss_feed_forward", "gains.friction_speed_rad_s"}) {
    rules.push_back({of_feed_forward, "controller", request.policy == nullptr,
                     "on a learned policy, which has no feed-forward", "play a plan"});
  }
  for (const char* of_estimate : {"odometry.", "sensors.imu_", "sensors.gyroscope_", "sensors.accelerometer_"}) {
    rules.push_back(
        {of_estimate, "state", is_estimated, fmt::format("with the state '{}'", state), "give --state estimated"});
  }
  for (const char* of_push : {"play.push_at_s", "play.push_for_s", "play.push_on"}) {
    rules.push_back(
        {of_push, "play.push_force", !request.play.push_force_W.isZero(0.0), "without a push", "give --push too"});
  }
  return rules;
}

}  // namespace

std::optional<IdleOption> FirstIdle(const PlayRequest& request, const std::vector<std::string>& keys,
                                    const std::vector<std::string>& open) {
  const std::vector<Rule> rules = RulesFor(request);
  for (const std::string& key : keys) {
    for (const Rule& rule : rules) {
      if (rule.acts || !key.starts_with(rule.keys)) continue;
      const bool may_act = std::any_of(open.begin(), open.end(),
                                       [&](const std::string& other) { return other.starts_with(rule.through); });
      if (!may_act) return IdleOption{key, rule.why, rule.hint + ", or leave it out"};
    }
  }
  return std::nullopt;
}

}  // namespace gaitwright
