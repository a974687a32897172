// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "workflows/study/point_outcome.h"
#include "workflows/study/study_axes.h"

namespace gaitwright {

/// One randomised playback of a plan.
struct TrialWorth {
  double score = 0.0;
  bool survived = false;

  bool operator==(const TrialWorth&) const = default;
};

/// Plays trial `number`, from 0, of a plan: a pure, thread-safe function. Trials with equal numbers have equal
/// disturbances for all plans. Fails if trials of the plan cannot be played, for any number.
using TrialPlayer = std::function<Result<TrialWorth>(const RobotModel& model, const MotionPlan& plan,
                                                     const PlayRequest& request, int number)>;

/// The walk, its varied options, and the quantities to report for each point.
struct Study {
  RobotModel model;
  WalkRequest walk;
  PlayRequest play;
  std::vector<StudyAxis> axes;
  std::vector<StudyPoint> points;
  std::vector<std::string> metrics;  ///< keys of MetricRules() to report for each point
  int trials = 0;                    ///< number of trials for each point whose plan passes its audit
  TrialPlayer play_trial = {};
};

/// The plans of a study's points. Points that differ only in the playback share one plan, which is made on the first
/// request and dropped after the last. Thread-safe.
class StudyPlans {
 public:
  using Shared = std::shared_ptr<const Result<PlannedWalk>>;

  /// @param pending  the points that will request a plan, each once. The study must outlive this object.
  StudyPlans(const Study& study, const std::vector<std::size_t>& pending);

  /// The plan of a point; waits while another thread makes it.
  Shared Take(std::size_t point);
  /// Number of plans made so far.
  int made() const;

 private:
  struct Entry {
    int left = 0;  ///< points that have not requested it yet
    std::shared_future<Shared> plan;
  };

  const Study& study_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  int made_ = 0;
};

/// The values of a point that shape its plan, as one text: points with the same text share their plan.
std::string PlanKey(const std::vector<StudyAxis>& axes, const StudyPoint& point);

/// Plans a point without playing it. A wrong option gives the failure `invalid_argument`.
Result<PlannedWalk> PlanPoint(const Study& study, const StudyPoint& point);

/// Playback request of a point.
PlayRequest PlaybackOf(const Study& study, const StudyPoint& point);

/// Plans, audits, plays and scores one point, and plays its trials. A pure function of the study and the number.
PointOutcome RunPoint(const Study& study, std::size_t point, StudyPlans& plans);

/// An order of points in which points that share a plan are consecutive.
std::vector<std::size_t> OrderByPlan(const Study& study, const std::vector<std::size_t>& pending);

}  // namespace gaitwright
