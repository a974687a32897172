// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/study/tune.h"

namespace gaitwright {

/// A tuning that nobody ran, of a cycle time and a gain: the usual values, a better candidate, and one without a plan.
struct MadeUpTuning {
  Study study;
  TuneReport report;
  TuneOptions options;
};

/// How the held-out test ended.
enum class MadeUpProof { kBetter, kNoBetter, kNone, kNothingBefore };

MadeUpTuning MakeUpTuning(MadeUpProof proof);

}  // namespace gaitwright
