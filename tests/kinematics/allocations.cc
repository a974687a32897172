// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/allocations.h"

#include <atomic>
#include <cstddef>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define GAITWRIGHT_COUNTS_ALLOCATIONS 1
#else
#define GAITWRIGHT_COUNTS_ALLOCATIONS 0
#endif

namespace {
std::atomic<long> allocations{0};
}  // namespace

#if GAITWRIGHT_COUNTS_ALLOCATIONS
// The C library lets a program have its own malloc, and keeps its own under these names.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier): not ours to name
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  ++allocations;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace gaitwright {

bool AllocationsAreCounted() { return GAITWRIGHT_COUNTS_ALLOCATIONS != 0; }

long Allocations() { return allocations; }

}  // namespace gaitwright
