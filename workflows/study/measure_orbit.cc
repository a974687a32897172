// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/steady_stretch.h"
#include "workflows/study/measure_orbit_internal.h"

namespace gaitwright {
namespace {

constexpr std::array kPhases = {0.0, 0.25, 0.5, 0.75};  // of the cycle, at which pushes begin
constexpr double kImpulse = 0.01;                       // in units of m sqrt(g l)
constexpr double kPushS = 0.1;                          // [s]
constexpr int kFirstCycle = 2;                          // by then all pushes have ended

std::optional<SteadyStretch> LongestStretch(const MotionPlan& plan) {
  std::optional<SteadyStretch> longest;
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    const std::optional<SteadyStretch> stretch = NearlySteadyStretchOf(plan, part);
    if (stretch && (!longest || stretch->cycles > longest->cycles)) longest = stretch;
  }
  return longest;
}

/// Differences of states at the start of the steady cycles, scaled.
class OrbitReader {
 public:
  OrbitReader(const RobotModel& model, const MotionPlan& plan, const SteadyStretch& stretch)
      : length_m_(model.leg_length_m()), per_joint_(VectorX::Ones(model.num_dofs())) {
    for (const Joint& joint : model.joints) {
      if (joint.dof >= 0 && joint.is_prismatic()) per_joint_[joint.dof] = 1.0 / length_m_;
    }
    WholeBodySample sample;
    for (int k = kFirstCycle; k <= stretch.cycles; ++k) {
      times_s_.push_back(stretch.start_s + k * stretch.cycle_s);
      SampleWholeBody(plan.whole_body, times_s_.back(), sample);
      R_HW_.push_back(RotationExp(Vector3(0.0, 0.0, -YawOf(BaseRotation(sample.q)))));
    }
  }

  /// The samples at the start of each cycle; fewer if the playback ended before.
  std::vector<LogSample> Sections(const PlaybackLog& log) const {
    constexpr double kTiny = 1e-6;  // [s]
    std::vector<LogSample> sections;
    for (const double time_s : times_s_) {
      const auto at = std::lower_bound(log.samples.begin(), log.samples.end(), time_s - kTiny,
                                       [](const LogSample& sample, double t) { return sample.time_s < t; });
      if (at == log.samples.end()) break;
      sections.push_back(*at);
    }
    return sections;
  }

  std::size_t size() const { return times_s_.size(); }

  /// Half the difference of two playbacks in each cycle, in the planned heading.
  CycleDeviations HalfDifference(const std::vector<LogSample>& a, const std::vector<LogSample>& b) const {
    const double speed = std::sqrt(kGravity * length_m_), time = std::sqrt(length_m_ / kGravity);
    CycleDeviations deviations;
    for (std::size_t k = 0; k < size(); ++k) {
      const VectorX q = a[k].q - b[k].q, v = a[k].v - b[k].v;
      const Vector3 turn = RotationLog(BaseRotation(a[k].q) * BaseRotation(b[k].q).transpose());
      const Eigen::Index n = per_joint_.size();
      VectorX state(12 + 2 * n);
      state << R_HW_[k] * q.head<3>() / length_m_, R_HW_[k] * turn, per_joint_.cwiseProduct(q.tail(n)),
          R_HW_[k] * v.head<3>() / speed, R_HW_[k] * v.segment<3>(3) * time, per_joint_.cwiseProduct(v.tail(n)) * time;
      deviations.push_back(0.5 * state);
    }
    return deviations;
  }

 private:
  const double length_m_;
  VectorX per_joint_;
  std::vector<double> times_s_;
  std::vector<Matrix3> R_HW_;  // by cycle, into the planned heading
};

/// The request with one push more, logged at every step of the physics.
PlayRequest Pushed(PlayRequest request, const SteadyStretch& stretch, std::size_t number, double impulse_n_s) {
  constexpr std::size_t kSigns = 2, kAxes = 3;
  const double sign = number % kSigns == 0 ? 1.0 : -1.0;
  const auto axis = static_cast<int>(number / kSigns % kAxes);
  const double phase = kPhases[number / (kSigns * kAxes)];
  if (request.play.world.engine == "both") request.play.world.engine = "bullet";
  request.play.log_rate_hz = 1.0 / request.play.world.step_s;
  request.play.on_phase = {};
  request.play.more_pushes.push_back(
      {sign * impulse_n_s / kPushS * Vector3::Unit(axis), stretch.start_s + phase * stretch.cycle_s, kPushS, "robot"});
  return request;
}

}  // namespace

Result<OrbitStability> MeasureOrbit(const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                    const JobOptions& jobs) {
  OrbitStability orbit;
  const std::optional<SteadyStretch> stretch = LongestStretch(plan);
  if (stretch) {
    orbit.cycle_s = stretch->cycle_s;
    orbit.cycles = stretch->cycles;
  }
  if (orbit.cycles < kLeastOrbitCycles) {
    orbit.missing = fmt::format("the plan repeats its cycle {} times; {} or more are needed, so walk farther",
                                orbit.cycles, kLeastOrbitCycles);
    return orbit;
  }
  const OrbitReader reader(model, plan, *stretch);
  orbit.impulse_n_s = kImpulse * model.total_mass_kg * std::sqrt(kGravity * model.leg_length_m());
  std::vector<std::size_t> order(2 * 3 * kPhases.size());
  std::iota(order.begin(), order.end(), 0);
  orbit.playbacks = static_cast<int>(order.size());
  std::vector<std::vector<LogSample>> sections(order.size());
  std::vector<std::optional<Failure>> failures(order.size());
  const auto play = [&](std::size_t number) {
    const Result<PlayedWalk> played = PlayWalk(model, plan, Pushed(request, *stretch, number, orbit.impulse_n_s));
    played ? void(sections[number] = reader.Sections(played->log)) : void(failures[number] = played.failure());
  };
  if (!RunJobs(order, play, jobs)) return Interrupted("orbit");
  for (const std::optional<Failure>& failure : failures) {
    if (failure) return *failure;
  }
  std::vector<CycleDeviations> deviations;
  for (std::size_t pair = 0; pair < order.size(); pair += 2) {
    const auto &a = sections[pair], &b = sections[pair + 1];
    if (std::min(a.size(), b.size()) < reader.size()) {
      orbit.missing = fmt::format("the robot falls after a push of {:.3g} N s", orbit.impulse_n_s);
      return orbit;
    }
    deviations.push_back(reader.HalfDifference(a, b));
  }
  orbit.multipliers = EstimateMultipliers(deviations);
  if (orbit.multipliers.values.empty()) orbit.missing = "the pushes leave no deviation";
  return orbit;
}

std::string OrbitJson(const OrbitStability& orbit) {
  auto json = nlohmann::ordered_json::object();
  const bool known = orbit.missing.empty();
  json["verdict"] = OrbitVerdictName(orbit.verdict());
  json["largest"] = known ? nlohmann::ordered_json(orbit.multipliers.largest()) : nlohmann::ordered_json();
  json["multipliers"] = nlohmann::ordered_json::array();
  for (const std::complex<double>& value : orbit.multipliers.values)
    json["multipliers"].push_back({value.real(), value.imag()});
  json["unexplained"] = orbit.multipliers.unexplained;
  json["cycle_s"] = orbit.cycle_s;
  json["cycles"] = orbit.cycles;
  json["impulse_n_s"] = orbit.impulse_n_s;
  json["playbacks"] = orbit.playbacks;
  json["missing"] = orbit.missing;
  return json.dump();
}

}  // namespace gaitwright
