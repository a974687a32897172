// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Why this machine cannot filter the system calls of a process (a kernel without seccomp); "" where it can.
std::string WhyNoCallFilter();

/// Writes the filter of system calls for one process to an open file, for ApplyCallFilter.
///
/// The filter is a list of what Python and NumPy need: files (Landlock decides which), memory, clocks, waiting, limits
/// and signals of the process itself, exec. Any other call fails with EPERM, whatever a newer kernel adds. Some calls
/// that the C library tries first fail with ENOSYS, so that it takes older ones, whose arguments a filter can see.
/// Calls of another architecture (32 bit, x32) end the process.
/// @param process  the process that the filter is for: it may send signals to itself alone.
/// @return 0, or the number of the system's error.
int WriteCallFilter(int process, int file);

/// Reads a filter and applies it to the calling process, for good and for all that it becomes by exec. Needs
/// PR_SET_NO_NEW_PRIVS. Safe after fork.
/// @return 0, or the number of the system's error.
int ApplyCallFilter(int file);

}  // namespace gaitwright
