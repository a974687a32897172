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

/// Plays trial `number`, from 0, of a plan: a pure function, to be called from any thread. Trials of one number see the
/// same disturbances whatever the plan. Fails where trials of the plan cannot be played, whatever the number.
using TrialPlayer = std::function<Result<TrialWorth>(const RobotModel& model, const MotionPlan& plan,
                                                     const PlayRequest& request, int number)>;

/// What is varied about which walk, and what is asked of each point.
struct Study {
  RobotModel model;
  WalkRequest walk;
  PlayRequest play;
  std::vector<StudyAxis> axes;
  std::vector<StudyPoint> points;
  std::vector<std::string> metrics;  ///< keys of MetricRules() to be told of each point
  int trials = 0;                    ///< of each point whose plan passes its audit
  TrialPlayer play_trial = {};
};

/// The plans of a study's points. Points between which only the playback differs share one, which is made when the
/// first of them asks and dropped when the last has had it. To be called from any thread.
class StudyPlans {
 public:
  using Shared = std::shared_ptr<const Result<PlannedWalk>>;

  /// @param pending  the points that will ask, each once. The study must outlive this.
  StudyPlans(const Study& study, const std::vector<std::size_t>& pending);

  /// The plan of a point; waits while another thread makes it.
  Shared Take(std::size_t point);
  /// How many plans were made so far.
  int made() const;

 private:
  struct Entry {
    int left = 0;  ///< points that will still ask
    std::shared_future<Shared> plan;
  };

  const Study& study_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  int made_ = 0;
};

/// The values of a point that shape its plan, as one text: points with the same text share their plan.
std::string PlanKey(const std::vector<StudyAxis>& axes, const StudyPoint& point);

/// Plans a point alone. What a caller gets wrong with an option is a failure `invalid_argument` here.
Result<PlannedWalk> PlanPoint(const Study& study, const StudyPoint& point);

/// How a point is played.
PlayRequest PlaybackOf(const Study& study, const StudyPoint& point);

/// Plans, audits, plays and scores one point, and plays its trials. A pure function of the study and the number.
PointOutcome RunPoint(const Study& study, std::size_t point, StudyPlans& plans);

/// An order of points in which those that share a plan follow each other.
std::vector<std::size_t> OrderByPlan(const Study& study, const std::vector<std::size_t>& pending);

}  // namespace gaitwright
