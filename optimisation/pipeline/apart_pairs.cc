// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/apart_pairs_internal.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kTouches = 0.25;   // of the margin
constexpr double kClose = 0.02;     // [m] beyond the margin at which a pair that touches elsewhere is listed
constexpr double kAround = 0.03;    // [s] to either side of times at which a pair is close
constexpr double kToMargin = 0.3;   // [s] from a posture that is pinned to the margin
constexpr double kMoreRoom = 5e-4;  // [m] by which a distance grows that is not kept between knots, and what is missing

}  // namespace

ApartPairs::ApartPairs(const RobotModel& model, double margin_m, FixedSolids ground)
    : model_(model), margin_m_(margin_m), distances_(model, std::move(ground)), scratch_(model) {
  if (!(margin_m > 0.0)) throw InvalidArgument("ApartPairs: the margin must be positive");
}

std::map<int, double> ApartPairs::Touching(const WholeBodyTrajectory& motion, double step_s) {
  std::map<int, double> least_m;
  WholeBodySample sample;
  const int samples = static_cast<int>(std::floor((motion.end_s() - motion.start_s) / step_s + 1e-9));
  for (int i = 0; i <= samples; ++i) {
    SampleWholeBody(motion, motion.start_s + i * step_s, sample);
    ForwardKinematics(model_, sample.q, scratch_);
    for (const NearPair& near : distances_.Near(scratch_, kTouches * margin_m_)) {
      if (near.distance_m >= kTouches * MarginOf(near.pair)) continue;
      double& least = least_m.try_emplace(near.pair, near.distance_m).first->second;
      least = std::min(least, near.distance_m);
    }
  }
  return least_m;
}

/// Whether a pair is close at a time or shortly before or after it, by time.
std::vector<bool> ApartPairs::CloseAt(int pair, const WholeBodyTrajectory& motion, const std::vector<double>& times_s) {
  std::vector<bool> close(times_s.size(), false);
  WholeBodySample sample;
  std::size_t first = 0;
  for (std::size_t k = 0; k < times_s.size(); ++k) {
    SampleWholeBody(motion, times_s[k], sample);
    ForwardKinematics(model_, sample.q, scratch_);
    if (distances_.At(pair, scratch_).distance_m >= margin_m_ + kClose) continue;
    while (times_s[first] < times_s[k] - kAround) ++first;
    for (std::size_t i = first; i < times_s.size() && times_s[i] <= times_s[k] + kAround; ++i) close[i] = true;
  }
  return close;
}

/// The distance that a pair is to keep at a time.
double ApartPairs::RampedMargin(int pair, const BodyProblem& problem, double time_s) {
  const double wanted_m = wanted_m_[pair];
  const BodyKnot& first = problem.knots.front();
  if (!first.pins_place || time_s > problem.start_s() + kToMargin) return wanted_m;
  ChartedState state;
  StateOf(problem.chart, first.reference, state);
  ForwardKinematics(model_, state.q, scratch_);
  const double pinned_m = distances_.At(pair, scratch_).distance_m;
  return std::min(wanted_m, pinned_m + (wanted_m - pinned_m) * (time_s - problem.start_s()) / kToMargin);
}

/// @return whether the pair was new at any knot.
bool ApartPairs::ListAt(int pair, const std::vector<bool>& close, BodyProblem& problem) {
  bool is_new = false;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    std::vector<ApartPair>& apart = problem.knots[k].apart;
    const auto listed = std::find_if(apart.begin(), apart.end(), [&](const ApartPair& a) { return a.pair == pair; });
    const double least_m = RampedMargin(pair, problem, problem.time_s[k]);
    if (listed != apart.end()) {
      listed->least_m = least_m;
    } else if (close[k]) {
      apart.push_back({pair, least_m});
      is_new = true;
    }
  }
  return is_new;
}

bool ApartPairs::Watch(const WholeBodyTrajectory& motion, BodyProblem& problem, double step_s) {
  problem.distances = &distances_;
  const std::map<int, double> touching = Touching(motion, step_s);
  for (const auto& touch : touching) wanted_m_.try_emplace(touch.first, MarginOf(touch.first));
  for (auto& wanted : wanted_m_) {
    const std::vector<bool> close = CloseAt(wanted.first, motion, problem.time_s);
    const auto touch = touching.find(wanted.first);
    if (ListAt(wanted.first, close, problem) || touch == touching.end()) continue;
    wanted.second += kTouches * MarginOf(wanted.first) - touch->second + kMoreRoom;
    ListAt(wanted.first, close, problem);
  }
  return !touching.empty();
}

void ApartPairs::Clear(BodyProblem& problem) {
  for (BodyKnot& knot : problem.knots) knot.apart.clear();
  problem.distances = nullptr;
}

std::vector<std::string> ApartPairs::Listed() const {
  std::vector<std::string> names;
  for (const auto& pair : wanted_m_) names.push_back(distances_.NameOf(pair.first));
  return names;
}

}  // namespace gaitwright
