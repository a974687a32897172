// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "workflows/grade/marks.h"

namespace gaitwright {

/// Does the marking of a part in a copy of this process, so that what it reads and plays cannot end the marking of a
/// class: where the copy crashes, or takes more processor time than the part's `judge_s`, nothing counts, and the mark
/// says so. The mark is the same as without the copy. Of a process whose other threads hold no locks.
PartMark MarkApart(const RubricPart& part, const std::function<PartMark()>& mark);

}  // namespace gaitwright
