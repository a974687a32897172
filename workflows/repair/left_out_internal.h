// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// A part of a motion that is left out: the robot stands, and moves from the posture before the part to the one after.
struct LeftOutPart {
  double start_s = 0.0, end_s = 0.0;  ///< of the file's motion, which keeps its times
  Pose moved = Pose::Identity();      ///< by which what follows is moved in plan view, so that feet stay where they are
  std::string why;                    ///< half a sentence
};

/// Leaves out the surroundings of times of a motion: from a time before them at which all feet stand and the base is
/// slow to such a time after them at which the feet stand in the same way. Where there is none, the beginning or the
/// end of the motion is left out. On uneven ground the feet must stand in the same places.
/// @param bad_s  in any order. @param parts  those that are left out, in order; others are added or joined to them.
/// @return false if the robot does not stand before or after these times.
bool LeaveOut(const RobotModel& model, GroundKind ground, const EvenMotion& motion, std::vector<double> bad_s,
              const std::string& why, std::vector<LeftOutPart>& parts);

/// Duration of parts [s].
double DurationOf(const std::vector<LeftOutPart>& parts);

/// Half a sentence about parts that would have to be left out, but are more than is allowed.
std::string LostText(const std::vector<LeftOutPart>& parts, double duration_s);

/// Positions and contacts of a motion without parts of it.
EvenMotion WithoutParts(const EvenMotion& motion, const std::vector<LeftOutPart>& parts);

/// The file's posture at a time within a part, moved as what is before the part; at other times `kept`.
VectorX PostureOfFile(const EvenMotion& motion, const std::vector<LeftOutPart>& parts, double file_s,
                      const VectorX& kept);

}  // namespace gaitwright
