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

/// When a plan may go on a robot.
struct PreflightOptions {
  double least_survival = 0.9;
  int fewest_trials = 0;

  OptionFields Fields() {
    return {{"fewest_trials", &fewest_trials, "1", 0.0, 1e6, "Trials that a go needs; 0: it may do without.", {}},
            {"least_survival",
             &least_survival,
             "1",
             0.0,
             1.0,
             "Share that must survive for a go, where there are trials: the lower end of its 95 % interval.",
             {}}};
  }
};

/// What a preflight is made from, beside robot and plan.
struct PreflightInput {
  AuditOptions audit;  ///< margins are taken whatever it says
  PreflightOptions options;
  std::optional<TrialsResult> trials;
  std::string approach;  ///< a sentence on the way to the first posture, or why there is none; "" if not asked for
};

/// The page that an engineer signs before a plan goes on a robot, as data.
struct Preflight {
  std::string robot, robot_hash, program_version, made_by, motion;
  std::string plan_hash;        ///< MotionHash: that of the plan's logs
  std::string whole_plan_hash;  ///< PlanHash: what is signed
  double duration_s = 0.0, mass_kg = 0.0;
  AuditReport audit;  ///< with margins
  std::optional<TrialsResult> trials;
  std::vector<OptionChange> trial_conditions;  ///< TrialConditions
  double least_survival = 0.0;                 ///< share of trials that must survive for a go
  int fewest_trials = 0;                       ///< trials that a go needs
  bool start_measured = false;
  std::vector<std::string> reasons;      ///< why it is no go; empty for a go
  std::vector<std::string> remarks;      ///< what to mind though it is a go
  std::vector<std::string> assumptions;  ///< what is taken for granted: ground, friction, limits that are placeholders
  std::vector<std::string> not_checked;  ///< what nobody looked at, and why

  bool go() const { return reasons.empty(); }
};

/// Audits the plan with its margins and puts everything together. It is a go where the audit passes (with the measured
/// start posture, if one is given) and, where there is a result of trials, these leave no doubt that enough survive;
/// of trials with one and the same log one counts.
/// Failure: the plan does not fit the robot; the trials are of another plan, be it the ground alone that is another, or
/// of another robot (both hashes are named).
Result<Preflight> MakePreflight(const RobotModel& model, const MotionPlan& plan, const PreflightInput& input);

/// The page as text.
std::string PreflightText(const Preflight& preflight);

/// The page as JSON (docs/json-output.md). @param files  as "files": kind and path.
std::string PreflightJson(const Preflight& preflight,
                          const std::vector<std::pair<std::string, std::string>>& files = {});

/// The page as HTML, whole by itself, well-formed XML, and to be printed on A4.
std::string PreflightPage(const Preflight& preflight);

/// A law in words, as "joint torque".
std::string LawWords(Law law);

/// "487 of 500 trials survived: 97.4 %, and with 95 % certainty from 95.6 to 98.5 %"; where trials repeat others, of
/// those that differ.
std::string SurvivalText(const TrialsResult& trials);

/// The same of those that passed every gate.
std::string PassText(const TrialsResult& trials);

/// "a go asks that 90 % survive, with 95 % certainty".
std::string ThresholdText(const Preflight& preflight);

}  // namespace gaitwright
