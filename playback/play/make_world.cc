// SPDX-License-Identifier: BSD-3-Clause
#include "playback/play/make_world.h"

#include "kinematics/base/result.h"
#include "playback/bullet/bullet_world.h"
#ifdef GAITWRIGHT_WITH_MUJOCO
#include "playback/mujoco/mujoco_world.h"
#endif

namespace gaitwright {

const std::vector<std::string>& EngineNames() {
#ifdef GAITWRIGHT_WITH_MUJOCO
  static const std::vector<std::string> names = {"bullet", "mujoco"};
#else
  static const std::vector<std::string> names = {"bullet"};
#endif
  return names;
}

std::unique_ptr<World> MakeWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q,
                                 const WorldOptions& options) {
  if (options.engine == "bullet") return std::make_unique<BulletWorld>(model, terrain, q, options);
#ifdef GAITWRIGHT_WITH_MUJOCO
  if (options.engine == "mujoco") return std::make_unique<MujocoWorld>(model, terrain, q, options);
#endif
  if (options.engine == "both")
    throw InvalidArgument("a world has one engine, 'bullet' or 'mujoco'; use 'both' only to play a plan");
  throw InvalidArgument("this program was built without the engine '" + options.engine +
                        "' (Debian: libmujoco-dev; then build again)");
}

}  // namespace gaitwright
