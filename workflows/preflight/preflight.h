// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/audit/audit.h"
#include "workflows/study/trial_conditions.h"
#include "workflows/study/trials_result.h"

namespace gaitwright {

/// Conditions for running a plan on a robot.
struct PreflightOptions {
  double least_survival = 0.9;
  int fewest_trials = 0;

  OptionFields Fields() {
    return {{"fewest_trials", &fewest_trials, "1", 0.0, 1e6,
             "Smallest number of trials for a go decision; 0 requires none."},
            {"least_survival", &least_survival, "1", 0.0, 1.0,
             "Smallest survival rate for a go decision with trials; the lower end of its 95 % interval must reach this "
             "value."}};
  }
};

/// Inputs of a preflight, in addition to robot and plan.
struct PreflightInput {
  AuditOptions audit;  ///< margins are always computed, regardless of these options
  PreflightOptions options;
  std::optional<TrialsResult> trials;
  std::string approach;  ///< a sentence on the approach to the first posture, or why there is none; "" if not requested
};

/// Data of the page that an engineer signs before a plan runs on a robot.
struct Preflight {
  std::string robot, robot_hash, program_version, made_by, motion;
  std::string plan_hash;        ///< MotionHash, as in the plan's logs
  std::string whole_plan_hash;  ///< PlanHash: identifies the signed plan
  double duration_s = 0.0, mass_kg = 0.0;
  AuditReport audit;  ///< with margins
  std::optional<TrialsResult> trials;
  std::vector<OptionChange> trial_conditions;  ///< TrialConditions
  double least_survival = 0.0;                 ///< share of trials that must survive for a go
  int fewest_trials = 0;                       ///< number of trials needed for a go
  bool start_measured = false;
  std::vector<std::string> reasons;      ///< reasons for a no-go; empty for a go
  std::vector<std::string> remarks;      ///< remarks that do not prevent a go
  std::vector<std::string> assumptions;  ///< assumptions: ground, friction, placeholder limits
  std::vector<std::string> not_checked;  ///< parts that were not checked, and why

  bool go() const { return reasons.empty(); }
};

/// Audits the plan with margins and collects all results. The verdict is a go if the audit passes (with the measured
/// start posture, if given) and, if there is a result of trials, the lower end of the survival interval is high enough;
/// trials with identical logs count once. Failure: the plan does not fit the robot, or the trials belong to another
/// plan (even if only the ground differs) or another robot (the message names both hashes).
Result<Preflight> MakePreflight(const RobotModel& model, const MotionPlan& plan, const PreflightInput& input);

/// The page as text.
std::string PreflightText(const Preflight& preflight);

/// The page as JSON (docs/json-output.md). @param files  as "files": kind and path.
std::string PreflightJson(const Preflight& preflight,
                          const std::vector<std::pair<std::string, std::string>>& files = {});

/// The page as self-contained HTML (well-formed XML) for printing on A4.
std::string PreflightPage(const Preflight& preflight);

/// Name of a check in words, such as "joint torque".
std::string LawWords(Law law);

/// "487 of 500 trials survived: 97.4 % (95 % interval 95.6 to 98.5 %)"; counts only different trials if some repeat
/// others.
std::string SurvivalText(const TrialsResult& trials);

/// The sentence on the trials that passed every gate.
std::string PassText(const TrialsResult& trials);

/// "a go requires a survival rate of at least 90 % (lower end of the 95 % interval)".
std::string ThresholdText(const Preflight& preflight);

}  // namespace gaitwright
