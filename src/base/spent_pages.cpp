// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/spent_pages.h"

#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

void give_back_pages(void* begin, std::size_t bytes) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + page - 1) & ~(page - 1);
    const std::uintptr_t to = (first + bytes) & ~(page - 1);
    if (from < to) madvise(reinterpret_cast<void*>(from), to - from, MADV_DONTNEED);
}
