// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Why this machine cannot filter the system calls of a process (another processor than x86-64 and AArch64, a kernel
/// without seccomp); "" where it can.
std::string WhyNoCallFilter();

/// Takes from the calling process, for good and for all that it becomes by exec, the system calls by which it could
/// reach beyond itself: starting processes and threads, sockets, signals to others, memory and limits of others,
/// owners, modes, times and attributes of files, mounts and namespaces, memory that outlives it or is not counted
/// (System V, memfd), io_uring, tracing, and whatever is the administrator's. They fail with EPERM, or ENOSYS where
/// libraries then take another way. Needs PR_SET_NO_NEW_PRIVS. Calls nothing that is not safe after fork.
/// @return 0, or the number of the system's error.
int FilterSystemCalls();

}  // namespace gaitwright
