// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

/// Returns freed memory to the system where the C library can do so (glibc). Without it, memory that was freed between
/// stages of a long task stays with the process: in pieces, and in the arena of the thread that used it.
void ReleaseFreedMemory();

}  // namespace gaitwright
