// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"
#include "kinematics/base/result.h"
#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

/// Weights of some groups over a time.
struct WeightRange {
  double start_s = 0.0, end_s = std::numeric_limits<double>::infinity();  ///< of the file's motion
  std::map<std::string, double> of;                                       ///< by group

  bool operator==(const WeightRange&) const = default;
};

/// How near a repair stays to each part of a motion over time.
///
/// The groups legs, arms, torso, head, base_position and base_orientation are factors of the usual weights; hands is a
/// weight [1/m] on the distance of the ends of the arms, and 0 unless it is given.
struct FollowWeights {
  std::vector<WeightRange> ranges;  ///< of several ranges that give a group at a time, the last one holds
  bool hands_in_base = false;       ///< hands are compared relative to the base instead of in the world

  /// The weight of a group at a time; `otherwise` if no range gives it.
  double Of(const std::string& group, double time_s, double otherwise) const;
  bool operator==(const FollowWeights&) const = default;
};

/// Structure of a file of weights.
DataShape FollowWeightsShape();

/// Reads weights from a YAML text. Failure kBadInput, with the line, for unknown groups, groups that the robot does not
/// have, and times or weights out of range. @param source  name of the file in messages.
Result<FollowWeights> ReadFollowWeights(const RobotModel& model, const std::string& text, const std::string& source);

/// Sets the weights of a problem's knots. @param file_s  by knot: time of the file's motion. Hands are to be where the
/// references of the knots have them.
void SetWeights(const FollowWeights& weights, const std::vector<double>& file_s, BodyProblem& problem);

}  // namespace gaitwright
