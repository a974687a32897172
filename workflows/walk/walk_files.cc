// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/walk_files.h"

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "planning/gait/read_sequence.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {

std::vector<std::string> FilesOf(const WalkRequest& request) {
  std::vector<std::string> files = {BuiltInGaitsFile()};
  const auto add = [&](const std::string& file) {
    if (!file.empty()) files.push_back(file);
  };
  add(GaitFileOf(request.gait));
  add(SequenceFileOf(request.sequence));
  if (!request.sequence.empty()) {
    const Result<std::vector<AskedPart>> parts = ReadSequence(request.sequence);
    for (const AskedPart& part : parts ? *parts : std::vector<AskedPart>()) add(GaitFileOf(part.gait));
  }
  for (const std::string& file : TerrainFilesOf(request.terrain)) add(file);
  return files;
}

std::string ContentsHash(const WalkRequest& request) {
  std::string text;
  for (const std::string& file : FilesOf(request)) {
    const Result<std::string> bytes = ReadBytes(file);
    text += (bytes ? HexHash(*bytes) : FailureCodeName(bytes.failure().code)) + "\n";
  }
  return HexHash(text);
}

}  // namespace gaitwright
