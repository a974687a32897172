// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/gait_sensitivity.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

using Matrix = Eigen::MatrixXd;
using Steps = std::vector<GaitStep>;

constexpr int kGroups = 10;  // of the jackknife
constexpr int kLeastTrials = 2 * kGroups;
constexpr std::size_t kMostTrialsShown = 2000;  // more trials give no more information
constexpr int kRowsPerUnknown = 4;              // number of steps needed per unknown of a response
constexpr double kLeastSpread = 1e-6;           // smallest scaled range of a disturbance that counts as varying
constexpr Eigen::Index kDisturbances = kStepDisturbances.size(), kIndicators = kStepIndicators.size();

/// Scaled disturbances of a step.
Eigen::RowVector3d DisturbanceOf(const GaitStep& step, const GaitScale& scale) {
  const double impulse = scale.mass_kg * std::sqrt(kGravity * scale.leg_length_m);
  return {step.ground_m / scale.leg_length_m, step.push_forward_n_s / impulse, step.push_left_n_s / impulse};
}

/// Scaled indicators of a step that landed.
Eigen::RowVector3d IndicatorOf(const GaitStep& step, const GaitScale& scale) {
  return {step.late_s / scale.step_s, step.forward_m / scale.leg_length_m, step.left_m / scale.leg_length_m};
}

/// Steps that landed, one per row.
struct Table {
  Matrix causes;                   ///< the disturbances of the step, of the previous step, and so on
  Matrix effects;                  ///< its indicators
  std::vector<int> trial, number;  ///< of each row
};

Table TableOf(const std::vector<const Steps*>& trials, const GaitScale& scale, int lags) {
  Table table;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (std::size_t n = 0; n < trials[i]->size(); ++n) {
      if (!(*trials[i])[n].landed) continue;
      table.trial.push_back(static_cast<int>(i));
      table.number.push_back(static_cast<int>(n));
    }
  }
  const auto rows = static_cast<Eigen::Index>(table.trial.size());
  table.causes = Matrix::Zero(rows, kDisturbances * lags);
  table.effects = Matrix::Zero(rows, kIndicators);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Steps& steps = *trials[static_cast<std::size_t>(table.trial[static_cast<std::size_t>(row)])];
    const int number = table.number[static_cast<std::size_t>(row)];
    table.effects.row(row) = IndicatorOf(steps[static_cast<std::size_t>(number)], scale);
    for (int lag = 0; lag < std::min(lags, number + 1); ++lag) {
      table.causes.row(row).segment<kDisturbances>(kDisturbances * lag) =
          DisturbanceOf(steps[static_cast<std::size_t>(number - lag)], scale);
    }
  }
  return table;
}

/// Subtracts the mean of the rows of each group. @return the largest subtracted value.
double TakeOffMeans(const std::vector<int>& group, Matrix& values) {
  const int groups = group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1;
  Matrix means = Matrix::Zero(groups, values.cols());
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(groups);
  for (std::size_t row = 0; row < group.size(); ++row) {
    means.row(group[row]) += values.row(static_cast<Eigen::Index>(row));
    counts[group[row]] += 1.0;
  }
  for (int g = 0; g < groups; ++g) means.row(g) /= std::max(counts[g], 1.0);
  for (std::size_t row = 0; row < group.size(); ++row)
    values.row(static_cast<Eigen::Index>(row)) -= means.row(group[row]);
  return means.size() > 0 ? means.cwiseAbs().maxCoeff() : 0.0;
}

/// Subtracts the mean of each step over the trials, and of each trial over the steps. Alternates until both are zero,
/// because steps that did not land are missing in the table.
void TakeOffBoth(const Table& table, Matrix& values) {
  constexpr int kRounds = 100;
  constexpr double kEnough = 1e-12;
  for (int round = 0; round < kRounds; ++round) {
    const double by_number = TakeOffMeans(table.number, values), by_trial = TakeOffMeans(table.trial, values);
    if (std::max(by_number, by_trial) < kEnough) break;
  }
}

/// Least-squares solution for a table.
struct Fit {
  std::string missing;
  int rows = 0;
  std::array<bool, 3> varied = {};
  std::vector<GaitSensitivity::Response> response;

  double squared() const {
    double sum = 0.0;
    for (const GaitSensitivity::Response& one : response) sum += one.squaredNorm();
    return sum;
  }
};

/// Columns of causes that vary. A disturbance enters with all its lags or with none.
std::vector<Eigen::Index> Varied(const Matrix& causes, int lags, Fit& fit) {
  const double rows = std::max(static_cast<double>(causes.rows()), 1.0);
  std::vector<Eigen::Index> columns;
  for (Eigen::Index d = 0; d < kDisturbances; ++d) {
    fit.varied[static_cast<std::size_t>(d)] = causes.col(d).norm() / std::sqrt(rows) > kLeastSpread;
    for (int lag = 0; fit.varied[static_cast<std::size_t>(d)] && lag < lags; ++lag)
      columns.push_back(kDisturbances * lag + d);
  }
  return columns;
}

