// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/study/tune.h"

namespace gaitwright {

/// A synthetic tuning of a cycle time and a gain: the present values, a better candidate, and one without a plan.
struct MadeUpTuning {
  Study study;
  TuneReport report;
  TuneOptions options;
};

/// Outcome of the held-out test.
enum class MadeUpProof { kBetter, kNoBetter, kNone, kNothingBefore };

MadeUpTuning MakeUpTuning(MadeUpProof proof);

}  // namespace gaitwright
