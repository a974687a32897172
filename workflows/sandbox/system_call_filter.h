// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Why this machine cannot filter the system calls of a process (a kernel without seccomp); "" if it can.
std::string ReasonNoCallFilter();

/// Writes the filter of system calls for one process to an open file, for ApplyCallFilter.
///
/// The filter is a list of the calls that Python and NumPy need: files (Landlock decides which), memory, clocks,
/// waiting, limits and signals of the process itself, exec. All other calls fail with EPERM, also calls that newer
/// kernels add. Some calls that the C library tries first fail with ENOSYS, so that it uses older ones, whose arguments
/// a filter can check. Calls of another architecture (32 bit, x32) end the process.
/// @param process  the process that the filter is for; it may send signals only to itself.
/// @return 0, or the system's error number.
int WriteCallFilter(int process, int file);

/// Reads a filter and applies it irrevocably to the calling process, also after exec. Needs PR_SET_NO_NEW_PRIVS. Safe
/// after fork.
/// @return 0, or the system's error number.
int ApplyCallFilter(int file);

}  // namespace gaitwright
