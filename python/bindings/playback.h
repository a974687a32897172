// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "playback/score/motion_series.h"
#include "playback/trials/disturbances.h"
#include "python/bindings/plan.h"
#include "workflows/walk/walk.h"

namespace gaitwright::python {

/// A playback: the plan, the measurements and their score. It never changes.
class Playback {
 public:
  Playback(std::shared_ptr<const Plan> plan, PlayedWalk played)
      : plan_(std::move(plan)), played_(std::make_shared<const PlayedWalk>(std::move(played))) {}

  const Plan& plan() const { return *plan_; }
  const std::shared_ptr<const Plan>& shared_plan() const { return plan_; }
  const PlaybackLog& log() const { return played_->log; }
  const StabilityReport& report() const { return played_->report; }
  const PlayedWalk& played() const { return *played_; }
  const Tables& tables() const { return tables_; }
  /// Made on first use, with the options of the score.
  const MotionSeries& series() const;

 private:
  std::shared_ptr<const Plan> plan_;
  std::shared_ptr<const PlayedWalk> played_;
  Tables tables_;
  mutable std::shared_ptr<const MotionSeries> series_;
};

/// Reads disturbances: "standard", the path of a YAML file, the text of one, or a dictionary with its content
/// (docs/trials.md).
/// @throws FailureError as LoadDisturbances does, type_error for anything else.
Disturbances DisturbancesOf(const pybind11::object& which, const RobotModel& model, PlayRequest& request);

/// Balance, feet and contacts of the samples.
void BindBalance(pybind11::class_<Playback>& playback);

}  // namespace gaitwright::python
