// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "planning/plan/sample_plan.h"
#include "workflows/repair/bad_times_internal.h"

namespace gaitwright {
namespace {

constexpr double kApart = 0.1;  // [s] between times of one stretch

/// Times of the file's motion for times of the plan.
class FileTimes {
 public:
  FileTimes(const RestedMotion& rested, BadTimes& bad) : rested_(rested), bad_(bad) {}

  void Add(double plan_s) {
    const double last = static_cast<double>(rested_.file_s.size()) - 1.0;
    const double row = std::clamp(std::round(plan_s / rested_.motion.step_s), 0.0, last);
    bad_.file_s.push_back(rested_.file_s[static_cast<std::size_t>(row)]);
  }
  /// All times between two.
  void Add(double from_s, double to_s) {
    for (double at_s = from_s; at_s <= to_s; at_s += kApart) Add(at_s);
  }

 private:
  const RestedMotion& rested_;
  BadTimes& bad_;
};

void AddFar(const RepairOptions& options, const MotionFindings& findings, const MotionPlan& plan, FileTimes& times) {
  const EvenMotion& clean = findings.clean.motion;
  const int step = std::max(1, static_cast<int>(std::lround(kApart / clean.step_s)));
  WholeBodySample sample;
  for (int k = 0; k < clean.size(); k += step) {
    SampleWholeBody(plan.whole_body, clean.TimeOf(k), sample);
    const VectorX& q = clean.q[static_cast<std::size_t>(k)];
    const auto joints = static_cast<double>(q.size() - 7);
    if ((sample.q - q).tail(q.size() - 7).norm() / std::sqrt(joints) > options.stretch_over_rad)
      times.Add(clean.TimeOf(k));
  }
}

}  // namespace

BadTimes BadTimesOf(const RepairOptions& options, const MotionFindings& findings,
                    const Result<RepairedMotion>& repaired, const FollowReport& report, const PlanProof& proof) {
  BadTimes bad;
  FileTimes times(findings.rested, bad);
  if (!repaired) {
    for (const double at_s : report.unmet_s) times.Add(at_s);
    bad.why = "no motion was found there";
    return bad;
  }
  for (const Violation& violation : repaired->after.violations) times.Add(violation.at_s);
  for (const BrokenTime& broken : repaired->broken) {
    for (const double start_s : broken.worst_s) times.Add(start_s + 0.5);
  }
  bad.why = "the plan failed its audit there";
  if (!bad.file_s.empty()) return bad;
  AddFar(options, findings, repaired->plan, times);
  bad.why = "the robot could not keep to the motion there";
  bad.is_far = !bad.file_s.empty();
  if (bad.is_far || !proof) return bad;
  bad.played = true;
  const PlayProof played = proof(repaired->plan);
  constexpr double kBefore = 1.0;  // [s] in which the cause of a fall is
  if (!played.stands && played.fell_s) times.Add(std::max(0.0, *played.fell_s - kBefore), *played.fell_s);
  bad.why = "the robot fell there";
  return bad;
}

}  // namespace gaitwright
