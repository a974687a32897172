// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "playback/trials/gait_steps.h"

namespace gaitwright {

/// What disturbs a step, in the order of the columns of a response; each over what scales it: the leg's length, and the
/// impulse m sqrt(g l).
inline constexpr std::array<const char*, 3> kStepDisturbances = {"ground_height", "push_ahead", "push_left"};
/// What is told of a step, in the order of the rows; each over the mean time of a step, or the leg's length.
inline constexpr std::array<const char*, 3> kStepIndicators = {"step_time", "foot_ahead", "foot_left"};
/// So many steps after the disturbed one are looked at.
inline constexpr int kStepsAfter = 4;

/// How much the steps of a gait change by what disturbs them, estimated over trials.
///
/// The gait is taken for the linear map from step to step of Hobbelen and Wisse, with disturbances e and indicators g:
///   g_n = G_0 e_n + G_1 e_(n-1) + ...,   G_0 = D,  G_k = C A^(k-1) B,
///   norm = sqrt(sum over k of |G_k|_F^2),
/// which is their gait sensitivity norm, the H2 norm of that map: less is better. G_0 to G_4 follow by least squares
/// from all steps of all trials, after the mean of each step over the trials (the gait itself) and that of each trial
/// over its steps (what is the same all along, such as another mass) have been taken off. Noise makes the norm of
/// estimates too large; the jackknife over ten groups of trials takes that off its square, and gives the standard
/// error.
///
/// Hobbelen and Wisse, IEEE T-RO 23(6) 2007, doi:10.1109/TRO.2007.904908, for the norm; Efron, Annals of Statistics
/// 7(1) 1979, doi:10.1214/aos/1176344552, for the jackknife.
struct GaitSensitivity {
  using Response = Eigen::Matrix<double, kStepIndicators.size(), kStepDisturbances.size()>;

  std::optional<double> norm = {}, standard_error = {};
  std::string missing = {};             ///< why there is no norm; empty where there is one
  int trials = 0, steps = 0;            ///< from which it was estimated
  std::array<bool, 3> varied = {};      ///< by disturbance: whether it differed from step to step
  std::vector<Response> response = {};  ///< G_0 and on; columns of what did not vary are zero. Empty without a norm
};

/// @param trials  steps of each trial that survived, as many of each. @throws InvalidArgument otherwise. The first 2000
/// are used.
/// There is no norm where there are no steps, fewer than 20 trials, no disturbance that differs from step to step, too
/// few steps for what is to be found, or where it cannot be told from chance.
GaitSensitivity EstimateGaitSensitivity(const std::vector<std::vector<GaitStep>>& trials, const GaitScale& scale);

}  // namespace gaitwright
