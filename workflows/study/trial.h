// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playback/trials/robustness_report.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// Inputs of trials: a plan, its playback request and the disturbances. All must outlive the study.
struct TrialStudy {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlayRequest& request;
  const Disturbances& disturbances;
};

/// One trial, with all measurements.
struct PlayedTrial {
  TrialOutcome outcome;
  PlayedWalk played;
};

/// The playback request of one trial. The sampled delay of commands is rounded to whole time steps.
/// @throws InvalidArgument if a trial sets an unknown playback option.
PlayRequest DisturbedRequest(const PlayRequest& request, const SampledTrial& trial);

/// The standard set, except for options that the request sets or the study varies.
Disturbances StandardBesides(const RobotModel& model, const PlayRequest& request,
                             const std::vector<std::string>& varied = {});

/// Why some sampled trial could not be played with any plan; nothing if all can. Reasons: a value that is both sampled
/// and set (code `said_twice`); an option that sampling puts out of its range, alone or together with the request
/// (sensor noise times `sensor_noise_scale`), or a push on a link that does not exist: code `disturbances`. @throws
/// InvalidArgument if the request itself has an option out of range.
std::optional<Failure> ReasonNotSampled(const RobotModel& model, const PlayRequest& request,
                                        const Disturbances& disturbances);

/// As above for a given plan. Further reasons: a push that may come after its end (code `late_push`), and everything
/// that Play refuses.
std::optional<Failure> ReasonNotTried(const TrialStudy& study);

/// Plays and scores one trial: a pure function of the study and the seed, so logs are equal to the byte on all machines
/// and threads. The log's `options` contain the sampled values as "trial.NAME". `number` is for the record only.
/// @return the failure of ReasonNotTried: either every trial of a study is played, or none. @throws InvalidArgument for
/// wrong inputs that no disturbance changes, as MakeController and Play do.
Result<PlayedTrial> PlayTrial(const TrialStudy& study, int number, std::uint64_t seed);

/// Description of the run in a report.
TrialSubject SubjectOf(const TrialStudy& study, std::uint64_t run_seed);

/// Hash of everything that affects outcomes: program, robot, plan, options, disturbances, seed of the run.
std::string HashOf(const TrialStudy& study, std::uint64_t run_seed);

/// The sensor fields that disturbances may name, without "sensors." before them.
OptionFields SensorFields(PlayRequest& request);

}  // namespace gaitwright