Fit FitResponse(const std::vector<const Steps*>& trials, const GaitScale& scale) {
  const int lags = std::min(kStepsAfter + 1, static_cast<int>(trials.front()->size()));
  Table table = TableOf(trials, scale, lags);
  Fit fit;
  fit.rows = static_cast<int>(table.causes.rows());
  TakeOffBoth(table, table.causes);
  TakeOffBoth(table, table.effects);
  const std::vector<Eigen::Index> columns = Varied(table.causes, lags, fit);
  if (columns.empty()) {
    fit.missing = "no sampled disturbance differs between steps; bumps and pushes do";
    return fit;
  }
  const int means = static_cast<int>(trials.size() + trials.front()->size()) - 1;  // number of subtracted means
  const int needed = kRowsPerUnknown * static_cast<int>(columns.size()) + means;
  if (fit.rows < needed) {
    fit.missing = fmt::format("there are {} steps; {} or more are needed", fit.rows, needed);
    return fit;
  }
  const Eigen::ColPivHouseholderQR<Matrix> solver(table.causes(Eigen::all, columns));
  if (solver.rank() < static_cast<Eigen::Index>(columns.size())) {
    fit.missing = "the disturbances of different steps are collinear";
    return fit;
  }
  const Matrix solution = solver.solve(table.effects);
  fit.response.assign(static_cast<std::size_t>(lags), GaitSensitivity::Response::Zero());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto lag = static_cast<std::size_t>(columns[c] / kDisturbances);
    fit.response[lag].col(columns[c] % kDisturbances) = solution.row(static_cast<Eigen::Index>(c)).transpose();
  }
  return fit;
}

/// Solutions without one tenth of the trials each; fewer if one of them does not exist.
std::vector<Fit> LeaveOut(const std::vector<const Steps*>& trials, const GaitScale& scale) {
  std::vector<Fit> fits;
  for (int group = 0; group < kGroups; ++group) {
    std::vector<const Steps*> others;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (static_cast<int>(i % kGroups) != group) others.push_back(trials[i]);
    }
    Fit fit = FitResponse(others, scale);
    if (!fit.missing.empty()) break;
    fits.push_back(std::move(fit));
  }
  return fits;
}

/// The jackknife of the squared norm. Noise adds to all entries of the response, so that the plain estimate is too
/// large.
void SetNorm(const Fit& all, const std::vector<Fit>& without, GaitSensitivity& result) {
  constexpr double kCount = kGroups, kSurely = 2.0;  // standard errors
  double mean = 0.0, spread = 0.0;
  for (const Fit& fit : without) mean += fit.squared() / kCount;
  for (const Fit& fit : without) spread += std::pow(fit.squared() - mean, 2);
  const double squared = kCount * all.squared() - (kCount - 1.0) * mean;
  const double error = std::sqrt((kCount - 1.0) / kCount * spread);
  if (squared <= 0.0 || squared < kSurely * error) {
    result.missing = "it is not statistically significant; more trials or stronger disturbances are needed";
    return;
  }
  result.norm = std::sqrt(squared);
  result.standard_error = 0.5 * error / *result.norm;
  result.response = all.response;
}

}  // namespace

GaitSensitivity EstimateGaitSensitivity(const std::vector<std::vector<GaitStep>>& trials, const GaitScale& scale) {
  GaitSensitivity result;
  std::vector<const Steps*> all;
  for (const Steps& steps : trials) {
    if (all.size() == kMostTrialsShown) break;
    if (steps.size() != trials.front().size())
      throw InvalidArgument(fmt::format("trials have {} and {} steps; they must belong to one plan", steps.size(),
                                        trials.front().size()));
    all.push_back(&steps);
  }
  result.trials = static_cast<int>(all.size());
  if (all.empty() || all.front()->empty() || scale.leg_length_m <= 0.0 || scale.mass_kg <= 0.0 || scale.step_s <= 0.0) {
    result.missing = all.empty() ? "no trial survived" : "the plan has no consecutive steps";
    return result;
  }
  if (result.trials < kLeastTrials) {
    result.missing = fmt::format("{} trials survived; {} or more are needed", result.trials, kLeastTrials);
    return result;
  }
  const Fit fit = FitResponse(all, scale);
  result.steps = fit.rows;
  result.varied = fit.varied;
  result.missing = fit.missing;
  if (!fit.missing.empty()) return result;
  const std::vector<Fit> without = LeaveOut(all, scale);
  if (static_cast<int>(without.size()) < kGroups) {
    result.missing = "too few trials for an estimate; more are needed";
    return result;
  }
  SetNorm(fit, without, result);
  return result;
}

}  // namespace gaitwright
