// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "workflows/grade/marks.h"

namespace gaitwright {

/// Marks a part in a forked copy of this process, so that its input cannot stop the marking of a class: if the copy
/// crashes, or takes more CPU time than the part's `judge_s`, the part gets no points, with this reason. Otherwise the
/// mark is the same as without the copy. @pre other threads of the process hold no locks.
PartMark MarkApart(const RubricPart& part, const std::function<PartMark()>& mark);

}  // namespace gaitwright
