// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/page_advice.h"

#include "base/pages.h"

#include <cstdint>

#include <sys/mman.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace candelabra {

namespace {

/// MADV_COLLAPSE of Linux 6.1 and later, which older headers do not name.
constexpr int collapse = 25;

/// For the whole pages among the bytes.
void advise(void* begin, std::size_t bytes, std::uintptr_t page, int advice) {
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + page - 1) & ~(page - 1);
    const std::uintptr_t to = (first + bytes) & ~(page - 1);
    if (from < to) madvise(reinterpret_cast<void*>(from), to - from, advice);
}

}  // namespace

void expect_huge_pages(void* begin, std::size_t bytes) {
    advise(begin, bytes, page_block, MADV_HUGEPAGE);
}

void use_huge_pages(void* begin, std::size_t bytes) {
    expect_huge_pages(begin, bytes);
    advise(begin, bytes, page_block, collapse);  // now, and not when there is time
}

void give_back_freed() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace candelabra
