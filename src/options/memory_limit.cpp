// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string_view>

namespace candelabra {

std::optional<std::uint64_t> physical_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || size <= 0) return std::nullopt;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
}

namespace {

/// Reads a file that holds one number. Returns nothing for "max" and for a missing file.
std::optional<std::uint64_t> number_in(const std::string& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt;
}

/// Returns the number after a word at the start of a line, or 0.
std::uint64_t number_behind(std::string_view word, const std::string& path) {
    std::ifstream file(path);
    std::string first;
    std::uint64_t number = 0;
    for (std::string line; std::getline(file, line);)
        if (std::istringstream words(line); words >> first >> number && first == word)
            return number;
    return 0;
}

/// Reduces `free` to the bytes left in a control group. The page cache does not count, since it can
/// be reclaimed.
void take_group(const std::string& folder, const char* most, const char* now, const char* files,
                std::optional<std::uint64_t>& free) {
    const auto limit = number_in(folder + most);
    if (!limit) return;
    const std::uint64_t used = number_in(folder + now).value_or(0);
    const std::uint64_t kept = used - std::min(used, number_behind(files, folder + "memory.stat"));
    const std::uint64_t left = *limit - std::min(*limit, kept);
    free = std::min(free.value_or(left), left);
}

/// Reduces `free` by the limits of the process's control groups and of their ancestors.
void take_groups(const std::string& root, std::optional<std::uint64_t>& free) {
    std::ifstream file(root + "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == line.npos) continue;
        const bool old = line.substr(first, second - first).find("memory") != line.npos;
        if (!old && second != first + 1) continue;
        std::string group = line.substr(second + 1);
        for (;; group.erase(group.rfind('/'))) {
            while (group.ends_with('/')) group.pop_back();
            const std::string folder =
                root + "sys/fs/cgroup" + (old ? "/memory" : "") + group + "/";
            if (old)
                take_group(folder, "memory.limit_in_bytes", "memory.usage_in_bytes", "total_cache",
                           free);
            else
                take_group(folder, "memory.max", "memory.current", "file", free);
            if (group.empty()) break;
        }
    }
}

}  // namespace

std::optional<std::uint64_t> usual_memory_limit(const std::string& root) {
    constexpr std::uint64_t kilobyte = 1024;
    std::optional<std::uint64_t> free;
    if (const std::uint64_t available = number_behind("MemAvailable:", root + "proc/meminfo"))
        free = available * kilobyte;
    take_groups(root, free);
    return free ? std::optional(*free / 2) : std::nullopt;
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

}  // namespace candelabra
