// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/huge_pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace {

/// MADV_COLLAPSE of Linux 6.1 and later, which older headers do not name.
constexpr int collapse = 25;

}  // namespace

void use_huge_pages(const void* begin, std::size_t bytes) {
    constexpr std::uintptr_t huge = std::uintptr_t{1} << 21;
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + huge - 1) & ~(huge - 1);
    const std::uintptr_t to = (first + bytes) & ~(huge - 1);
    if (from >= to) return;
    auto* const pages = reinterpret_cast<void*>(from);
    madvise(pages, to - from, MADV_HUGEPAGE);
    madvise(pages, to - from, collapse);  // now, and not when there is time
}
