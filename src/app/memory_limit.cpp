// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

std::optional<std::uint64_t> physical_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || size <= 0) return std::nullopt;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
}

std::uint64_t memory_in_use() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    const long size = sysconf(_SC_PAGESIZE);
    if (!(file >> all >> resident) || size <= 0) return 0;
    return resident * static_cast<std::uint64_t>(size);
}

bool may_double(std::uint64_t in_use, std::optional<std::uint64_t> limit) {
    if (!limit) limit = physical_memory();
    return limit && in_use > 0 && in_use <= *limit / 2;
}

void limit_memory(std::uint64_t bytes) {
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_cur);
    setrlimit(RLIMIT_DATA, &limit);
}
