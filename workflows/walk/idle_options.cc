// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/idle_options.h"

#include <fmt/format.h>

#include <algorithm>

namespace gaitwright {
namespace {

/// Options that act through another one.
struct Rule {
  std::string keys;     ///< what they begin with
  std::string through;  ///< what the other begins with
  bool acts;            ///< as it is set
  std::string why, hint;
};

std::vector<Rule> RulesFor(const PlayRequest& request) {
  const std::string& state = request.sensing.state;
  const WorldOptions& world = request.play.world;
  const bool slopes = world.ground_slope_deg != 0.0, bumpy = world.ground_bumps_m != 0.0;
  const bool pushes = !request.play.push_force_W.isZero(0.0);
  const std::string without_bumps = "without 'ground_bumps_m'", give_bumps = "give 'ground_bumps_m' too";
  return {{"sensors.", "state", state != StateSourceNames().front(),
           "as the controller has the true state: no sensor is read", "--state estimated, or measured"},
          {"odometry.", "state", state == StateSourceNames().back(), fmt::format("with the state '{}'", state),
           "--state estimated"},
          {"stabilised.sensed_damping", "state", state != StateSourceNames().front(), "with the true state",
           "--state estimated, or measured"},
          {"stabilised.", "controller", request.controller == "stabilised",
           fmt::format("on the controller '{}'", request.controller), "--controller stabilised"},
          {"play.ground_slope_direction_deg", "play.ground_slope_deg", slopes, "without 'ground_slope_deg'",
           "give 'ground_slope_deg' too"},
          {"play.bump_", "play.ground_bumps_m", bumpy, without_bumps, give_bumps},
          {"play.push_at_s", "play.push_force", pushes, "without a push", "give --push too"},
          {"play.push_for_s", "play.push_force", pushes, "without a push", "give --push too"},
          {"play.push_on", "play.push_force", pushes, "without a push", "give --push too"}};
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
