// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/preview_zmp.h"

#include <algorithm>
#include <cmath>

#include "optimisation/centroidal/preview_control.h"

namespace gaitwright {
namespace {

/// The ZMP along one axis: adds one preview horizon of standing at both ends, follows, and cuts to the original length.
std::vector<double> Followed(const PreviewSetup& setup, const std::vector<double>& input) {
  const auto padding = static_cast<std::size_t>(std::lround(setup.preview_s / setup.step_s));
  std::vector<double> padded(padding, input.front());
  padded.insert(padded.end(), input.begin(), input.end());
  padded.insert(padded.end(), padding, input.back());
  const std::vector<double> zmp = FollowZmp(setup, padded, input.front()).zmp_m;
  const auto first = zmp.begin() + static_cast<std::ptrdiff_t>(padding);
  return {first, first + static_cast<std::ptrdiff_t>(input.size())};
}

/// By phase boundary: the shift that moves the ZMP there into the supports on both sides; zero at the ends of the plan.
std::vector<Vector2> ShiftsAtBoundaries(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ) {
  const auto& phases = problem.phases;
  std::vector<Vector2> shifts(phases.size() + 1, Vector2::Zero());
  for (std::size_t i = 1; i < phases.size(); ++i) {
    const double t = phases[i].start_s;
    const auto k = static_cast<std::size_t>(std::lround((t - problem.start_s) / problem.step_s));
    const Vector2& p = p_WZ[std::min(k, p_WZ.size() - 1)];
    const Vector2 before = NearestPoint(RegionAt(phases[i - 1], t), p);
    shifts[i] = NearestPoint(RegionAt(phases[i], t), before) - p;
  }
  return shifts;
}

/// Moves each sample into its support. The shifts at the boundaries are spread over the phases, so that the ZMP reaches
/// a support line before the feet beside the line leave.
void HoldInSupports(const ZmpProblem& problem, std::vector<Vector2>& p_WZ) {
  const std::vector<Vector2> shifts = ShiftsAtBoundaries(problem, p_WZ);
  for (std::size_t k = 0; k < p_WZ.size(); ++k) {
    const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
    const std::size_t i = ZmpPhaseAt(problem, t);
    const ZmpPhase& phase = problem.phases[i];
    const double u = std::clamp((t - phase.start_s) / (phase.end_s - phase.start_s), 0.0, 1.0);
    p_WZ[k] = NearestPoint(RegionAt(phase, t), p_WZ[k] + (1.0 - u) * shifts[i] + u * shifts[i + 1]);
  }
}

}  // namespace

std::vector<Vector2> PreviewReference(const ZmpProblem& problem, double preview_s) {
  ZmpPhase head = problem.phases.front(), tail = problem.phases.back();
  const auto rest_s = [preview_s](const ZmpPhase& phase) {
    return std::min(preview_s, (phase.end_s - phase.start_s) * 2.0 / 3.0);
  };
  head.start_s += rest_s(head);
  tail.end_s -= rest_s(tail);
  std::vector<Vector2> reference;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    const std::size_t i = ZmpPhaseAt(problem, t);
    const bool first = i == 0, last = i + 1 == problem.phases.size();
    reference.push_back(PreferredAt(first ? head : last ? tail : problem.phases[i], t));
  }
  return reference;
}

std::vector<Vector2> PreviewZmp(const ZmpProblem& problem, const PreviewChoice& choice) {
  PreviewSetup setup;
  setup.com_height_m = kGravity / (problem.omega_rad_s * problem.omega_rad_s);
  setup.step_s = problem.step_s;
  setup.preview_s = choice.preview_s;
  setup.jerk_weight = choice.jerk_weight;
  const std::vector<Vector2> reference = PreviewReference(problem, choice.preview_s);
  std::vector<Vector2> p_WZ = problem.zmp_offset;
  for (const int axis : {0, 1}) {
    std::vector<double> input;
    for (std::size_t k = 0; k < reference.size(); ++k)
      input.push_back(reference[k][axis] - problem.zmp_offset[k][axis]);
    const std::vector<double> zmp = Followed(setup, input);
    for (std::size_t k = 0; k < zmp.size(); ++k) p_WZ[k][axis] += zmp[k];
  }
  HoldInSupports(problem, p_WZ);
  return p_WZ;
}

}  // namespace gaitwright
