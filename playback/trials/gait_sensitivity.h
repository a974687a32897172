// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "playback/trials/gait_steps.h"

namespace gaitwright {

/// Disturbances of a step, in the order of the columns of a response. They are divided by the leg length l, and by the
/// impulse m sqrt(g l).
inline constexpr std::array<const char*, 3> kStepDisturbances = {"ground_height", "push_ahead", "push_left"};
/// Indicators of a step, in the order of the rows. They are divided by the mean step time, or by the leg length.
inline constexpr std::array<const char*, 3> kStepIndicators = {"step_time", "foot_ahead", "foot_left"};
/// Number of steps after the disturbed one in the response.
inline constexpr int kStepsAfter = 4;

/// Sensitivity of the steps of a gait to disturbances, estimated over trials.
///
/// The gait is modelled as the linear step-to-step map of Hobbelen and Wisse, with disturbances e and indicators g:
///   g_n = G_0 e_n + G_1 e_(n-1) + ...,   G_0 = D,  G_k = C A^(k-1) B,
///   norm = sqrt(sum over k of |G_k|_F^2),
/// which is their gait sensitivity norm, the H2 norm of this map: less is better. G_0 to G_4 follow by least squares
/// from all steps of all trials, after two means have been subtracted: that of each step over the trials (the gait
/// itself), and that of each trial over its steps (constant effects, such as another mass). Noise makes the estimated
/// norm too large. The jackknife over ten groups of trials corrects its square, and gives the standard error.
///
/// Hobbelen and Wisse, IEEE T-RO 23(6) 2007, doi:10.1109/TRO.2007.904908, for the norm; Efron, Annals of Statistics
/// 7(1) 1979, doi:10.1214/aos/1176344552, for the jackknife.
struct GaitSensitivity {
  using Response = Eigen::Matrix<double, kStepIndicators.size(), kStepDisturbances.size()>;

  std::optional<double> norm = {}, standard_error = {};
  std::string missing = {};             ///< reason for a missing norm; else empty
  int trials = 0, steps = 0;            ///< numbers that the estimate is based on
  std::array<bool, 3> varied = {};      ///< by disturbance: whether it varied between steps
  std::vector<Response> response = {};  ///< G_0, G_1, ...; zero columns for constant disturbances; empty without norm
};

/// @param trials  steps of each surviving trial, the same number in each. @throws InvalidArgument otherwise. The first
/// 2000 trials are used.
/// There is no norm without steps, with fewer than 20 trials, if no disturbance varies between steps, if there are too
/// few steps for the unknowns, or if it is not statistically significant.
GaitSensitivity EstimateGaitSensitivity(const std::vector<std::vector<GaitStep>>& trials, const GaitScale& scale);

}  // namespace gaitwright
