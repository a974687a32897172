// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <mutex>

#include "playback/engine/world.h"
#include "playback/mujoco/compiled_internal.h"

namespace gaitwright::mujoco {
namespace {

[[noreturn]] void ThrowMujocoError(const char* message) { throw EngineRefusal(fmt::format("MuJoCo: {}", message)); }

}  // namespace

ModelPtr Compile(const ModelText& text) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  mju_user_error = [](const char* message) { ThrowMujocoError(message); };  // MuJoCo's default ends the process
  mju_user_warning = [](const char*) {};                                    // MuJoCo's default writes a file
  constexpr const char* kName = "world.xml";
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(text.mjcf.size()));
  std::memcpy(files->filedata[0], text.mjcf.data(), text.mjcf.size());
  char error[1000] = "";
  ModelPtr model(mj_loadXML(kName, files.get(), error, sizeof error));
  mj_deleteVFS(files.get());
  if (!model) ThrowMujocoError(error);
  for (std::size_t i = 0; i < text.fields.size(); ++i)
    std::copy(text.fields[i].heights.begin(), text.fields[i].heights.end(), model->hfield_data + model->hfield_adr[i]);
  return model;
}

int IdOf(const mjModel& m, mjtObj type, const std::string& name) { return mj_name2id(&m, type, name.c_str()); }

}  // namespace gaitwright::mujoco
