// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/library.h"

#include "text/message.h"

#include <filesystem>
#include <string_view>
#include <system_error>

// Both are relative to the folder of the program, so that the program contains no path of the build
// machine.
#ifndef CANDELABRA_INSTALLED_STDLIB
#define CANDELABRA_INSTALLED_STDLIB "../share/candelabra/stdlib"
#endif
#ifndef CANDELABRA_SOURCE_STDLIB
#define CANDELABRA_SOURCE_STDLIB "../stdlib"
#endif

namespace candelabra {

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

std::optional<std::string> settings_file(const char* chosen, const char* home) {
    if (chosen) return *chosen ? std::optional<std::string>(chosen) : std::nullopt;
    std::vector<std::string> places;
    if (home && *home) places.push_back(std::string(home) + "/.config/candelabra/candelabra.ini");
    places.push_back("/etc/candelabra/candelabra.ini");
    std::error_code none;
    for (const std::string& place : places)
        if (fs::is_regular_file(place, none)) return place;
    return std::nullopt;
}

std::vector<std::string> named_libraries(const char* chosen) {
    std::vector<std::string> folders;
    for (std::string_view left = chosen ? chosen : ""; !left.empty();) {
        const std::string_view folder = left.substr(0, left.find(':'));
        if (!folder.empty()) folders.emplace_back(folder);
        left.remove_prefix(std::min(folder.size() + 1, left.size()));
    }
    return folders;
}

std::string installed_povray_library() {
    for (const std::string_view root : {"/usr/share", "/usr/local/share"})
        for (const std::string_view version : {"3.8", "3.7"}) {
            std::string folder = message(root, "/povray-", version, "/include");
            std::error_code none;
            if (fs::is_directory(folder, none)) return folder;
        }
    return {};
}

}  // namespace candelabra
