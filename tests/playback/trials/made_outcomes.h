// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <vector>

#include "playback/trials/robustness_report.h"

namespace gaitwright::made {

/// Trials that fall if a lateral push exceeds `fatal_n`; every seventh of the others violates a gate.
inline std::vector<TrialOutcome> Outcomes(int n, double fatal_n) {
  std::vector<TrialOutcome> outcomes;
  for (int i = 0; i < n; ++i) {
    NamedRandom random(static_cast<std::uint64_t>(i), "made");
    const double size = 50.0 * random.Uniform(), angle = 360.0 * random.Uniform(), mass = random.Uniform();
    const double left = size * std::sin(angle * 0.017453292519943295);
    TrialOutcome o;
    o.number = i;
    o.seed = SeedOfTrial(0, i);
    o.survived = std::abs(left) <= fatal_n;
    o.passed = o.survived && i % 7 != 0;
    o.score = o.passed ? 70.0 + mass : (o.survived ? 40.0 : 10.0 + mass);
    o.ended_s = o.survived ? 5.0 : 2.2 + 0.005 * i;  // soon after the push
    o.cause = o.survived ? (o.passed ? "" : "goal_error_m") : "a foot slid";
    o.reason = "under <a push> it \"fell\" & more";
    o.log_hash = fmt::format("{:016x}", i);
    o.sampled = {{"mass_scale", "1", mass, ""},
                 {"push1.size_n", "N", size, ""},
                 {"push1.direction_deg", "deg", angle, ""},
                 {"push1.ahead_n", "N", size * std::cos(angle * 0.017453292519943295), ""},
                 {"push1.left_n", "N", left, ""},
                 {"push1.at_s", "s", 2.0, ""},
                 {"push1.duration_s", "s", 0.1, ""},
                 {"push1.place", "", 0.0, i % 2 == 0 ? "base" : "robot"}};
    o.metrics = {{"fell", o.survived ? 0.0 : 1.0}, {"goal_error_m", 0.001 * i}, {"slip_max_step_m", std::nullopt}};
    o.gates = {"fell", "goal_error_m"};
    if (!o.passed) o.broken_gates = {o.survived ? "goal_error_m" : "fell"};
    outcomes.push_back(o);
  }
  return outcomes;
}

inline TrialSubject Subject() {
  TrialSubject subject;
  subject.robot = "made";
  subject.robot_hash = "r";
  subject.plan_hash = "p";
  subject.controller = "stabilised";
  subject.disturbances = "mass_scale: 1\n";
  subject.limits = {{"fell", 0.0}, {"goal_error_m", 0.05}};
  return subject;
}

}  // namespace gaitwright::made
