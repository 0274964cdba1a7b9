// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

std::optional<std::uint64_t> physical_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || size <= 0) return std::nullopt;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
}

void limit_memory(std::uint64_t bytes) {
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_cur);
    setrlimit(RLIMIT_DATA, &limit);
}
