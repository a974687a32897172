// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json ValuesJson(const Study& study, const StudyPoint& values) {
  Json json = Json::object();
  for (std::size_t k = 0; k < study.axes.size(); ++k) json[study.axes[k].key] = Json::parse(values[k]);
  return json;
}

Json CandidateJson(const Study& study, const TuneCandidate& candidate, std::size_t number) {
  double score = 0.0;
  int survived = 0;
  for (const TrialWorth& trial : candidate.worth.trials) {
    score += trial.score / static_cast<double>(candidate.worth.trials.size());
    survived += trial.survived ? 1 : 0;
  }
  const bool tried = candidate.value.has_value();
  return {{"candidate", number},
          {"found_by", candidate.found_by},
          {"values", ValuesJson(study, candidate.values)},
          {"value", JsonOrNull(candidate.value)},
          {"score_mean", tried ? Json(score) : Json()},
          {"survived", tried ? Json(survived) : Json()},
          {"refusal", candidate.worth.refusal}};
}

Json DifferenceJson(const PairedDifference& d, bool has_before) {
  const auto compared = [&](double value) { return has_before ? Json(value) : Json(); };
  return {{"before", compared(d.before)},
          {"after", d.after},
          {"difference", compared(d.mean)},
          {"low", compared(d.low)},
          {"high", compared(d.high)}};
}

Json ProofJson(const HeldOutProof& proof) {
  const bool has_before = proof.no_before.empty();
  return {{"trials", proof.trials},
          {"value", DifferenceJson(proof.value, has_before)},
          {"score", DifferenceJson(proof.score, has_before)},
          {"survival", DifferenceJson(proof.survival, has_before)},
          {"no_before", proof.no_before}};
}

Json MetricsJson(const TuneReport& report) {
  Json json = Json::object();
  for (std::size_t k = 0; k < report.metrics.size(); ++k) {
    const auto of = [&](const PointOutcome& o) { return k < o.metrics.size() ? JsonOrNull(o.metrics[k]) : Json(); };
    json[report.metrics[k]] = {{"before", of(report.before)}, {"after", of(report.after)}};
  }
  return json;
}

/// Score of each engine before and after; empty for one engine.
Json UndisturbedJson(const TuneReport& report) {
  Json json = Json::object();
  for (const auto& [key, outcome] : {std::pair{"before", &report.before}, std::pair{"after", &report.after}}) {
    for (const EngineVerdict& v : outcome->engines)
      json[v.engine][key] = {{"verdict", VerdictName(v)}, {"score", v.score}};
  }
  return json;
}

}  // namespace

std::string VerdictOf(const TuneResult& result) {
  if (!result.proof) return "no better: no candidate has a higher value than the present values, which are kept";
  const PairedDifference& d = result.proof->value;
  if (!result.proof->no_before.empty()) {
    return fmt::format(
        "better: the present values have no plan that passes its audit ({}); the best candidate has a value of {:.2f} "
        "on {} held-out trials",
        result.proof->no_before, d.after, result.proof->trials);
  }
  const std::string figures = fmt::format(
      "{:.2f} to {:.2f} on {} held-out trials, difference {:.2f} (95 % interval "
      "{:.2f} to {:.2f})",
      d.before, d.after, result.proof->trials, d.mean, d.low, d.high);
  return result.better() ? "better: " + figures : "no better: " + figures + "; the present values are kept";
}

std::string TuneJson(const Study& study, const TuneReport& report, const TuneOptions& options,
                     const WrittenFiles& files) {
  const TuneResult& result = report.result;
  Json ranges = Json::array(), candidates = Json::array(), written = Json::object(), proof;
  for (const StudyAxis& axis : study.axes)
    ranges.push_back({{"key", axis.key}, {"unit", axis.unit}, {"from", axis.low}, {"to", axis.high}});
  for (std::size_t i = 0; i < result.candidates.size(); ++i)
    candidates.push_back(CandidateJson(study, result.candidates[i], i));
  if (result.proof) proof = ProofJson(*result.proof);
  for (const auto& [kind, path] : files) written[kind] = path;
  const Json json = {{"robot", study.model.name},
                     {"better", result.better()},
                     {"verdict", VerdictOf(result)},
                     {"axes", ranges},
                     {"trials", options.trials},
                     {"survival_weight", options.survival_weight},
                     {"usual", ValuesJson(study, result.candidates.front().values)},
                     {"favourite", CandidateJson(study, result.candidates[result.favourite], result.favourite)},
                     {"options", ValuesJson(study, result.candidates[result.chosen].values)},
                     {"held_out", proof},
                     {"metrics", MetricsJson(report)},
                     {"engines", UndisturbedJson(report)},
                     {"surface_predicted", result.surface ? Json(result.surface->predicted) : Json()},
                     {"finalists", result.finalists},
                     {"candidates", candidates},
                     {"files", written}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string TuneText(const Study& study, const TuneReport& report, const TuneOptions& options) {
  const TuneResult& result = report.result;
  std::size_t refused = 0;
  for (const TuneCandidate& candidate : result.candidates) refused += candidate.value ? 0U : 1U;
  std::string text = fmt::format("{}\n{} candidates, {} of them refused, {} trials each\n", VerdictOf(result),
                                 result.candidates.size(), refused, options.trials);
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    text += fmt::format("  {:<32} {:>10} -> {:>10} {}\n", study.axes[k].key, result.candidates.front().values[k],
                        result.candidates[result.favourite].values[k], study.axes[k].unit);
  }
  if (!report.before.engines.empty()) text += "undisturbed before " + VerdictsText(report.before.engines) + "\n";
  if (!report.after.engines.empty()) text += "undisturbed after  " + VerdictsText(report.after.engines) + "\n";
  if (!result.proof) return text;
  const PairedDifference &score = result.proof->score, &survival = result.proof->survival;
  if (!result.proof->no_before.empty()) {
    return text + fmt::format("held-out score     {:6.2f}\nheld-out survival  {:5.1f} %\n", score.after,
                              100.0 * survival.after);
  }
  text += fmt::format("held-out score     {:6.2f} -> {:6.2f}, difference {:.2f} ({:.2f} to {:.2f})\n", score.before,
                      score.after, score.mean, score.low, score.high);
  text += fmt::format("held-out survival  {:5.1f} % -> {:5.1f} %, difference {:.1f} % ({:.1f} to {:.1f})\n",
                      100.0 * survival.before, 100.0 * survival.after, 100.0 * survival.mean, 100.0 * survival.low,
                      100.0 * survival.high);
  return text;
}

}  // namespace gaitwright
