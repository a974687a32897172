// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// Verdict of one engine on a plan.
struct EngineVerdict {
  std::string engine;  ///< name: "bullet", "mujoco"
  bool pass = false, fell = false;
  double score = 0.0;
  std::string cause;  ///< as in StabilityReport::cause

  bool operator==(const EngineVerdict&) const = default;
};

/// The verdicts of a plan that was played in two engines; empty for one engine.
std::vector<EngineVerdict> VerdictsOf(const PlayedWalk& played);

/// "pass", "fail" or "fell".
std::string VerdictName(const EngineVerdict& verdict);
/// The name and the score: "pass, 91.2".
std::string VerdictText(const EngineVerdict& verdict);
/// The verdicts in one line: "Bullet: pass, 91.2; MuJoCo: fell, 40.1".
std::string VerdictsText(const std::vector<EngineVerdict>& verdicts);

}  // namespace gaitwright
