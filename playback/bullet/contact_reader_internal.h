// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <string>
#include <utility>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/engine/world.h"

namespace gaitwright::bullet {

/// Reads contact forces from Bullet's manifolds after a step. The contact points are those at the start of the step.
class ContactReader {
 public:
  ContactReader(const RobotModel& model, const RobotBody& robot, Terrain terrain)
      : model_(model), robot_(robot), terrain_(std::move(terrain)), feet_(model.feet.size()) {}

  /// @param before, after  kinematics at the step's start and end.
  void Read(btDispatcher& dispatcher, double step_s, const DynamicsScratch& before, const DynamicsScratch& after);

  const std::vector<FootContact>& feet() const { return feet_; }
  const std::vector<std::string>& body_contacts() const { return body_contacts_; }

 private:
  struct Point {
    Vector3 p_W, force_W, normal_W;
    double normal_n, distance_m, friction, slide_m;
  };
  void ReadManifold(const btPersistentManifold& manifold, double step_s, const DynamicsScratch& before,
                    const DynamicsScratch& after);
  void AddToFoot(int foot, const Point& point);

  const RobotModel& model_;
  const RobotBody& robot_;
  const Terrain terrain_;
  std::vector<FootContact> feet_;
  std::vector<std::string> body_contacts_;
};

}  // namespace gaitwright::bullet
