// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playback/trials/robustness_report.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// What trials are made of: a plan, how it is played, and what it is put through. All of it must outlive the study.
struct TrialStudy {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlayRequest& request;
  const Disturbances& disturbances;
};

/// One trial, with all that was measured.
struct PlayedTrial {
  TrialOutcome outcome;
  PlayedWalk played;
};

/// The request as one trial changes it. The sampled delay of commands is rounded to whole time steps.
/// @throws InvalidArgument when a trial sets an option that playback does not have.
PlayRequest DisturbedRequest(const PlayRequest& request, const SampledTrial& trial);

/// The standard set but for what the request, or a study that varies those options, says itself.
Disturbances StandardBesides(const RobotModel& model, const PlayRequest& request,
                             const std::vector<std::string>& varied = {});

/// Why some trial that disturbances can draw could not be played, whatever the plan; nothing where all could. It is a
/// figure that is drawn and set (code `said_twice`); or an option that they put out of its range, by itself or together
/// with what the request says (the noise of a sensor times `sensor_noise_scale`), or a push on nothing: code
/// `disturbances`. @throws InvalidArgument where the request itself
/// has an option out of its range.
std::optional<Failure> WhyNotSampled(const RobotModel& model, const PlayRequest& request,
                                     const Disturbances& disturbances);

/// The same with the plan: a push that may come after its end too (code `late_push`), and all else that Play refuses.
std::optional<Failure> WhyNotTried(const TrialStudy& study);

/// Plays and scores one trial: a pure function of the study and the seed, so that any machine and thread has the same
/// log to the byte. The log says in `options` what was sampled, as "trial.NAME". `number` is for the record only.
/// @return the failure of WhyNotTried: of a study either every trial is played, or none. @throws InvalidArgument for
/// what no disturbance changes, as MakeController and Play do.
Result<PlayedTrial> PlayTrial(const TrialStudy& study, int number, std::uint64_t seed);

/// What a report says of its run.
TrialSubject SubjectOf(const TrialStudy& study, std::uint64_t run_seed);

/// Hash of everything that outcomes depend on: program, robot, plan, options, disturbances, seed of the run.
std::string HashOf(const TrialStudy& study, std::uint64_t run_seed);

/// The fields of sensors that disturbances may name, without "sensors." before them.
OptionFields SensorFields(PlayRequest& request);

}  // namespace gaitwright
