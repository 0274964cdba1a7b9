// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library.h"

#include <filesystem>

// Both are relative to the folder of the program, so that no path of the machine that built it is
// part of it.
#ifndef CANDELABRA_INSTALLED_STDLIB
#define CANDELABRA_INSTALLED_STDLIB "../share/candelabra/stdlib"
#endif
#ifndef CANDELABRA_SOURCE_STDLIB
#define CANDELABRA_SOURCE_STDLIB "../stdlib"
#endif

namespace fs = std::filesystem;

std::string own_path() {
    std::error_code failed;
    const fs::path path = fs::read_symlink("/proc/self/exe", failed);
    return failed ? std::string() : path.string();
}

std::optional<std::string> standard_library(const std::string& program, const char* chosen) {
    if (chosen && *chosen) return std::string(chosen);
    if (program.empty()) return std::nullopt;
    for (const char* place : {CANDELABRA_INSTALLED_STDLIB, CANDELABRA_SOURCE_STDLIB}) {
        const fs::path folder = (fs::path(program).parent_path() / place).lexically_normal();
        std::error_code failed;
        if (fs::is_regular_file(folder / "colors.inc", failed)) return folder.string();
    }
    return std::nullopt;
}
