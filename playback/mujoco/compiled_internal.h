// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "kinematics/spatial/pose.h"
#include "playback/mjcf/model_text_internal.h"

namespace gaitwright::mujoco {

struct DeleteModel {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
struct DeleteData {
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using ModelPtr = std::unique_ptr<mjModel, DeleteModel>;
using DataPtr = std::unique_ptr<mjData, DeleteData>;

/// Compiles a text to MuJoCo's model. Only one thread compiles at a time, because MuJoCo's compiler has global state.
/// @throws InvalidArgument with MuJoCo's message if it refuses the text.
ModelPtr Compile(const ModelText& text);

/// MuJoCo's index of an object with a name.
int IdOf(const mjModel& m, mjtObj type, const std::string& name);

inline Eigen::Map<const Vector3> AsVector(const mjtNum* p) { return Eigen::Map<const Vector3>(p); }

}  // namespace gaitwright::mujoco
