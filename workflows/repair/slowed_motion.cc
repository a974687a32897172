// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"
#include "workflows/repair/slowed_motion_internal.h"

namespace gaitwright {
namespace {

constexpr double kRamp = 0.4;    // [s] of the file's motion, over which the pace changes
constexpr double kAround = 0.4;  // [s] of the file's motion, on either side of a bad time

/// Time that the new motion takes for a unit of the file's time.
double PaceAt(const std::vector<SlowedPart>& parts, double file_s) {
  double pace = 1.0;
  for (const SlowedPart& part : parts) {
    const double outside = std::max({0.0, part.start_s - file_s, file_s - part.end_s});
    if (outside >= kRamp) continue;
    pace = std::max(pace, 1.0 + (part.factor - 1.0) * (1.0 - SmoothStep(outside / kRamp).value));
  }
  return pace;
}

/// The file's time after one step of the new time, by the classical Runge-Kutta method.
double NextFileTime(const std::vector<SlowedPart>& parts, double file_s, double step_s) {
  const double a = 1.0 / PaceAt(parts, file_s), b = 1.0 / PaceAt(parts, file_s + 0.5 * step_s * a),
               c = 1.0 / PaceAt(parts, file_s + 0.5 * step_s * b), d = 1.0 / PaceAt(parts, file_s + step_s * c);
  return file_s + step_s / 6.0 * (a + 2.0 * b + 2.0 * c + d);
}

}  // namespace

SlowedMotion WithSlowParts(const EvenMotion& motion, const std::vector<FootSet>& stance,
                           const std::vector<SlowedPart>& parts) {
  SlowedMotion slowed;
  slowed.motion.step_s = motion.step_s;
  const WholeBodyTrajectory of_file{0.0, motion.step_s, motion.q, motion.v, motion.a, {}, {}};
  constexpr double kSame = 1e-6;  // of a step
  const double end_s = motion.TimeOf(motion.size() - 1);
  const auto last = static_cast<long>(motion.q.size()) - 1;
  WholeBodySample sample;
  for (double file_s = 0.0;; file_s = NextFileTime(parts, file_s, motion.step_s)) {
    if (file_s > end_s - kSame * motion.step_s) file_s = end_s;
    SampleWholeBody(of_file, file_s, sample);
    slowed.motion.q.push_back(sample.q);
    slowed.file_s.push_back(file_s);
    slowed.stance.push_back(
        stance[static_cast<std::size_t>(std::clamp(std::lround(file_s / motion.step_s), 0L, last))]);
    if (file_s >= end_s) break;
  }
  return slowed;
}

bool SlowDown(std::vector<double> bad_s, double most, const std::string& why, std::vector<SlowedPart>& parts) {
  constexpr double kSteps = 3.0, kLittle = 1e-6, kWider = 0.1;  // [1], [s]
  std::sort(bad_s.begin(), bad_s.end());
  std::vector<SlowedPart> asked;
  for (const double at_s : bad_s) {
    if (asked.empty() || at_s - kAround > asked.back().end_s + kRamp) asked.push_back({at_s - kAround, 0.0, 1.0, why});
    asked.back().end_s = at_s + kAround;
  }
  bool changed = false;
  for (SlowedPart& part : asked) {
    double factor = 1.0, known_s = 0.0;
    for (std::size_t i = 0; i < parts.size();) {
      if (parts[i].start_s > part.end_s || parts[i].end_s < part.start_s) {
        ++i;
        continue;
      }
      factor = std::max(factor, parts[i].factor);
      known_s += parts[i].end_s - parts[i].start_s;
      part.start_s = std::min(part.start_s, parts[i].start_s);
      part.end_s = std::max(part.end_s, parts[i].end_s);
      part.why = parts[i].why;
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
    }
    part.factor = std::min(most, factor * std::pow(most, 1.0 / kSteps));
    changed |= part.factor > factor + kLittle || part.end_s - part.start_s > known_s + kWider;
    parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.start_s < b.start_s; });
  return changed;
}

}  // namespace gaitwright
