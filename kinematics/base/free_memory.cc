// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "kinematics/base/free_memory_internal.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gaitwright {

void ReleaseFreedMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace gaitwright
