// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/allocations.h"

#include <atomic>
#include <cstddef>

#include "tests/sanitized.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

#ifdef GAITWRIGHT_SANITIZED
// With the sanitizer, malloc cannot be replaced, but hooks report each call (sanitizer/allocator_interface.h).
extern "C" int __sanitizer_install_malloc_and_free_hooks(  // NOLINT(bugprone-reserved-identifier): not ours to name
    void (*on_malloc)(const volatile void*, std::size_t), void (*on_free)(const volatile void*));

namespace {
[[maybe_unused]] const int hooked = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});
}  // namespace
#else
// A program may replace the malloc of the C library; the original functions have these names.
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

long Allocations() { return allocations; }

}  // namespace gaitwright
