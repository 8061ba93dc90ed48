// SPDX-License-Identifier: GPL-3.0-or-later
// madvise(MADV_HUGEPAGE) on Linux; no effect elsewhere.
#include "core/base/large_pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hepatica {

#ifdef __linux__

namespace {

constexpr std::uintptr_t small_page = 4096;
// Contains a whole large page (2 MiB) at any alignment.
constexpr std::size_t least_bytes = std::size_t{4} << 20;

}  // namespace

void prefer_large_pages(void* begin, std::size_t bytes) {
    if (bytes < least_bytes) return;
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (address + small_page - 1) / small_page * small_page;
    const std::uintptr_t last = (address + bytes) / small_page * small_page;
    // Failure is ignored: a system without large pages refuses.
    static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
}

#else

void prefer_large_pages(void*, std::size_t) {}

#endif

}  // namespace hepatica
