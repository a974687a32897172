// SPDX-License-Identifier: BSD-3-Clause
// GAITWRIGHT_SANITIZED is defined where a sanitizer has malloc, and much of the address space, for itself.
#pragma once

// GCC says by macros what it sanitizes, clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GAITWRIGHT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GAITWRIGHT_SANITIZED 1
#endif
#endif
