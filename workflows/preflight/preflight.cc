// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/preflight/preflight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/version.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/model/joint_losses.h"
#include "planning/audit/joint_watch.h"
#include "planning/plan/parts_text.h"
#include "planning/plan/plan_json.h"
#include "playback/play/play.h"

namespace gaitwright {
namespace {

std::optional<Failure> CheckTrials(const RobotModel& model, const Preflight& preflight, const TrialsResult& trials) {
  const auto other = [](const std::string& what, const char* key, const std::string& theirs, const std::string& ours) {
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kTrialsResult,
        "MakePreflight",
        fmt::format("the trials are of another {}: their {} is '{}', but here it is '{}'", what, key, theirs, ours),
        {"run 'gaitwright trials' on this plan"}};
  };
  if (trials.robot_hash != model.hash) return other("robot", "robot_hash", trials.robot_hash, model.hash);
  if (trials.plan_hash != preflight.plan_hash) return other("plan", "plan_hash", trials.plan_hash, preflight.plan_hash);
  if (trials.whole_plan_hash != preflight.whole_plan_hash)
    return other("plan", "whole_plan_hash", trials.whole_plan_hash, preflight.whole_plan_hash);
  return std::nullopt;
}

std::string GroundText(const Terrain& terrain) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto add = [&](double friction) { low = std::min(low, friction), high = std::max(high, friction); };
  for (const TerrainPatch& patch : terrain.patches) add(patch.friction);
  for (const HeightField& field : terrain.height_fields) add(field.friction);
  const std::string name = terrain.name.empty() ? "of the plan" : fmt::format("'{}'", terrain.name);
  if (low > high) return fmt::format("the ground is {}, with unknown friction", name);
  return fmt::format(
      "the ground is {}, rigid and as in the plan; the assumed friction is {}", name,
      low == high ? fmt::format("{:.3g}", low) : fmt::format("{:.3g} to {:.3g}, depending on the foothold", low, high));
}

/// The shares of the limits that may be used.
std::string ReserveText(const AuditOptions& options) {
  std::string text;
  const auto add = [&](const char* what, double share) {
    if (share < 1.0) text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", what, share);
  };
  add("torque", options.derate_torque);
  add("speed", options.derate_speed);
  add("acceleration", options.derate_acceleration);
  add("jerk", options.derate_jerk);
  add("continuous torque", options.derate_continuous);
  return text.empty() ? "limits are used fully, without margin (--derate)"
                      : "these shares of the limits are used: " + text;
}

/// The losses of joints and motors that the torques include.
std::string OwnTorqueText(const RobotModel& model) {
  bool damping = false, friction = false, rotor = false;
  for (const Joint& joint : model.joints) {
    damping = damping || joint.damping > 0.0;
    friction = friction || joint.friction > 0.0;
  }
  for (int d = 0; d < model.num_dofs(); ++d) rotor = rotor || RotorInertiaAt(model, d) > 0.0;
  std::string known;
  const auto add = [&](bool is, const char* what) {
    if (is) known += (known.empty() ? "" : ", ") + std::string(what);
  };
  add(damping, "damping");
  add(friction, "dry friction");
  add(rotor, "rotor inertia");
  return known.empty() ? "joints are assumed without damping, friction and rotor inertia, because these are unknown"
                       : "torques include losses of joints and motors: " + known;
}

std::string ViolationText(const Violation& v) {
  return fmt::format("{}: {} at {:.3f} s, {} (limit {})", LawWords(v.law), v.where, v.at_s,
                     AuditFigure(v.value, v.unit), AuditFigure(v.limit, v.unit));
}

/// A share as text; `k` counts all trials, `different_k` counts trials with identical logs once.
std::string ShareText(const TrialsResult& trials, int k, int different_k, const char* what) {
  const ShareInterval share = WilsonInterval(different_k, trials.different);
  std::string text = fmt::format("{} of {} trials {}", k, trials.n, what);
  if (trials.different < trials.n) {
    text += fmt::format(", but {} only repeat others exactly; counting each once, {} of {} did",
                        trials.n - trials.different, different_k, trials.different);
  }
  return text + fmt::format(": {:.1f} % (95 % interval {:.1f} to {:.1f} %)", 100.0 * share.share, 100.0 * share.low,
                            100.0 * share.high);
}

/// Adds the reasons and remarks about the measured start posture.
void JudgeStart(const PreflightInput& input, Preflight& preflight) {
  bool moves = false, jumps = false;
  for (const Violation& v : preflight.audit.violations) {
    if (v.law != Law::kStartPosture) continue;
    if (v.where == kStartTilt) {
      preflight.remarks.push_back(
          fmt::format("the measured base is tilted by {} relative to the first command, which no joint motion can "
                      "correct: level the robot, or set it down as the plan begins, and measure again",
                      AuditFigure(v.value, v.unit)));
    } else {
      (v.where.ends_with(kStartSpeed) ? moves : jumps) = true;
    }
  }
  if (moves) {
    preflight.remarks.push_back(
        "the first command has a speed, but the measured robot is at rest: begin the plan at rest");
  }
  if (jumps) {
    preflight.remarks.push_back(
        input.approach.empty()
            ? "the first command is a jump: plan an approach with --approach FILE, run it, and measure again"
            : input.approach + "; run it, and measure again");
  } else if (!input.approach.empty()) {
    preflight.remarks.push_back(input.approach);
  }
}

