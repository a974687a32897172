// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "playback/engine/world.h"
#include "playback/mujoco/compiled_internal.h"

namespace gaitwright::mujoco {

/// Reads the contacts of a step for feet and for other links.
class Contacts {
 public:
  /// Keeps all arguments by reference.
  Contacts(const RobotModel& model, const Terrain& terrain, const ModelText& text, const mjModel& m, const mjData& d);

  /// @param before, after  kinematics at the start of the step, where contacts were found, and at its end
  void Read(double step_s, const DynamicsScratch& before, const DynamicsScratch& after);

  /// Depth and names of a contact with the ground.
  Penetration PenetrationOf(const mjContact& contact) const;

  const std::vector<FootContact>& feet() const { return feet_; }
  const std::vector<std::string>& body_contacts() const { return body_contacts_; }

 private:
  void Add(int index, const DynamicsScratch& before, const DynamicsScratch& after);

  const RobotModel& model_;
  const Terrain& terrain_;
  const ModelText& text_;
  const mjModel& m_;
  const mjData& d_;
  std::vector<int> part_;   // by geom; -1 for geoms of the ground
  std::vector<int> solid_;  // by geom; -1 for geoms of the robot
  std::vector<FootContact> feet_;
  std::vector<std::string> body_contacts_;
};

}  // namespace gaitwright::mujoco
