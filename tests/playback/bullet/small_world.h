// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/engine/world_options.h"

namespace gaitwright::bullet {

/// A joint that follows another one, with the indices of both.
struct Gear {
  const Joint& joint;
  int follower, leader;
};

/// The first mimic joint of a model that has one.
inline Gear FirstGear(const RobotModel& model) {
  int follower = 0;
  while (!model.joints.at(static_cast<std::size_t>(follower)).is_mimic) ++follower;
  const Joint& joint = model.joints[static_cast<std::size_t>(follower)];
  return {joint, follower, model.dof_joint[static_cast<std::size_t>(joint.dof)]};
}

/// A robot alone in a Bullet world.
template <class Solver>
struct SmallWorld {
  SmallWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q0)
      : ground(terrain, WorldOptions(), Bumps()),
        body(model, {.locked_dofs = {}, .q0 = q0}),
        dispatcher(&configuration),
        solver(body.inertia()),
        world(&dispatcher, &broadphase, &solver, &configuration) {
    world.setGravity(btVector3(0.0, 0.0, -kGravity));
    world.getSolverInfo().m_globalCfm = WorldOptions().contact_cfm;
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    ground.AddTo(world);
    body.AddTo(world);
  }
  ~SmallWorld() {
    while (world.getNumMultiBodyConstraints() > 0) world.removeMultiBodyConstraint(world.getMultiBodyConstraint(0));
    world.removeMultiBody(&body.multibody());
    for (int i = world.getNumCollisionObjects() - 1; i >= 0; --i)
      world.removeCollisionObject(world.getCollisionObjectArray()[i]);
  }

  Ground ground;
  RobotBody body;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  Solver solver;
  btMultiBodyDynamicsWorld world;
};

}  // namespace gaitwright::bullet