void JudgeTrials(const PreflightInput& input, Preflight& preflight) {
  const int fewest = input.options.fewest_trials, differ = preflight.trials ? preflight.trials->different : 0;
  if (differ < fewest)
    preflight.reasons.push_back(fmt::format("{} different trials are required, but there are {}", fewest, differ));
  if (!preflight.trials) {
    preflight.remarks.push_back("no trials: the survival rate under disturbances is unknown");
    return;
  }
  const TrialsResult& trials = *preflight.trials;
  const ShareInterval survival = WilsonInterval(trials.different_survived, trials.different);
  const double least = input.options.least_survival;
  if (survival.share < least) {
    preflight.reasons.push_back(fmt::format("{}; at least {:.4g} % is required", SurvivalText(trials), 100.0 * least));
  } else if (survival.low < least) {
    preflight.reasons.push_back(fmt::format("the trials do not show whether {:.4g} % survive: {}; more {} may show it",
                                            100.0 * least, SurvivalText(trials),
                                            trials.different < trials.n ? "different trials" : "trials"));
  }
}

void Judge(const PreflightInput& input, Preflight& preflight) {
  constexpr std::size_t kMost = 8;
  const std::vector<Violation>& broken = preflight.audit.violations;
  for (std::size_t i = 0; i < std::min(kMost, broken.size()); ++i)
    preflight.reasons.push_back(ViolationText(broken[i]));
  if (broken.size() > kMost)
    preflight.reasons.push_back(fmt::format("and {} more violations, see the audit", broken.size() - kMost));
  for (const std::string& remark : preflight.audit.remarks) preflight.remarks.push_back(remark);
  JudgeStart(input, preflight);
  JudgeTrials(input, preflight);
}

void Assume(const RobotModel& model, const MotionPlan& plan, const PreflightInput& input, Preflight& preflight) {
  preflight.assumptions = {GroundText(plan.terrain), ReserveText(input.audit), OwnTorqueText(model)};
  preflight.assumptions.push_back(fmt::format(
      "mass, inertias and shapes are those of the URDF ({:.4g} kg), without payload or cables", model.total_mass_kg));
  for (const std::string& note : preflight.audit.notes) preflight.assumptions.push_back(note);
  for (const std::string& warning : plan.warnings) preflight.assumptions.push_back("the plan warns: " + warning);
  preflight.not_checked = UnknownOfMotors(model);
  const std::size_t left_out = CollisionChecker(model).left_out().size();
  if (left_out > 0) {
    preflight.not_checked.push_back(
        fmt::format("self_collision: {} pairs of links are not checked, because they are joined or touch in the "
                    "standing posture ('gaitwright robots show' lists them)",
                    left_out));
  }
  if (!preflight.start_measured)
    preflight.not_checked.push_back("start_posture: no measured start posture is given (--start-posture FILE)");
  if (!preflight.trials)
    preflight.not_checked.push_back("survival under disturbances: no result of trials is given (--trials-result FILE)");
  preflight.not_checked.push_back(
      "effects without a model: flexible structure and gears, motor temperature, battery voltage, and the tracking of "
      "commands by the robot's own software");
}

}  // namespace

std::string LawWords(Law law) {
  std::string words = law == Law::kZmpSupport     ? "balance (ZMP in the support)"
                      : law == Law::kUnilateral   ? "contact forces push only"
                      : law == Law::kTorqueSpeed  ? "torque at speed"
                      : law == Law::kConsistency  ? "consistent columns"
                      : law == Law::kStartPosture ? "start posture"
                      : law == Law::kFrictionCone ? "friction"
                      : law == Law::kFlight       ? "free fall in flight"
                      : law == Law::kDynamics     ? "dynamics"
                                                  : LawName(law);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string SurvivalText(const TrialsResult& trials) {
  return ShareText(trials, trials.survived, trials.different_survived, "survived");
}

std::string PassText(const TrialsResult& trials) {
  return ShareText(trials, trials.passed, trials.different_passed, "also passed every gate");
}

std::string ThresholdText(const Preflight& preflight) {
  const std::string share = fmt::format("a survival rate of at least {:.4g} % (lower end of the 95 % interval)",
                                        100.0 * preflight.least_survival);
  if (preflight.fewest_trials == 0) return "a go requires " + share;
  return fmt::format("a go requires {} different trials and {}", preflight.fewest_trials, share);
}

Result<Preflight> MakePreflight(const RobotModel& model, const MotionPlan& plan, const PreflightInput& input) {
  Preflight preflight;
  preflight.plan_hash = MotionHash(plan);
  preflight.whole_plan_hash = PlanHash(plan);
  preflight.least_survival = input.options.least_survival;
  preflight.fewest_trials = input.options.fewest_trials;
  if (input.trials) {
    if (const auto failure = CheckTrials(model, preflight, *input.trials)) return *failure;
    preflight.trial_conditions = TrialConditions(input.trials->options, input.trials->disturbances);
  }
  AuditOptions options = input.audit;
  options.margins = true;
  const Result<AuditReport> audit = Audit(model, plan, options);
  if (!audit) return audit.failure();
  preflight.robot = model.name;
  preflight.robot_hash = model.hash;
  preflight.program_version = Version();
  preflight.made_by = plan.provenance.made_by + " " + plan.provenance.program_version;
  const std::string parts = PartsText(plan.parts), gaits = GaitNames(plan.parts);
  preflight.motion = parts.empty() ? (gaits.empty() ? "a motion" : gaits) : parts;
  preflight.duration_s = plan.duration_s();
  preflight.mass_kg = model.total_mass_kg;
  preflight.audit = *audit;
  preflight.trials = input.trials;
  preflight.start_measured = input.audit.start.has_value();
  Judge(input, preflight);
  Assume(model, plan, input, preflight);
  return preflight;
}

}  // namespace gaitwright
